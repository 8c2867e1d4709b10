// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/pool.hpp"

#include <array>

#include "render/thin.hpp"

namespace meander {
namespace {

constexpr bool is_solid(int mark) {
  return mark == static_cast<int>(Mark::wall) || mark == static_cast<int>(Mark::door);
}

/// How often each mark occurs in a block, and the colour sums of solid and other pixels.
struct Tally {
  std::array<std::uint16_t, kMarks> count{};
  std::array<std::array<int, 3>, 2> sum{};
  int solid = 0;
  int above = 0;  ///< pixels of marks that cover solids
};

class Tallies {
 public:
  Tallies(const Canvas& canvas, int block_width, int block_height)
      : columns_(canvas.image.width / block_width),
        rows_(canvas.image.height / block_height),
        pixels_(block_width * block_height),
        blocks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    for (int y = 0; y < rows_ * block_height; ++y) {
      std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.image.width);
      Tally* block = &blocks_[static_cast<std::size_t>(y / block_height) * static_cast<std::size_t>(columns_)];
      for (int column = 0; column < columns_; ++column, ++block)
        for (int i = 0; i < block_width; ++i, ++pixel)
          add(*block, canvas.marks[pixel], &canvas.image.pixels[3 * pixel]);
    }
  }

  std::vector<Pool> pools() const {
    std::vector<int> cover;
    for (const Tally& tally : blocks_) cover.push_back(tally.solid);
    const auto walls = thinned_walls(cover, columns_, rows_, pixels_);
    std::vector<Pool> pools;
    for (std::size_t i = 0; i < blocks_.size(); ++i) pools.push_back(pool(blocks_[i], walls[i] != 0));
    return pools;
  }

 private:
  static void add(Tally& tally, std::uint8_t mark, const std::uint8_t* rgb) {
    ++tally.count[mark];
    tally.solid += is_solid(mark);
    tally.above += mark > static_cast<int>(Mark::door);
    for (std::size_t i = 0; i < 3; ++i) tally.sum[is_solid(mark)][i] += rgb[i];
  }

  Pool pool(const Tally& tally, bool is_wall) const {
    return {color(tally, is_wall && tally.solid >= tally.above), mark(tally, is_wall)};
  }

  /// The uppermost mark that covers an eighth of the block, and more of it than a wall does.
  Mark mark(const Tally& tally, bool is_wall) const {
    for (int mark = kMarks - 1; mark > 0; --mark) {
      const int count = tally.count[static_cast<std::size_t>(mark)];
      const bool shows = is_solid(mark) ? is_wall && 2 * count >= tally.solid
                                        : 8 * count >= pixels_ && (!is_wall || count > tally.solid);
      if (shows) return static_cast<Mark>(mark);
    }
    return Mark::ground;
  }

  Color color(const Tally& tally, bool of_solid) const {
    if (tally.solid == pixels_) of_solid = true;
    const int count = of_solid ? tally.solid : pixels_ - tally.solid;
    const auto& sum = tally.sum[of_solid];
    const auto mean = [&](std::size_t i) { return static_cast<std::uint8_t>((sum[i] + count / 2) / count); };
    return {mean(0), mean(1), mean(2)};
  }

  int columns_, rows_, pixels_;
  std::vector<Tally> blocks_;
};

}  // namespace

std::vector<Pool> pooled(const Canvas& canvas, int block_width, int block_height) {
  return Tallies(canvas, block_width, block_height).pools();
}

}  // namespace meander
