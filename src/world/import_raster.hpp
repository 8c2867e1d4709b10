// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "world/import_result.hpp"
#include "world/trace.hpp"

namespace meander {

/// The name of a file without folder and suffix, fit for the title of a world.
std::string title_of(const std::string& path);

/// "604 x 307 cells of 0.05 m, 30.2 m x 15.35 m".
std::string size_text(const Grid<std::uint8_t>& grid);

/// A world of the solids that trace() finds. The bounds are those of the grid. `report` is continued.
Imported world_from_raster(const Grid<std::uint8_t>& solid, const std::string& path, const TraceOptions& options,
                           std::vector<std::string> report, const Work& work = {});

}  // namespace meander
