// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <string_view>

namespace meander::script {

struct EmbeddedModule {
  std::string_view name;  ///< "meander.json"
  std::string_view text;
};

/// The Lua modules packed into the program when it was built.
std::span<const EmbeddedModule> embedded_modules();

}  // namespace meander::script
