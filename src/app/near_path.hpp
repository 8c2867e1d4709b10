// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

namespace meander {

/// "; did you mean 'examples/first_run.lua'?" for a script path that does not exist, or an empty text. Looks at every
/// part of the path for the nearest name in the folder reached so far, with and without ".lua".
std::string near_path_hint(const std::string& path);

}  // namespace meander
