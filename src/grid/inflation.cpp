// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/inflation.hpp"

#include <algorithm>
#include <cstdlib>

namespace meander {
namespace {

constexpr std::int64_t kFar = 1 << 20;  // beyond any column, yet its square still fits

/// Distance to the nearest occupied cell of the same column.
Grid<std::int32_t> column_distances(const Grid<std::uint8_t>& occupied) {
  const int width = occupied.width(), height = occupied.height();
  Grid<std::int32_t> distance(width, height, kFar, occupied.frame);
  for (int x = 0; x < width; ++x) {
    std::int32_t d = kFar;
    for (int y = 0; y < height; ++y) distance[{x, y}] = d = occupied[{x, y}] ? 0 : std::min<std::int32_t>(d + 1, kFar);
    d = kFar;
    for (int y = height; y-- > 0;) {
      d = occupied[{x, y}] ? 0 : std::min<std::int32_t>(d + 1, kFar);
      distance[{x, y}] = std::min(distance[{x, y}], d);
    }
  }
  return distance;
}

/// Lower envelope of the parabolas (x - site)^2 + column(site)^2 of one row.
class Envelope {
 public:
  void build(const Grid<std::int32_t>& column, int row) {
    pieces_.clear();
    for (int x = 0; x < column.width(); ++x) {
      const std::int64_t height = column[{x, row}];
      if (height >= kFar) continue;
      while (!pieces_.empty() &&
             value(pieces_.back(), pieces_.back().from) > value({x, 0, height}, pieces_.back().from))
        pieces_.pop_back();
      const int from = pieces_.empty() ? 0 : first_below(pieces_.back(), {x, 0, height});
      if (from < column.width()) pieces_.push_back({x, from, height});
    }
  }
  void write(Grid<std::int32_t>& squared, int row) const {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const int end = i + 1 < pieces_.size() ? pieces_[i + 1].from : squared.width();
      for (int x = pieces_[i].from; x < end; ++x)
        squared[{x, row}] = static_cast<std::int32_t>(std::min<std::int64_t>(value(pieces_[i], x), kNothingNear));
    }
  }

 private:
  struct Piece {
    int site;
    int from;  ///< first column where it is the lowest
    std::int64_t height;
  };
  static std::int64_t value(const Piece& piece, std::int64_t x) {
    return (x - piece.site) * (x - piece.site) + piece.height * piece.height;
  }
  /// The first column where `right` is below `left`: left.site < right.site.
  static int first_below(const Piece& left, const Piece& right) {
    const std::int64_t a = left.site, b = right.site;
    const std::int64_t numerator = b * b - a * a + right.height * right.height - left.height * left.height;
    return static_cast<int>(std::min(numerator / (2 * (b - a)) + 1, kFar));
  }

  std::vector<Piece> pieces_;
};

}  // namespace

Grid<std::int32_t> squared_distance_cells(const Grid<std::uint8_t>& occupied) {
  const Grid<std::int32_t> column = column_distances(occupied);
  Grid<std::int32_t> squared(occupied.width(), occupied.height(), kNothingNear, occupied.frame);
  Envelope envelope;
  for (int row = 0; row < occupied.height(); ++row) {
    envelope.build(column, row);
    envelope.write(squared, row);
  }
  return squared;
}

Grid<std::uint8_t> inflated(const Grid<std::uint8_t>& occupied, double radius) {
  const double cells = radius / occupied.frame.resolution, most = cells * cells;
  const Grid<std::int32_t> squared = squared_distance_cells(occupied);
  Grid<std::uint8_t> result(occupied.width(), occupied.height(), 0, occupied.frame);
  std::transform(squared.cells().begin(), squared.cells().end(), result.cells().begin(),
                 [most](std::int32_t d) { return static_cast<std::uint8_t>(d != kNothingNear && d <= most); });
  return result;
}

}  // namespace meander
