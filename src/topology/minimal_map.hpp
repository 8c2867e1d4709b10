// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <vector>

#include "topology/growing_net.hpp"

namespace meander::topology {

/// The minimal model ([Z] section 3-5, "non-spatial mapping").
struct MinimalOptions {
  double adapt = 0.5;          ///< the light and touch nets adapt by this share of the whole map's rates
  double fade = 0.02;          ///< a_red of the light and touch nets
  double stable_place = 2.0;   ///< a place is known within this many accepted distances
  double stable_senses = 0.5;  ///< light and touch are known within this many
  double light_scale = 0.20;   ///< of the light net: coarser than the whole map's, or lights would be as many as places
  double jitter = 0.30;        ///< eps_jitter: a new border is no nearer than this to one that says the same [m]
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MinimalOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"adapt", "", "share of the map's rates at which the light and touch nets adapt", 0, 1}, o.adapt);
  visit(Field{"fade", "", "what the winner's other links lose together in the light and touch nets", 0, 1}, o.fade);
  visit(Field{"stable_place", "", "a place is known within this many accepted distances", 0, 100}, o.stable_place);
  visit(Field{"stable_senses", "", "light and touch are known within this many accepted distances", 0, 100},
        o.stable_senses);
  visit(Field{"light_scale", "", "light rings so different (root mean square) are clearly different", 1e-6, 1000},
        o.light_scale);
  visit(Field{"jitter", "m", "a border is not put this near to one that says the same", 0, 100}, o.jitter);
}

/// A cell of another net, as it was: the number may since stand for another.
struct SenseLink {
  int cell = -1;  ///< -1: none yet
  std::uint64_t serial = 0;
  bool operator==(const SenseLink&) const = default;
};

/// Three nets instead of one: places (N^g) that tell by links which of a few lights (N^l) and touches (N^t) is theirs.
/// A corner is stored once for all corners.
class MinimalMap {
 public:
  /// `net` and `scales` as of the whole map; `metric` gives the sizes of the rings.
  MinimalMap(const MinimalOptions& options, const NetOptions& net, const Scales& scales, int touch, int light);

  /// One situation: its senses are the whole map's row, touch first.
  void present(const Situation& situation, std::int64_t sample);

  const GrowingNet& geometry() const { return geometry_; }
  const GrowingNet& light() const { return light_; }
  const GrowingNet& touch() const { return touch_; }
  /// Links of a place; {-1} where there is none, or what it meant is gone.
  SenseLink light_of(int place) const { return valid(light_, links_of(place).light); }
  SenseLink touch_of(int place) const { return valid(touch_, links_of(place).touch); }

 private:
  struct PlaceLinks {
    std::uint64_t serial = 0;  ///< of the place that they belong to
    SenseLink light, touch;    ///< L^l and L^t
  };
  PlaceLinks links_of(int place) const;
  static SenseLink valid(const GrowingNet& net, const SenseLink& link);
  static SenseLink link_to(const GrowingNet& net, int cell) { return {cell, net.cells()[cell].serial}; }
  bool neighbour_says(int place, const Vec2& at, const SenseLink& light, const SenseLink& touch) const;
  void set_links(int place, const SenseLink& light, const SenseLink& touch);

  MinimalOptions options_;
  double accept_;
  GrowingNet geometry_, light_, touch_;
  std::vector<PlaceLinks> links_;             ///< by place
  std::vector<float> light_row_, touch_row_;  ///< scratch
};

/// Bytes that a map takes in numbers of `value` bytes: cells, senses and half links. The minimal map counts its three
/// nets and the links between them.
std::size_t map_bytes(const GrowingNet& net, std::size_t value);
std::size_t map_bytes(const MinimalMap& map, std::size_t value);

}  // namespace meander::topology
