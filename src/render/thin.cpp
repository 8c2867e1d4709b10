// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/thin.hpp"

#include <algorithm>
#include <array>

namespace meander {
namespace {

class Thinning {
 public:
  Thinning(const std::vector<int>& cover, int columns, int rows, int full)
      : cover_(cover), columns_(columns), rows_(rows), full_(full), wall_(cover.size()) {
    for (std::size_t i = 0; i < cover.size(); ++i) wall_[i] = cover[i] > 0;
  }

  std::vector<std::uint8_t> run() && {
    std::vector<std::size_t> weak;
    for (std::size_t i = 0; i < cover_.size(); ++i)
      if (wall_[i] && !strong(i)) weak.push_back(i);
    std::stable_sort(weak.begin(), weak.end(), [&](std::size_t a, std::size_t b) { return weight(a) < weight(b); });
    while (std::erase_if(weak, [&](std::size_t i) { return remove_if_spare(i); }) > 0) {
    }
    return std::move(wall_);
  }

 private:
  bool strong(std::size_t i) const { return 2 * cover_[i] >= full_; }

  /// Index of a neighbour, or -1 outside. Directions count from the right, clockwise on the screen, by 45 degrees.
  std::ptrdiff_t neighbour(std::size_t i, std::size_t direction) const {
    constexpr std::array<std::array<int, 2>, 8> kSteps{
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    const int x = static_cast<int>(i) % columns_ + kSteps[direction][0];
    const int y = static_cast<int>(i) / columns_ + kSteps[direction][1];
    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return -1;
    return static_cast<std::ptrdiff_t>(y) * columns_ + x;
  }

  /// The cover of the block and around it, so that of two lanes that share a wall one wins along its whole length.
  int weight(std::size_t i) const {
    int sum = 2 * cover_[i];
    for (std::size_t k = 0; k < 8; k += 2)
      if (const auto n = neighbour(i, k); n >= 0) sum += cover_[static_cast<std::size_t>(n)];
    return sum;
  }

  bool is_wall(std::size_t i, std::size_t direction) const {
    const auto n = neighbour(i, direction % 8);
    return n >= 0 && wall_[static_cast<std::size_t>(n)];
  }

  bool remove_if_spare(std::size_t i) {
    std::array<bool, 8> wall{};
    for (std::size_t k = 0; k < 8; ++k) wall[k] = is_wall(i, k);
    if (!spare(wall) || (wall[0] + wall[2] + wall[4] + wall[6] == 1 && is_end(i, wall))) return false;
    wall_[i] = 0;
    return true;
  }

  /// The block has one neighbour. Is it the end of a wall, or just a rest on the side of one?
  bool is_end(std::size_t i, const std::array<bool, 8>& wall) const {
    std::size_t k = 0;
    while (!wall[k]) k += 2;
    const auto n = static_cast<std::size_t>(neighbour(i, k));
    const bool wall_passes = is_wall(n, k + 2) && is_wall(n, k + 6);
    return !strong(n) && (!wall_passes || cover_[i] > cover_[n]);
  }

  /// Do the walls around, and the free blocks too, hang together without the block in their middle? (Yokoi's
  /// connectivity number for walls joined along rows and columns is 1.)
  static bool spare(const std::array<bool, 8>& wall) {
    int number = 0;
    for (std::size_t k = 0; k < 8; k += 2) number += wall[k] && !(wall[k + 1] && wall[(k + 2) % 8]);
    return number == 1;
  }

  const std::vector<int>& cover_;
  int columns_, rows_, full_;
  std::vector<std::uint8_t> wall_;
};

}  // namespace

std::vector<std::uint8_t> thinned_walls(const std::vector<int>& cover, int columns, int rows, int full) {
  return Thinning(cover, columns, rows, full).run();
}

}  // namespace meander
