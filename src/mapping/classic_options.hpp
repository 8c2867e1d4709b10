// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/fields.hpp"

namespace meander {

struct ConeModelOptions {
  double half_cone = 0.2181661564992912;
  double depth = 0.075;
  double free = 0.7;
  double occupied = 0.95;
  double trust = 2;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ConeModelOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"half_cone", "rad", "half opening angle of the cone", 0.01, 0.5}, o.half_cone);
  visit(Field{"depth", "m", "half the depth of the shell around the range in which something echoed", 0.01, 2},
        o.depth);
  visit(Field{"free", "", "how sure the axis of the cone is free near the sonar", 0, 0.999}, o.free);
  visit(Field{"occupied", "", "how sure the axis is occupied at the range", 0, 0.999}, o.occupied);
  visit(Field{"trust", "m", "farther away a cone tells nothing", 0.1, 1000}, o.trust);
}

struct RangeLayerOptions {
  double half_cone = 0.26;
  double reliable = 0.8;
  double tolerance = 0.08;
  bool clear_beyond = false;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, RangeLayerOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"half_cone", "rad", "half opening angle of the cone", 0.01, 0.5}, o.half_cone);
  visit(Field{"reliable", "m", "distance at which readings lose half their weight", 0.1, 100}, o.reliable);
  visit(Field{"tolerance", "", "half the depth of the shell, as a share of the range", 0.001, 0.5}, o.tolerance);
  visit(Field{"clear_beyond", "", "no echo clears the cone"}, o.clear_beyond);
}

}  // namespace meander
