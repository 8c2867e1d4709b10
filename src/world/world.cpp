// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/world.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/names.hpp"
#include "world/attributes.hpp"
#include "world/placement.hpp"
#include "world/text.hpp"
#include "world/validity.hpp"

namespace meander {

World::World(Header header) {
  set_header(std::move(header));
  forget_history();
}

// --- reading ---------------------------------------------------------------------------------------------------------

std::vector<Id> World::ids() const {
  std::vector<Id> living;
  living.reserve(size());
  for (std::uint32_t i = 0; i < slots_.size(); ++i)
    if (slots_[i].item) living.push_back({i, slots_[i].generation});
  return living;
}

bool World::alive(Id id) const {
  return id.slot < slots_.size() && slots_[id.slot].item && slots_[id.slot].generation == id.generation;
}

const Item& World::item(Id id) const {
  if (!alive(id)) refuse_stale(id);
  return *slots_[id.slot].item;
}

Id World::find(const std::string& name) const {
  if (const auto found = by_name_.find(name); found != by_name_.end()) return found->second;
  fail("no '{}' in this world{}", printable(name), did_you_mean(name, names()));
}

std::vector<std::string> World::names() const {
  std::vector<std::string> all;
  all.reserve(size());
  for (const Slot& slot : slots_)
    if (slot.item) all.push_back(name_of(*slot.item));
  return all;
}

const Item* World::slot(std::uint32_t slot) const {
  return slot < slots_.size() && slots_[slot].item ? &*slots_[slot].item : nullptr;
}

Id World::id_at(std::uint32_t slot) const {
  if (!this->slot(slot)) fail("nothing stands in slot {} of this world", slot);
  return {slot, slots_[slot].generation};
}

void World::refuse_stale(Id id) const {
  for (auto edit = log_.rbegin(); edit != log_.rend(); ++edit)
    if (const Item* item = item_of(*edit, id)) fail<StaleError>("{} was removed", label(*item));
  fail<StaleError>("no thing of this world has the id {}.{}", id.slot, id.generation);
}

std::uint64_t World::hash() const {
  Hash hash;
  add_to(hash, attributes(header_));
  for (const Slot& slot : slots_)
    if (slot.item) add_to(hash.add(std::string_view(kind_of(*slot.item))), attributes(*slot.item));
  return hash.value();
}

bool World::operator==(const World& other) const {
  if (header_ != other.header_ || size() != other.size()) return false;
  const std::vector<Id> mine = ids(), theirs = other.ids();
  return std::equal(mine.begin(), mine.end(), theirs.begin(), [&](Id a, Id b) { return item(a) == other.item(b); });
}

// --- changing --------------------------------------------------------------------------------------------------------

void World::put(Id id, const Item& item) {
  if (id.slot >= slots_.size()) slots_.resize(id.slot + 1);
  Slot& slot = slots_[id.slot];
  if (slot.item) by_name_.erase(name_of(*slot.item));
  slot.generation = id.generation;
  slot.generations = std::max(slot.generations, id.generation + 1);
  slot.item = item;
  by_name_[name_of(item)] = id;
  if (!spots_of(item).empty()) standing_.insert(id.slot);
  next_slot_ = std::max(next_slot_, id.slot + 1);
}

void World::take(Id id) {
  by_name_.erase(name_of(item(id)));
  standing_.erase(id.slot);
  slots_[id.slot].item.reset();
}

Edit World::inverse_of(const Edit& edit) const {
  if (const auto* add = std::get_if<Add>(&edit)) return Remove{add->id};
  if (const auto* remove = std::get_if<Remove>(&edit)) return Add{remove->id, item(remove->id)};
  if (const auto* replace = std::get_if<Replace>(&edit)) return Replace{replace->id, item(replace->id)};
  return SetHeader{header_};
}

void World::perform(const Edit& edit) {
  log_.push_back(edit);
  if (const auto* add = std::get_if<Add>(&edit)) put(add->id, add->item);
  if (const auto* remove = std::get_if<Remove>(&edit)) take(remove->id);
  if (const auto* replace = std::get_if<Replace>(&edit)) put(replace->id, replace->item);
  if (const auto* set = std::get_if<SetHeader>(&edit)) header_ = set->header;
}

Id World::next_id() const { return {next_slot_, next_slot_ < slots_.size() ? slots_[next_slot_].generations : 0}; }

std::string World::free_name(const Item& item, std::uint32_t slot) const {
  for (std::uint64_t number = slot + 1ull;; ++number)
    if (std::string name = fmt::format("{} {}", kind_of(item), number); !has(name)) return name;
}

/// The edit in the one form it is logged in: names filled in, numbers plain.
Edit World::completed(Edit edit) const {
  const auto set_name = [](Item& item, std::string name) {
    std::visit([&](auto& thing) { thing.name = std::move(name); }, item);
  };
  if (auto* add = std::get_if<Add>(&edit)) {
    if (name_of(add->item).empty()) set_name(add->item, free_name(add->item, add->id.slot));
    add->item = normalised(std::move(add->item));
  } else if (auto* replace = std::get_if<Replace>(&edit)) {
    if (name_of(replace->item).empty()) set_name(replace->item, name_of(item(replace->id)));
    replace->item = normalised(std::move(replace->item));
  } else if (auto* set = std::get_if<SetHeader>(&edit)) {
    set->header = normalised(std::move(set->header));
  }
  return edit;
}

void World::apply(const Edit& raw) {
  const Edit edit = completed(raw);
  check(edit);
  Edit inverse = inverse_of(edit);
  perform(edit);
  Step single;
  Step& step = open_.depth > 0 ? open_.step : single;
  step.forward.push_back(edit);
  step.backward.push_back(std::move(inverse));
  if (open_.depth > 0) return;
  done_.push_back(std::move(single));
  undone_.clear();
}

Id World::add(Item item) {
  const Id id = next_id();
  apply(Add{id, std::move(item)});
  return id;
}
void World::remove(Id id) { apply(Remove{id}); }
void World::replace(Id id, Item item) { apply(Replace{id, std::move(item)}); }
void World::set_header(Header header) { apply(SetHeader{std::move(header)}); }

}  // namespace meander
