// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

namespace meander {

/// Makes a folder and those above it that are missing; nothing happens when it is there. Throws FileError
/// "path: cannot be made: reason".
void make_folder(const std::string& path);

}  // namespace meander
