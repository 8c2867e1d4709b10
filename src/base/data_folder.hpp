// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace meander {

/// Where `name` ("lib/meander/codecs.so") may be: in the folder of the running program and in the two above it. So
/// PREFIX/bin/meander and every program of a build tree find their own, wherever the prefix is moved.
std::vector<std::string> beside_program(const std::string& name);

/// The folder of the worlds and examples that come with the program: $MEANDER_DATA_DIR, else share/meander beside the
/// program, which in a build tree leads to the checkout. Empty where there is neither.
std::string data_folder();

/// The file or folder that a user means by `path`: the one of this name, else the one of this name in the data folder.
std::optional<std::string> find_file(const std::string& path);

/// What to add to "no such file": "; did you mean 'worlds/office.toml'?", else ", here or in /usr/share/meander", else
/// nothing.
std::string missing_file_hint(const std::string& path);

/// find_file() for those who need it: throws FileError "path: no such file" with the hint.
std::string readable_file(const std::string& path);

/// The names in the data folder that begin with `start` ("worlds/of"), folders with a slash behind them; sorted.
std::vector<std::string> data_files(const std::string& start);

}  // namespace meander
