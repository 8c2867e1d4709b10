// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>

namespace meander {

/// What a cell of a map truly is for a robot that looks from where it is now; hidden: no scan can tell.
enum class CellTruth : std::uint8_t { hidden, free, occupied };

}  // namespace meander
