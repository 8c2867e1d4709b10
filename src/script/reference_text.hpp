// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "script/docs.hpp"

namespace meander::script {

/// The reference page in Markdown: an entry for every name, module by module, then the objects, then the globals.
std::string reference_text(const Docs& docs);

}  // namespace meander::script
