// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>

namespace meander {

/// Refuses TOML with a key of more than 64 parts ("a.a.a..."): each part is a table in the one before it, and the
/// library walks them by recursion until the stack is used up. Throws FileError "path:line: ...".
void check_key_depth(std::string_view text, const std::string& path);

}  // namespace meander
