// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>
#include <cmath>
#include <memory>

#include "mapping/sonar_network.hpp"

namespace meander {
namespace {

using mapping::Block, mapping::kBlock, mapping::kLanes, mapping::Lanes, mapping::Selection;

/// Readings count by how far they end before or behind the cell: finely near it, coarsely farther off.
class Steps {
 public:
  /// `count` steps in all; the borders of those behind 0 grow with the distance as those before it.
  Steps(int count, double low, double high) : low_(static_cast<float>(low)), centers_(static_cast<std::size_t>(count)) {
    // Distance to a cell as a smooth scale on which all steps have the same length.
    const auto scale = [](double d) { return d / (kFine + std::abs(d)); };
    const double first = scale(low), last = scale(high);
    const int bins = static_cast<int>((high - low) * kPerMetre) + 2;
    std::vector<double> sums(centers_.size()), counts(centers_.size());
    for (int i = 0; i < bins; ++i) {
      const double d = low + (i + 0.5) / kPerMetre;
      const auto step = static_cast<std::size_t>(
          std::clamp(static_cast<int>((scale(d) - first) / (last - first) * count), 0, count - 1));
      index_.push_back(static_cast<std::uint8_t>(step));
      sums[step] += d;
      counts[step] += 1;
    }
    for (std::size_t step = 0; step < centers_.size(); ++step)
      centers_[step] = static_cast<float>(counts[step] > 0 ? sums[step] / counts[step] : low);
  }

  std::size_t count() const { return centers_.size(); }
  float center(std::size_t step) const { return centers_[step]; }
  std::size_t of(float difference) const { return index_[static_cast<std::size_t>((difference - low_) * kPerMetre)]; }

 private:
  static constexpr double kFine = 0.35;  ///< [m]
  static constexpr float kPerMetre = 100.0F;
  float low_;
  std::vector<float> centers_;
  std::vector<std::uint8_t> index_;
};

/// The network's output for every combination of a few values of the cell's range, its offset and the readings.
class Table {
 public:
  explicit Table(const SonarNetwork& made)
      : selector_(made.ring, made.features),
        features_(made.features),
        offsets_(made.features.bearing ? kOffsets : 1),
        steps_{Steps(kSteps[0], -features_.reach, features_.range_cap),
               Steps(kSteps[1], -features_.reach, features_.range_cap),
               Steps(features_.sonars == 3 ? kSteps[2] : 1, -features_.reach, features_.range_cap)} {
    compile(made);
  }

  std::size_t bytes() const { return sizeof(*this) + values_.capacity(); }
  void evaluate(const SonarSweep& sweep, const CellPlaces& cells, std::span<float> log_odds) {
    selector_.take(sweep);
    std::size_t i = 0;
    for (; i + kLanes <= cells.size(); i += kLanes)
      four(mapping::load(&cells.range[i]), mapping::load(&cells.bearing[i]), &log_odds[i]);
    if (i == cells.size()) return;
    float range[kLanes] = {}, bearing[kLanes] = {}, out[kLanes];
    const std::size_t rest = cells.size() - i;
    std::copy_n(cells.range.begin() + static_cast<std::ptrdiff_t>(i), rest, range);
    std::copy_n(cells.bearing.begin() + static_cast<std::ptrdiff_t>(i), rest, bearing);
    four(mapping::load(range), mapping::load(bearing), out);
    std::copy_n(out, rest, &log_odds[i]);
  }

 private:
  static constexpr int kRanges = 12;
  static constexpr int kOffsets = 8;
  static constexpr int kSteps[3] = {24, 20, 16};
  static constexpr float kUnit = 0.05F;  ///< log-odds of one step of a byte

  std::size_t range_bin(float range) const {
    return std::min(static_cast<std::size_t>(range * ranges_per_metre_), static_cast<std::size_t>(kRanges - 1));
  }
  std::size_t offset_bin(float offset) const {
    return std::min(static_cast<std::size_t>(2 * offset * static_cast<float>(offsets_)),
                    static_cast<std::size_t>(offsets_ - 1));
  }

  void four(Lanes range, Lanes bearing, float* log_odds) const {
    const Selection cells = selector_.select(range, bearing);
    const float reach = selector_.reach();
    for (int i = 0; i < kLanes; ++i) {
      const float r = cells.range[i];
      std::size_t row = range_bin(r) * static_cast<std::size_t>(offsets_) + offset_bin(cells.offset[i]);
      row = (row * steps_[0].count() + steps_[0].of(cells.nearest[i] - r)) * steps_[1].count() +
            steps_[1].of(cells.second[i] - r);
      if (features_.sonars == 3) row = row * steps_[2].count() + steps_[2].of(cells.third[i] - r);
      log_odds[i] = range[i] <= reach ? kUnit * values_[row] : 0.0F;
    }
  }

  /// Every row from the network, a block at a time; readings that no sonar has (shorter than nothing, longer than the
  /// cap) are what the nearest one would give.
  void compile(const SonarNetwork& made) {
    mapping::NetworkPass pass(made.network);
    values_.resize(static_cast<std::size_t>(kRanges * offsets_) * steps_[0].count() * steps_[1].count() *
                   steps_[2].count());
    std::vector<float> range(kBlock);
    for (std::size_t begin = 0; begin < values_.size(); begin += kBlock) {
      const std::size_t count = std::min<std::size_t>(kBlock, values_.size() - begin);
      Selection cells{};
      for (std::size_t i = 0; i < kBlock; ++i) {
        put(cells, i % kLanes, std::min(begin + i, values_.size() - 1));
        if (i % kLanes == kLanes - 1) selector_.fill(cells, pass.inputs(), i / kLanes);
      }
      const Block& output = pass.forward();
      for (std::size_t i = 0; i < count; ++i) {
        const float steps = (output[i / kLanes][i % kLanes] - static_cast<float>(made.prior)) / kUnit;
        values_[begin + i] = static_cast<std::int8_t>(std::clamp(std::floor(steps + 0.5F), -127.0F, 127.0F));
      }
    }
  }
  /// The cell and the readings that a row stands for.
  void put(Selection& cells, std::size_t lane, std::size_t row) const {
    std::size_t step[3];
    for (int k = 2; k >= 0; --k) {
      step[k] = row % steps_[k].count();
      row /= steps_[k].count();
    }
    const auto at = static_cast<int>(lane);
    const auto bins = static_cast<std::size_t>(offsets_);
    const float r = (static_cast<float>(row / bins) + 0.5F) / ranges_per_metre_;
    const auto reading = [&](int k) {
      return std::clamp(r + steps_[k].center(step[k]), 0.0F, static_cast<float>(features_.range_cap));
    };
    cells.range[at] = r;
    cells.offset[at] = (static_cast<float>(row % bins) + 0.5F) / static_cast<float>(2 * bins);
    cells.nearest[at] = reading(0);
    cells.second[at] = reading(1);
    cells.third[at] = reading(2);
  }

  mapping::SonarSelector selector_;
  SonarFeatures features_;
  int offsets_;
  Steps steps_[3];
  float ranges_per_metre_ = static_cast<float>(kRanges / features_.reach);
  std::vector<std::int8_t> values_;
};

}  // namespace

SonarModel table_model(const SonarNetwork& network) {
  auto table = std::make_shared<Table>(network);
  return {.name = network.name,
          .ring = network.ring,
          .reach = network.features.reach,
          .evaluate = [table](const SonarSweep& sweep, const CellPlaces& cells,
                              std::span<float> log_odds) { table->evaluate(sweep, cells, log_odds); },
          .bytes = table->bytes()};
}

}  // namespace meander
