// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/scene.hpp"

#include <algorithm>

namespace meander {
namespace {

/// The slot whose item the edit changed, if any.
std::optional<std::uint32_t> touched_slot(const Edit& edit) {
  return std::visit(
      [](const auto& e) -> std::optional<std::uint32_t> {
        if constexpr (requires { e.id; })
          return e.id.slot;
        else
          return std::nullopt;
      },
      edit);
}

Material surface_material(const Item& item) {
  return std::visit(
      [](const auto& thing) {
        if constexpr (requires { thing.surface; })
          return material_of(thing.surface);
        else
          return Material{};
      },
      item);
}

}  // namespace

void Scene::refresh(const World& world, std::uint32_t slot) {
  if (index_.has(slot)) index_.remove(slot);
  const Item* item = world.slot(slot);
  if (const Shape* shape = item ? blocking_shape(*item) : nullptr) index_.insert(slot, *shape, surface_material(*item));
  const auto place = std::lower_bound(lamps_.begin(), lamps_.end(), slot,
                                      [](const Lamp& lamp, std::uint32_t s) { return lamp.slot < s; });
  const bool known = place != lamps_.end() && place->slot == slot;
  const auto* light = item ? std::get_if<Light>(item) : nullptr;
  if (light && known) *place = {slot, light->position, light->strength};
  if (light && !known) lamps_.insert(place, {slot, light->position, light->strength});
  if (!light && known) lamps_.erase(place);
}

void Scene::follow(const World& world) {
  const std::vector<Edit>& log = world.log();
  // A long backlog, or a world with a shorter past than the one followed so far: look at every slot once instead.
  if (log.size() < seen_ || log.size() - seen_ > world.slots()) {
    index_.clear();
    lamps_.clear();
    for (std::uint32_t slot = 0; slot < world.slots(); ++slot) refresh(world, slot);
  } else {
    for (std::size_t i = seen_; i < log.size(); ++i)
      if (const auto slot = touched_slot(log[i])) refresh(world, *slot);
  }
  seen_ = log.size();
}

}  // namespace meander
