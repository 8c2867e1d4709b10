// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/layers.hpp"

#include <algorithm>

namespace meander {

DrawList without(const DrawList& list, const std::vector<Mark>& hidden) {
  DrawList rest = list;
  std::erase_if(rest.items, [&](const DrawItem& item) {
    return std::find(hidden.begin(), hidden.end(), mark_of(item)) != hidden.end();
  });
  return rest;
}

}  // namespace meander
