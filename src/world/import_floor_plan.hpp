// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "world/import_result.hpp"
#include "world/trace.hpp"

namespace meander {

struct FloorPlanOptions {
  double resolution = 0.05;
  double threshold = 0;
  bool negate = false;
  TraceOptions trace;
};

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, FloorPlanOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"resolution", "m/pixel", "size of a pixel of an image floor plan", 0.001, 1000}, o.resolution);
  visit(Field{"threshold", "", "grey from which on a pixel is light; 0: chosen by Otsu's method", 0, 256}, o.threshold);
  visit(Field{"negate", "", "walls are light on dark"}, o.negate);
  visit(Field{"trace", "", "how pixels become outlines"}, o.trace);
}

/// A plain picture of walls, dark on light, its lower left corner at (0, 0), y up. See-through pixels are light. Throws
/// FileError.
Imported import_floor_plan(const std::string& image_path, const FloorPlanOptions& options = {}, const Work& work = {});

}  // namespace meander
