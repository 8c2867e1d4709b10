// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

namespace meander::topology {

/// Cells by their classification error, the largest on top; ties go to the smaller number. Changing one costs
/// O(log n), so that finding where the map is worst needs no look at all cells.
class ErrorHeap {
 public:
  void set(int cell, double error);
  void remove(int cell);
  bool empty() const { return heap_.empty(); }
  int worst() const { return heap_.front().cell; }
  double error(int cell) const { return heap_[at_[static_cast<std::size_t>(cell)]].error; }
  void clear();

 private:
  struct Entry {
    double error;
    int cell;
    bool before(const Entry& other) const { return error != other.error ? error > other.error : cell < other.cell; }
  };
  static constexpr std::size_t kNowhere = ~std::size_t{0};
  void place(std::size_t slot, const Entry& entry);
  void settle(std::size_t slot);

  std::vector<Entry> heap_;
  std::vector<std::size_t> at_;  ///< slot by cell
};

}  // namespace meander::topology
