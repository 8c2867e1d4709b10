// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/fields.hpp"
#include "geometry/vec.hpp"

namespace meander {

/// Handle of an indicator. Its slot is the indicator's serial number, counted from 0; a slot that became free is given
/// out again with another generation.
struct IndicatorId {
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;
  bool operator==(const IndicatorId&) const = default;
  auto operator<=>(const IndicatorId&) const = default;
};

/// What is known of a way out: nothing yet, where it leads, that it was closed, that it led nowhere.
enum class PortState { unknown, linked, blocked, dead_end };
template <>
struct EnumNames<PortState> {
  static constexpr std::pair<PortState, const char*> entries[] = {{PortState::unknown, "unknown"},
                                                                  {PortState::linked, "linked"},
                                                                  {PortState::blocked, "blocked"},
                                                                  {PortState::dead_end, "dead_end"}};
};

/// A motion direction of an indicator, [DG] Figure 1.
struct Port {
  double direction = 0;                  ///< in the odometry frame [rad]
  double reach = 0;                      ///< seen open so far [m]
  PortState state = PortState::unknown;  ///< linked: `link` tells where to
  int link = -1;                         ///< index in links(); -1: none
  int tries = 0;                         ///< entered so often without knowing where it leads
  int passed = 0;                        ///< driven through so often, out or in
  int failures = 0;                      ///< found closed so often
  int closed_run = 0;                    ///< the run in which it was found closed last
  int misses = 0;                        ///< visits in a row at which it was not to be seen
  double bound = 0;                      ///< a way on over it to the goal is at least so long, as a map tells it [m]
};

/// A port, or (port -1) the indicator itself: a link by sight leaves by no port.
struct PortRef {
  IndicatorId indicator;
  int port = -1;
  bool operator==(const PortRef&) const = default;
};

/// A way between two ports that was driven (or, without ports, seen). Links of an indicator with itself and parallel
/// links occur.
struct Link {
  PortRef a, b;
  double length = 0;  ///< driven [m]
};

struct Indicator {
  IndicatorId id;
  Vec2 position{0, 0};  ///< in the odometry frame [m]
  std::vector<Port> ports;
  std::vector<int> links;  ///< indices, once per end
};

/// The map made of indicators: a multigraph whose nodes have ports, [DG] section 2. A link that was found closed is
/// taken out at once ([DG] rule 6), so that no route leads over it. Functions throw StaleError for an indicator that
/// was removed, ArgumentError for numbers that make no sense.
class IndicatorGraph {
 public:
  IndicatorId place(const Vec2& position);
  void remove(IndicatorId id);
  void move(IndicatorId id, const Vec2& position);

  int add_port(IndicatorId id, double direction, double reach);
  /// Puts ports in the place of those that it has, none of which may be linked: for maps, which tell them anew each
  /// time.
  void set_ports(IndicatorId id, std::vector<Port> ports);
  /// Ties two ports together; what they led to before is forgotten. Length > 0. Gives the link's index.
  int link(const PortRef& a, const PortRef& b, double length);
  void set_length(int link, double length);
  /// Takes the link away without closing its ports: nobody knows where they lead.
  void unlink(int link);
  /// The way was found closed: its link goes, the ports at both ends count as blocked.
  void block(const PortRef& ref, int run = 0);
  /// The way leads nowhere.
  void give_up(const PortRef& ref, int run = 0);
  /// A blocked port or dead end is unknown again.
  void reopen(const PortRef& ref);
  void set_tries(const PortRef& ref, int tries);
  void set_seen(const PortRef& ref, double reach, int misses);
  void pass(const PortRef& ref);  ///< the robot drove through

  bool alive(IndicatorId id) const;
  const Indicator& get(IndicatorId id) const;
  const Port& port(const PortRef& ref) const;
  /// Living indicators, in the order of their serial numbers.
  std::vector<IndicatorId> ids() const;
  std::size_t size() const { return living_; }
  std::size_t slots() const { return slots_.size(); }
  /// The indicator in a slot, or nullptr when there is none now.
  const Indicator* in_slot(std::size_t slot) const;
  const std::vector<Link>& links() const { return links_; }
  std::optional<PortRef> other_end(const PortRef& ref) const;  ///< none: not linked
  /// Changes with every edit.
  std::uint64_t revision() const { return revision_; }

  /// Generation that a slot has, or had last: for files.
  std::uint32_t generation(std::size_t slot) const { return slots_.at(slot).generation; }
  /// Puts what a file tells into a new slot at the end.
  IndicatorId restore(std::uint32_t generation, const std::optional<Indicator>& indicator);

 private:
  struct Slot {
    std::uint32_t generation = 0;
    std::optional<Indicator> indicator;
  };
  Indicator& at(IndicatorId id);
  Port& at(const PortRef& ref);
  void close(const PortRef& ref, PortState state, int run);
  void detach(const PortRef& end, int link);

  std::vector<Slot> slots_;
  std::vector<Link> links_;
  std::size_t living_ = 0;
  std::size_t no_free_before_ = 0;  ///< slots
  std::uint64_t revision_ = 0;
};

}  // namespace meander
