// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace meander::script {

/// The suffixes that the text on an argument tells: ".svg or .png" are two.
std::vector<std::string> suffixes_in(std::string_view text);

/// The files with one of the suffixes and the folders, here and in the data folder, whose names begin with `start`.
std::vector<std::string> files_with(const std::vector<std::string>& suffixes, const std::string& start);

}  // namespace meander::script
