// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/error_heap.hpp"

namespace meander::topology {

void ErrorHeap::place(std::size_t slot, const Entry& entry) {
  heap_[slot] = entry;
  at_[static_cast<std::size_t>(entry.cell)] = slot;
}

void ErrorHeap::settle(std::size_t slot) {
  const Entry entry = heap_[slot];
  for (; slot > 0 && entry.before(heap_[(slot - 1) / 2]); slot = (slot - 1) / 2) place(slot, heap_[(slot - 1) / 2]);
  for (std::size_t child = 2 * slot + 1; child < heap_.size(); child = 2 * slot + 1) {
    if (child + 1 < heap_.size() && heap_[child + 1].before(heap_[child])) ++child;
    if (!heap_[child].before(entry)) break;
    place(slot, heap_[child]);
    slot = child;
  }
  place(slot, entry);
}

void ErrorHeap::set(int cell, double error) {
  const auto i = static_cast<std::size_t>(cell);
  if (i >= at_.size()) at_.resize(i + 1, kNowhere);
  if (at_[i] == kNowhere) {
    at_[i] = heap_.size();
    heap_.push_back({error, cell});
  } else {
    heap_[at_[i]].error = error;
  }
  settle(at_[i]);
}

void ErrorHeap::remove(int cell) {
  const std::size_t slot = at_[static_cast<std::size_t>(cell)];
  const Entry last = heap_.back();
  heap_.pop_back();
  at_[static_cast<std::size_t>(cell)] = kNowhere;
  if (last.cell == cell) return;
  place(slot, last);
  settle(slot);
}

void ErrorHeap::clear() {
  heap_.clear();
  at_.clear();
}

}  // namespace meander::topology
