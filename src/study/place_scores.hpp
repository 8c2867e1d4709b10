// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/sim.hpp"

namespace meander {

/// What a map of places said in a sample: which place the situation of an earlier sample belongs to.
struct PlaceClaim {
  std::int64_t sample = -1;  ///< of that situation; -1: nothing said
  std::uint64_t place = 0;   ///< serial number of the place
  std::int64_t born = 0;     ///< sample in which the place was made
};

struct PlaceScoreOptions {
  int age = 100;        ///< younger places are no recognition [samples]
  double within = 0.5;  ///< a place is right when its true place is this near [m] and in sight
  double bin = 0.15;    ///< squares of the world count as visited again [m]
  int hits = 60;        ///< the true place is the mean over its last hits, about
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlaceScoreOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"age", "", "younger places are no recognition, in samples", 0, 1e9}, o.age);
  visit(Field{"within", "m", "a place is right when its true place is this near and in sight", 0, 100}, o.within);
  visit(Field{"bin", "m", "side of the squares that count as visited again", 1e-3, 100}, o.bin);
  visit(Field{"hits", "", "the true place of a cell is the mean over about its last so many hits", 1, 1e6}, o.hits);
}

struct PlaceSummary {
  int samples = 0;
  double error_mean = 0, error_max = 0;  ///< believed against true position [m]
  double error_last = 0;                 ///< mean over the last 1000 samples [m]
  double error_aligned = 0;              ///< root mean square after the best turn and shift of all [m]
  double recall = 0;                     ///< share of the returns to a place that were recognised
  double precision = 0;                  ///< share of the recognitions that were right
};

/// How well a robot that builds a map of places knows where it is. Knows the truth, which the map never sees. Begun
/// with the simulation as it is before the first cycle, and told after every cycle what the map made of the observation
/// before it.
class PlaceScores {
 public:
  explicit PlaceScores(const Sim& sim, const PlaceScoreOptions& options = {});
  /// A cycle has ended: where the robot believed to be when it began, and what its map said.
  void add(const Sim& sim, const Pose2& believed, const PlaceClaim& claim);
  PlaceSummary summary() const;
  /// How far the places of a map lie from where they truly are: the root of the mean square [m]; 0 for none that was
  /// claimed.
  struct MapPlace {
    std::uint64_t place = 0;
    Vec2 position{0, 0};
  };
  double map_error(std::span<const MapPlace> places) const;
  /// Where the situations that a place stands for were, on average; nothing for places never claimed.
  std::optional<Vec2> true_place(std::uint64_t place) const;

 private:
  struct TruePlace {
    Vec2 position{0, 0};
    int hits = 0;
  };
  void judge(const Sim& sim, const PlaceClaim& claim);
  double aligned_error() const;

  PlaceScoreOptions options_;
  Vec2 before_;                                             ///< true position when the cycle began
  std::vector<Vec2> truth_, believed_;                      ///< by sample
  std::map<std::uint64_t, TruePlace> places_;               ///< by serial number
  std::map<std::pair<int, int>, std::int64_t> first_seen_;  ///< by square of the world
  int claimed_ = 0, right_ = 0, returns_ = 0, recognised_ = 0;
};

}  // namespace meander
