// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <string>

namespace meander {

/// The whole content of a file of at most `most` bytes. Throws FileError "path: no such file; did you mean 'other'?",
/// "path: is a folder", "path: cannot be read: reason" or "path: larger than the allowed N MB".
std::string read_text_file(const std::string& path, std::size_t most);

}  // namespace meander
