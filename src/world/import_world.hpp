// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "world/import_barn.hpp"
#include "world/import_floor_plan.hpp"
#include "world/import_movingai.hpp"
#include "world/import_ros_map.hpp"

namespace meander {

/// The options of all formats side by side; each format takes its own.
struct ImportOptions {
  double resolution = FloorPlanOptions{}.resolution;
  double threshold = FloorPlanOptions{}.threshold;
  bool negate = FloorPlanOptions{}.negate;
  Unknown unknown = RosMapOptions{}.unknown;
  RosConvention convention = RosMapOptions{}.convention;
  int index = BarnOptions{}.index;
  double epsilon = TraceOptions{}.epsilon;
  double min_area = TraceOptions{}.min_area;
  std::function<void(const std::string& path)> opens{};  ///< told of a file that the one read names; may throw
};

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ImportOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"resolution", "m/pixel", "size of a pixel or cell (pictures, MovingAI maps)", 0.001, 1000}, o.resolution);
  visit(Field{"threshold", "", "grey from which on a pixel is light (pictures); 0: chosen by Otsu's method", 0, 256},
        o.threshold);
  visit(Field{"negate", "", "walls are light on dark (pictures)"}, o.negate);
  visit(Field{"unknown", "", "what unknown cells are (ROS maps): solid and a warning where doubtful, free, or solid"},
        o.unknown);
  visit(Field{"convention", "", "whose comparisons count at the thresholds (ROS maps)"}, o.convention);
  visit(Field{"index", "", "which of the worlds (BARN tables)", 0, 1e9}, o.index);
  visit(Field{"epsilon", "cells", "how far a straight outline may leave the edges of cells (maps and pictures)", 0,
              0.499},
        o.epsilon);
  visit(Field{"min_area", "m^2", "smaller solid patches are dropped as specks (maps and pictures)", 0, 1e6},
        o.min_area);
}

/// Reads a world of any known format, told by the suffix: .toml (world file), .yaml .yml (ROS map), .png .pgm .jpg
/// .jpeg .bmp .tif .tiff (picture of a floor plan), .csv (BARN cylinders), .map (MovingAI, ARIA). Throws FileError that
/// lists the suffixes.
Imported import_world(const std::string& path, const ImportOptions& options = {}, const Work& work = {});

/// The suffixes that import_world() knows, with the dot.
std::vector<std::string> import_suffixes();

}  // namespace meander
