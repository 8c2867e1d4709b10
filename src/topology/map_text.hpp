// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "topology/topologic_map.hpp"

namespace meander::topology {

/// A map as text, with everything that decides how it goes on: a map that is written and read in the middle of a run
/// learns the same from there. One line a cell; the last line is a checksum of all others.
std::string map_text(const TopologicMap& map);
/// Throws FileError that names `path`, the line and what was expected.
TopologicMap read_map_text(std::string_view text, const std::string& path);

}  // namespace meander::topology
