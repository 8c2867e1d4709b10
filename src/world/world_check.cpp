// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What an edit must satisfy before it may change anything.
#include "base/error.hpp"
#include "world/placement.hpp"
#include "world/validity.hpp"
#include "world/world.hpp"

namespace meander {

void World::check(const Edit& edit) const {
  if (const auto* add = std::get_if<Add>(&edit)) {
    check_id(*add);
    check_item(add->item);
    check_name_free(name_of(add->item), add->id);
  } else if (const auto* remove = std::get_if<Remove>(&edit)) {
    item(remove->id);
  } else if (const auto* replace = std::get_if<Replace>(&edit)) {
    const Item& old = item(replace->id);
    if (old.index() != replace->item.index()) fail("{} cannot be replaced by a {}", label(old), kind_of(replace->item));
    check_item(replace->item);
    check_name_free(name_of(replace->item), replace->id);
  } else {
    check_header(std::get<SetHeader>(edit).header);
  }
  if (open_.depth == 0) check_placement(edit);
}

/// An id that is free and was given out before, or is the next one of its slot: a log can be replayed, but no edit can
/// ask for four billion slots.
void World::check_id(const Add& add) const {
  const Id id = add.id;
  const std::uint32_t given = id.slot < slots_.size() ? slots_[id.slot].generations : 0;
  if (id.slot > slots_.size() || id.generation > given || slot(id.slot))
    fail("{}: the id {}.{} is not free", label(add.item), id.slot, id.generation);
}

void World::check_name_free(const std::string& name, Id user) const {
  const auto found = by_name_.find(name);
  if (found != by_name_.end() && found->second != user)
    fail("the name '{}' is taken by {} {}", name, kind_of(item(found->second)) == std::string("obstacle") ? "an" : "a",
         kind_of(item(found->second)));
}

void World::check_placement(const Edit& edit) const {
  if (const auto* add = std::get_if<Add>(&edit)) check_item_placement(add->item);
  if (const auto* replace = std::get_if<Replace>(&edit)) check_item_placement(replace->item);
  if (const auto* set = std::get_if<SetHeader>(&edit)) check_header_placement(set->header);
}

/// No kind both blocks and needs free ground, so a thing never meets its own former self here.
void World::check_item_placement(const Item& item) const {
  for (const Spot& spot : spots_of(item)) {
    check_within(spot, header_.bounds);
    for (const Slot& slot : slots_)
      if (slot.item) check_apart(*slot.item, spot);
  }
  if (!blocking_shape(item)) return;
  for (const Spot& spot : spots_of(header_)) check_apart(item, spot);
  for (const std::uint32_t slot : standing_)
    for (const Spot& spot : spots_of(*slots_[slot].item)) check_apart(item, spot);
}

void World::check_header_placement(const Header& header) const {
  for (const Spot& spot : spots_of(header)) {
    check_within(spot, header.bounds);
    for (const Slot& slot : slots_)
      if (slot.item) check_apart(*slot.item, spot);
  }
  for (const std::uint32_t slot : standing_)
    for (const Spot& spot : spots_of(*slots_[slot].item)) check_within(spot, header.bounds);
}

void World::check_all_placements() const {
  check_header_placement(header_);
  for (const std::uint32_t slot : standing_) check_item_placement(*slots_[slot].item);
}

}  // namespace meander
