// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

namespace meander {

/// The test files that the paths name: files as they are, folders by all *_test.lua in them and below, sorted, hidden
/// folders left out. Each file once. Throws FileError for a path that is not there.
std::vector<std::string> test_files(const std::vector<std::string>& paths);

/// Throws FileError where one of the paths leads out of the folder of a sandbox: its tests could read nothing there.
/// What came with the program may be read.
void check_inside(const std::vector<std::string>& paths, const std::string& folder);

}  // namespace meander
