// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <utility>

#include "base/fields.hpp"
#include "geometry/angle.hpp"

namespace meander {

/// How the evidence of many scans becomes one: by the paper's rule, or one opinion per view.
enum class Fusion { viewbin, bayes };
template <>
struct EnumNames<Fusion> {
  static constexpr std::pair<Fusion, const char*> entries[] = {{Fusion::viewbin, "viewbin"}, {Fusion::bayes, "bayes"}};
};

struct FusionOptions {
  Fusion rule = Fusion::viewbin;
  double certainty = 0.99;
  double view_bearing = 0.7853981633974483;
  double view_range = 1;
  double view_blend = 0.3;
  bool remember_views = true;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, FusionOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"fusion", "",
              "viewbin: scans from about the same place count once; bayes: every scan counts, [CN] eq. (4)"},
        o.rule);
  visit(Field{"certainty", "", "probabilities stay between 1 minus this and this", 0.6, 0.999999}, o.certainty);
  visit(Field{"view_bearing", "rad", "viewbin: bearings this near count as the same view of a cell", 0.1, 6.3},
        o.view_bearing);
  visit(Field{"view_range", "m", "viewbin: distances this near count as the same view of a cell", 0.05, 100},
        o.view_range);
  visit(Field{"view_blend", "", "viewbin: weight of the newest scan in the opinion of its view", 0.01, 1},
        o.view_blend);
  visit(Field{"remember_views", "", "viewbin: a view come back to goes on from its opinion instead of counting anew"},
        o.remember_views);
}

}  // namespace meander
