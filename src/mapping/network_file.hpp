// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "mapping/sonar_network.hpp"

namespace meander {

/// The weights of a network as text: a line each for its kind, features, ring, sonar, maker, layers and prior, a line
/// of weights for each unit, and a checksum of all before. Written and read again, it is the same to the bit.
/// Throws ArgumentError for words that could not be read back.
std::string network_text(const SonarNetwork& network);

/// Throws FileError "path:line: what" for a text that is cut short, of another version, damaged (checksum), or that
/// contradicts itself: sizes out of range, layers that do not fit the features, weights that are no finite numbers.
SonarNetwork network_from_text(const std::string& text, const std::string& path);

/// The same for files; data files that come with the program are found by their names, too.
SonarNetwork read_network(const std::string& path);
void write_network(const SonarNetwork& network, const std::string& path);

}  // namespace meander
