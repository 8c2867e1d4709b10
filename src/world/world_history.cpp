// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Undo, redo, transactions.
#include <utility>

#include "base/error.hpp"
#include "world/world.hpp"

namespace meander {

World::Open::Open(const Open& other) {
  if (other.depth > 0) fail("a world cannot be copied inside a transaction");
}

World::Open& World::Open::operator=(const Open& other) {
  if (depth > 0 || other.depth > 0) fail("a world cannot be copied inside a transaction");
  return *this;
}

/// Takes everything since its making back unless told that all went well: also when what flies by is no std::exception.
class World::Rollback {
 public:
  explicit Rollback(World& world) : world_(world), mark_(world.open_.step.forward.size()) { ++world_.open_.depth; }
  Rollback(const Rollback&) = delete;
  Rollback& operator=(const Rollback&) = delete;
  ~Rollback() {
    if (!kept_) world_.take_back(world_.open_.step, mark_);
    --world_.open_.depth;
  }
  void keep() { kept_ = true; }

 private:
  World& world_;
  std::size_t mark_;
  bool kept_ = false;
};

/// Undoes the latest edits of a step until `down_to` are left.
void World::take_back(Step& step, std::size_t down_to) {
  while (step.forward.size() > down_to) {
    perform(step.backward.back());
    // The newest slot is free for the next addition, under a new generation.
    if (const auto* add = std::get_if<Add>(&step.forward.back()); add && add->id.slot + 1 == next_slot_)
      next_slot_ = add->id.slot;
    step.forward.pop_back();
    step.backward.pop_back();
  }
}

void World::transaction(const std::function<void()>& body) {
  {
    Rollback rollback(*this);
    body();
    if (open_.depth == 1) check_all_placements();
    rollback.keep();
  }
  if (open_.depth > 0 || open_.step.forward.empty()) return;
  done_.push_back(std::exchange(open_.step, {}));
  undone_.clear();
}

void World::check_no_transaction(const char* what) const {
  if (open_.depth > 0) fail("{} inside a transaction", what);
}

int World::undo(int steps) {
  check_no_transaction("undo");
  int count = 0;
  for (; count < steps && !done_.empty(); ++count) {
    undone_.push_back(done_.back());
    take_back(done_.back(), 0);
    done_.pop_back();
  }
  return count;
}

int World::redo(int steps) {
  check_no_transaction("redo");
  int count = 0;
  for (; count < steps && !undone_.empty(); ++count) {
    for (const Edit& edit : undone_.back().forward) perform(edit);
    done_.push_back(std::move(undone_.back()));
    undone_.pop_back();
  }
  return count;
}

void World::forget_history() {
  check_no_transaction("forget_history");
  done_.clear();
  undone_.clear();
}

}  // namespace meander
