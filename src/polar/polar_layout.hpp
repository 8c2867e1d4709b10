// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/fields.hpp"
#include "geometry/pose.hpp"

namespace meander {

/// How the rings' radii grow. [LM99] has uniform ones and names polar-logarithmic ones as future work.
enum class PolarRadii { uniform, log };
template <>
struct EnumNames<PolarRadii> {
  static constexpr std::pair<PolarRadii, const char*> entries[] = {{PolarRadii::uniform, "uniform"},
                                                                   {PolarRadii::log, "log"}};
};

/// fixed: as the options say for ever; self_organising: rings and sectors move to where the readings are.
enum class PolarPlacing { fixed, self_organising };
template <>
struct EnumNames<PolarPlacing> {
  static constexpr std::pair<PolarPlacing, const char*> entries[] = {
      {PolarPlacing::fixed, "fixed"}, {PolarPlacing::self_organising, "self_organising"}};
};

struct PolarLayoutOptions {
  int rings = 100;
  int sectors = 48;
  double scope = 2.54;
  PolarRadii radii = PolarRadii::uniform;
  double innermost = 0.05;
  PolarPlacing layout = PolarPlacing::fixed;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarLayoutOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"rings", "", "rings of units, the centre included", 4, 512}, o.rings);
  visit(Field{"sectors", "", "units on each ring", 8, 256}, o.sectors);
  visit(Field{"scope", "m", "radius of the outermost ring", 0.1, 100}, o.scope);
  visit(Field{"radii", "", "equally spaced, or growing by a constant factor"}, o.radii);
  visit(Field{"innermost", "m", "radius of ring 1 of logarithmic radii", 1e-3, 10}, o.innermost);
  visit(Field{"layout", "", "fixed, or rings and sectors move to where the readings are"}, o.layout);
}

/// Angle of (x, y) to within kCoarse, several times faster than angle_of: enough to tell a sector.
inline constexpr double kCoarse = 0.005;
inline double coarse_angle(double y, double x) {
  const double ax = std::abs(x), ay = std::abs(y), high = std::max(ax, ay);
  if (!(high > 0)) return 0;
  const double t = std::min(ax, ay) / high;
  double a = t * (kPi / 4 + 0.273 * (1 - t));
  if (ay > ax) a = kPi / 2 - a;
  if (x < 0) a = kPi - a;
  return y < 0 ? -a : a;
}

/// The largest integer <= x, for |x| < 2^31.
inline int floor_of(double x) {
  const int i = static_cast<int>(x);
  return i - (i > x);
}

/// Where the units of a polar map lie [LM99, Figure 4]: ring 0 at the centre, the last ring at the scope; sector k at
/// the bearing 2 pi k / sectors of the map's frame, unless the layout organises itself.
class PolarLayout {
 public:
  explicit PolarLayout(const PolarLayoutOptions& options);

  int rings() const { return rings_; }
  int sectors() const { return sectors_; }
  double scope() const { return radii_.back(); }
  double radius(int ring) const { return radii_[static_cast<std::size_t>(ring)]; }
  const std::vector<double>& radii() const { return radii_; }
  double spacing() const { return spacing_; }  ///< between sectors, on average [rad]
  double bearing(int sector) const { return bearings_[static_cast<std::size_t>(sector)]; }
  /// Sectors are equally wide, for ever.
  bool even() const { return even_; }
  /// From this sector's direction to the next one's [rad].
  double gap(int sector) const { return gaps_[static_cast<std::size_t>(sector)]; }
  double width(int sector) const { return 0.5 * (gap(sector == 0 ? sectors_ - 1 : sector - 1) + gap(sector)); }
  /// Moves the rings and sectors of an uneven layout: increasing radii from 0 to the scope, increasing bearings from 0
  /// on, below 2 pi, as many as there are. Allocates nothing.
  void place(std::span<const double> radii, std::span<const double> bearings);
  const Vec2& direction(int sector) const { return directions_[static_cast<std::size_t>(sector)]; }
  Vec2 position(int ring, int sector) const { return radius(ring) * direction(sector); }

  /// The first ring that is not nearer than r; rings() beyond the scope.
  int first_ring_from(double r) const {
    int ring = ring_before(r);
    ring += edges_[static_cast<std::size_t>(ring)] < r;  // enough unless rings are very close
    while (edges_[static_cast<std::size_t>(ring)] < r) ++ring;
    return ring;
  }
  /// The first ring that is farther than r >= 0; rings() from the scope on.
  int first_ring_beyond(double r) const {
    int ring = ring_before(r);
    ring += edges_[static_cast<std::size_t>(ring)] <= r;
    while (edges_[static_cast<std::size_t>(ring)] <= r) ++ring;
    return ring;
  }
  int nearest_ring(double r) const {
    const int ring = std::min(first_ring_from(r), rings_ - 1);
    return ring > 0 && r - radius(ring - 1) < radius(ring) - r ? ring - 1 : ring;
  }
  int nearest_sector(double bearing) const {
    if (even_) return wrapped(floor_of(bearing / spacing_ + 0.5));
    const double turns = bearing / (2 * kPi), share = turns - floor_of(turns);
    int sector = sector_lookup_[static_cast<std::size_t>(share * kSectorBins * sectors_)];
    while (sector < sectors_ && share > borders_[static_cast<std::size_t>(sector)]) ++sector;
    return sector == sectors_ ? 0 : sector;
  }
  int wrapped(int sector) const {
    if (sector >= 0 && sector < sectors_) return sector;
    return (sector % sectors_ + sectors_) % sectors_;
  }
  /// How many sectors lie between two, the shorter way.
  int apart(int a, int b) const;

 private:
  int ring_before(double r) const {
    const double bin = std::min(std::max(0.0, r) * bins_per_metre_, static_cast<double>(lookup_.size() - 1));
    return lookup_[static_cast<std::size_t>(static_cast<int>(bin))];
  }

  void make_lookup();
  void look_up_sectors();
  static constexpr int kSectorBins = 4;  ///< per sector

  int rings_;
  int sectors_;
  double spacing_;
  std::vector<double> radii_;
  std::vector<double> bearings_;  ///< in (-pi, pi]
  std::vector<Vec2> directions_;
  bool even_;
  std::vector<double> gaps_;
  std::vector<double> borders_;     ///< behind each sector, in turns
  std::vector<int> sector_lookup_;  ///< a sector that is not beyond the one of the bin
  std::vector<double> edges_;       ///< the radii, and infinity
  double bins_per_metre_ = 0;
  std::vector<int> lookup_;  ///< a ring that is not beyond the first ring of the bin
};

}  // namespace meander
