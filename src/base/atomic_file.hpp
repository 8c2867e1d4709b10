// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>

namespace meander {

/// Writes a whole file so that at every moment, even after a crash or a full disk, the path holds either all of the old
/// content or all of the new: temporary file in the same folder, fsync, rename, fsync of the folder. The mode of an
/// existing file is kept, a symbolic link is followed (also to a file that does not
/// exist yet), and a device or pipe is written to directly. Throws FileError
/// "path: cannot be written: reason"; nothing is left behind then.
void write_file_atomically(const std::string& path, std::string_view text);

/// Throws the same FileError where it is plain that the file could not be written: before work whose result it is to
/// hold.
void check_writable(const std::string& path);

}  // namespace meander
