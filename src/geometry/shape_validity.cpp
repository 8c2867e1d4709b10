// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Judge the coordinates as they are: the rescaling to integers of older Boost versions would merge points that are
// nearer than a ten-millionth of the extent.
#define BOOST_GEOMETRY_NO_ROBUSTNESS
#define BOOST_ALLOW_DEPRECATED_HEADERS  // of those that Boost.Geometry itself includes
#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry/algorithms/is_valid.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/index/rtree.hpp>

#include "geometry/segment.hpp"
#include "geometry/shapes.hpp"

namespace meander {
namespace {

namespace bg = boost::geometry;
using Complaint = std::optional<std::string>;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false, false>;
using BoostBox = bg::model::box<BoostPoint>;

/// One edge of one ring, points counted from 1 as people do.
struct Edge {
  Vec2 a, b;
  std::string ring;  ///< "", "outer", "hole 2"
  std::size_t first, last;
};

std::string place(const Vec2& p) { return fmt::format("({:.6g}, {:.6g})", p.x(), p.y()); }

std::string prefix(const std::string& ring) { return ring.empty() ? "" : ring + ": "; }

bool usable(double coordinate) { return std::abs(coordinate) <= kFarthest; }  // false for nan

Complaint bad_position(const std::string& what, const Vec2& p) {
  if (usable(p.x()) && usable(p.y())) return {};
  return fmt::format("{}: two finite numbers within +-{:g} m expected, got ({}, {})", what, kFarthest, p.x(), p.y());
}

Complaint bad_length(const std::string& what, double length) {
  if (length >= kShortest && length <= kFarthest) return {};
  return fmt::format("{}: a number from {:g} to {:g} m expected, got {}", what, kShortest, kFarthest, length);
}

/// Number, finiteness and distinctness of the points of one run.
Complaint bad_points(const std::string& ring, const std::vector<Vec2>& p, std::size_t least, bool closed) {
  if (p.size() < least) return fmt::format("{}at least {} points expected, got {}", prefix(ring), least, p.size());
  if (p.size() > kMostPoints)
    return fmt::format("{}at most {} points expected, got {}", prefix(ring), kMostPoints, p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    if (auto complaint = bad_position(fmt::format("{}point {}", prefix(ring), i + 1), p[i])) return complaint;
  for (std::size_t i = 0; i < (closed ? p.size() : p.size() - 1); ++i) {
    const std::size_t next = (i + 1) % p.size();
    if ((p[next] - p[i]).norm() >= kShortest) continue;
    return fmt::format("{}points {} and {} are the same, {}{}", prefix(ring), i + 1, next + 1, place(p[i]),
                       next == 0 ? "; rings are closed without repeating the first point" : "");
  }
  return {};
}

std::vector<Edge> edges_of(const Polygon& polygon) {
  std::vector<Edge> edges;
  const auto add = [&](const std::string& name, const std::vector<Vec2>& p) {
    for (std::size_t i = 0; i < p.size(); ++i)
      edges.push_back({p[i], p[(i + 1) % p.size()], name, i + 1, (i + 1) % p.size() + 1});
  };
  add(polygon.holes.empty() ? "" : "outer", polygon.outer);
  for (std::size_t h = 0; h < polygon.holes.size(); ++h) add(fmt::format("hole {}", h + 1), polygon.holes[h]);
  return edges;
}

std::string name(const Edge& e) {
  return fmt::format("edge {}-{}{}{}", e.first, e.last, e.ring.empty() ? "" : " of ", e.ring);
}

bool neighbours(const Edge& e, const Edge& f) { return e.ring == f.ring && (e.last == f.first || f.last == e.first); }

/// Where two edges that are no neighbours meet, or neighbours fold back onto each other.
std::optional<Vec2> meeting(const Edge& e, const Edge& f) {
  const Vec2 d = e.b - e.a, g = f.b - f.a;
  const double across = cross(d, g);
  if (neighbours(e, f)) {
    const bool folded = std::abs(across) <= 1e-12 * d.norm() * g.norm() && d.dot(g) < 0;
    return folded ? std::optional(e.last == f.first ? e.b : e.a) : std::nullopt;
  }
  if (across != 0) {
    const double t = cross(f.a - e.a, g) / across, s = cross(f.a - e.a, d) / across;
    if (t >= 0 && t <= 1 && s >= 0 && s <= 1) return Vec2(e.a + t * d);
  }
  for (const Vec2& end : {f.a, f.b})
    if (distance_to_segment(end, e.a, e.b) <= kTouch) return end;
  for (const Vec2& end : {e.a, e.b})
    if (distance_to_segment(end, f.a, f.b) <= kTouch) return end;
  return {};
}

/// Names the first two edges that meet where they should not.
Complaint crossing(const Polygon& polygon) {
  const std::vector<Edge> edges = edges_of(polygon);
  using Entry = std::pair<BoostBox, std::size_t>;
  const auto box = [](const Edge& e) {
    const Vec2 low = e.a.cwiseMin(e.b), high = e.a.cwiseMax(e.b);
    return BoostBox{{low.x() - kTouch, low.y() - kTouch}, {high.x() + kTouch, high.y() + kTouch}};
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < edges.size(); ++i) entries.emplace_back(box(edges[i]), i);
  const bg::index::rtree<Entry, bg::index::quadratic<16>> tree(entries);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    std::vector<Entry> near;
    tree.query(bg::index::intersects(box(edges[i])), std::back_inserter(near));
    std::sort(near.begin(), near.end(), [](const Entry& a, const Entry& b) { return a.second < b.second; });
    for (const auto& [_, j] : near) {
      if (j <= i) continue;
      const Edge &e = edges[i], &f = edges[j];
      if (const auto at = meeting(e, f))
        return fmt::format("{} and {} {} at {}", name(e), name(f), neighbours(e, f) ? "overlap" : "meet", place(*at));
    }
  }
  return {};
}

BoostPolygon to_boost(const Polygon& polygon) {
  BoostPolygon result;
  for (const Vec2& p : polygon.outer) result.outer().emplace_back(p.x(), p.y());
  for (const auto& hole : polygon.holes) {
    result.inners().emplace_back();
    for (const Vec2& p : hole) result.inners().back().emplace_back(p.x(), p.y());
  }
  return result;
}

/// Which hole lies outside the outer ring or in another hole, given that no edges meet.
Complaint misplaced_hole(const Polygon& polygon) {
  for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
    if (!contains(Polygon{polygon.outer, {}}, polygon.holes[h][0]))
      return fmt::format("hole {} at {} lies outside the outer ring", h + 1, place(polygon.holes[h][0]));
    for (std::size_t other = 0; other < polygon.holes.size(); ++other)
      if (other != h && contains(Polygon{polygon.holes[other], {}}, polygon.holes[h][0]))
        return fmt::format("hole {} at {} lies inside hole {}", h + 1, place(polygon.holes[h][0]), other + 1);
  }
  return {};
}

Complaint bad(const Chain& c) { return bad_points("", c.points, c.closed ? 3 : 2, c.closed); }

Complaint bad(const Polygon& polygon) {
  std::size_t points = polygon.outer.size();
  if (auto complaint = bad_points(polygon.holes.empty() ? "" : "outer", polygon.outer, 3, true)) return complaint;
  for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
    if (auto complaint = bad_points(fmt::format("hole {}", h + 1), polygon.holes[h], 3, true)) return complaint;
    points += polygon.holes[h].size();
  }
  if (points > kMostPoints) return fmt::format("at most {} points expected, got {}", kMostPoints, points);
  std::string reason;
  if (bg::is_valid(to_boost(std::get<Polygon>(canonical(polygon))), reason)) return {};
  if (auto complaint = crossing(polygon)) return complaint;
  if (auto complaint = misplaced_hole(polygon)) return complaint;
  return "no proper area: " + reason;
}

Complaint bad(const Rectangle& r) {
  if (auto complaint = bad_position("center", r.center)) return complaint;
  if (auto complaint = bad_length("size: width", r.size.x())) return complaint;
  if (auto complaint = bad_length("size: height", r.size.y())) return complaint;
  if (!usable(r.heading))
    return fmt::format("heading: an angle within +-{:g} rad expected, got {}", kFarthest, r.heading);
  return {};
}

Complaint bad(const Disc& d) {
  if (auto complaint = bad_position("center", d.center)) return complaint;
  return bad_length("radius", d.radius);
}

}  // namespace

std::optional<std::string> invalid(const Shape& shape) {
  return std::visit([](const auto& kind) { return bad(kind); }, shape);
}

}  // namespace meander
