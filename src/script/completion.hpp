// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <lua.h>

namespace meander::script {

/// What may stand in place of the last word of a line.
struct Completion {
  std::size_t start = 0;             ///< where that word begins
  std::vector<std::string> words{};  ///< sorted, without duplicates
  bool file_name = false;            ///< the word is inside quotes: file names may follow
};

/// Completes the end of `text` from the live names of a state and its documentation records, by raw access only: no
/// metamethod runs.
Completion complete(lua_State* L, std::string_view text);

}  // namespace meander::script
