// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>

#include "geometry/vec.hpp"
#include "world/outline.hpp"

namespace meander {
namespace {

/// What a ring crosses: the piece of the line between the centres of a solid cell (left) and a free one (right) around
/// the step between them.
struct Gate {
  Vec2 middle;
  Vec2 forward;
};

Gate gate_of(const Outline::Step& step) {
  constexpr double kForward[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const auto& d = kForward[static_cast<int>(step.heading)];
  const Vec2 forward(d[0], d[1]);
  return {Vec2(step.from.x, step.from.y) + 0.5 * forward, forward};
}

/// The directions in which a straight line from one point passes all gates so far.
class Wedge {
 public:
  Wedge(const Vec2& from, double epsilon) : from_(from), epsilon_(epsilon) {}

  /// Narrows the wedge to the gate; false, and nothing changes, when no line passes it.
  bool narrow(const Gate& gate) {
    if (gate.forward.dot(gate.middle - from_) <= 0) return false;
    const Vec2 half = epsilon_ * left_of(gate.forward);
    return narrow(gate.middle - half - from_, gate.middle + half - from_);
  }
  bool narrow(const Vec2& point) { return narrow(point - from_, point - from_); }

  /// Where the lines of the wedge cross the gate, from the rightmost (share 0) to the leftmost (share 1).
  Vec2 crossing(const Gate& gate, double share) const {
    const Vec2 side = left_of(gate.forward);
    const Vec2 to_middle = gate.middle - from_;
    const auto offset = [&](const Vec2& direction) {
      const double length = to_middle.dot(gate.forward) / direction.dot(gate.forward);
      return (length * direction - to_middle).dot(side);
    };
    const double right = offset(right_), left = offset(left_);
    return gate.middle + std::clamp(right + share * (left - right), -epsilon_, epsilon_) * side;
  }

 private:
  bool narrow(const Vec2& right, const Vec2& left) {
    const Vec2 new_right = !empty_ && cross(right_, right) < 0 ? right_ : right;
    const Vec2 new_left = !empty_ && cross(left_, left) > 0 ? left_ : left;
    if (cross(new_right, new_left) < 0) return false;
    right_ = new_right;
    left_ = new_left;
    empty_ = false;
    return true;
  }

  Vec2 from_;
  double epsilon_;
  Vec2 right_{0, 0}, left_{0, 0};
  bool empty_ = true;  ///< no gate yet: every direction
};

/// The outline as a ring of steps, counted on beyond its end.
class Ring {
 public:
  Ring(const Outline& outline, double epsilon) : steps_(outline.steps), epsilon_(epsilon) {}

  /// Steps that begin at a right angle worth keeping: both sides of it are walls of their own, not steps of a stair,
  /// which is how a raster shows a slanted wall.
  std::vector<std::size_t> right_angles() const {
    std::vector<std::size_t> turns, result;
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (steps_[i].turn != 0) turns.push_back(i);
    const std::size_t n = turns.size();
    const auto stair = [&](std::size_t t) {
      const std::size_t first = turns[t % n], next = turns[(t + 1) % n];
      return (first + 1) % steps_.size() == next && steps_[first].turn != steps_[next].turn;
    };
    for (std::size_t t = 0; t < n; ++t)
      if (!steps_[turns[t]].pinched && !stair(t) && !stair(t + n - 1)) result.push_back(turns[t]);
    return result;
  }

  Vec2 corner(std::size_t step) const {
    const Cell from = steps_[step % steps_.size()].from;
    return {from.x, from.y};
  }
  Gate gate(std::size_t step) const { return gate_of(steps_[step % steps_.size()]); }

  /// Appends the corners from `start` through the gates first .. last - 1 up to, but without, `goal`.
  void route(const Vec2& start, std::size_t first, std::size_t last, const Vec2& goal,
             std::vector<Vec2>& corners) const {
    const Stretch whole{first, last, goal};
    for (Line line = longest(start, whole); corners.push_back(line.from), line.end <= last;)
      line = next(line, {line.end, last, goal});
  }

 private:
  /// Gates first .. last - 1, and a point after them.
  struct Stretch {
    std::size_t first, last;
    Vec2 goal;
  };
  /// What a straight line can do from a point on.
  struct Line {
    Vec2 from;
    Wedge wedge;
    std::size_t end;  ///< the first gate that it cannot pass; last: the goal; last + 1: it reaches the goal
  };

  Line longest(const Vec2& from, const Stretch& stretch) const {
    Line line{from, Wedge(from, epsilon_), stretch.first};
    while (line.end < stretch.last && line.wedge.narrow(gate(line.end))) ++line.end;
    if (line.end == stretch.last && line.wedge.narrow(stretch.goal)) ++line.end;
    return line;
  }

  /// The line that goes on from where the last one ends: of a few places on its last gate the one from which it gets
  /// farthest, the middle one if in doubt.
  Line next(const Line& line, const Stretch& rest) const {
    const Gate last_gate = gate(line.end - 1);
    Line best = longest(line.wedge.crossing(last_gate, 0.5), rest);
    for (const double share : {0.25, 0.75, 0.0, 1.0}) {
      Line other = longest(line.wedge.crossing(last_gate, share), rest);
      if (other.end > best.end) best = other;
    }
    return best;
  }

  const std::vector<Outline::Step>& steps_;
  double epsilon_;
};

}  // namespace

std::vector<Vec2> straightened(const Outline& outline, double epsilon) {
  const Ring ring(outline, epsilon);
  const std::size_t count = outline.steps.size();
  const std::vector<std::size_t> angles = ring.right_angles();
  std::vector<Vec2> corners;
  if (angles.empty()) {
    const Vec2 start = ring.gate(0).middle;
    ring.route(start, 1, count, start, corners);
  }
  for (std::size_t a = 0; a < angles.size(); ++a) {
    const std::size_t next = a + 1 < angles.size() ? angles[a + 1] : angles[0] + count;
    ring.route(ring.corner(angles[a]), angles[a], next, ring.corner(next), corners);
  }
  return corners;
}

}  // namespace meander
