// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>

#include "topology/route.hpp"
#include "topology/topologic_map.hpp"
#include "topology/whisker_drive.hpp"

namespace meander::topology {

struct RevisitOptions {
  double share = 0;     ///< of the behaviours, while links are doubted; 0: never
  int tries = 3;        ///< of a link that cannot be driven, before it is left alone
  int pause = 500;      ///< samples between two tries of a link
  int patience = 20;    ///< held up when it comes no farther in so many samples
  double beside = 0.6;  ///< links this near to one that is blocked, in the same direction, are doubted too [m]
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, RevisitOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"share", "", "of the behaviours that drive to doubted links, while there are any", 0, 1}, o.share);
  visit(Field{"tries", "", "of a link that cannot be driven, before it is left alone", 1, 1000}, o.tries);
  visit(Field{"pause", "", "samples between two tries of a link", 0, 1e9}, o.pause);
  visit(Field{"patience", "", "samples without progress until it is held up", 1, 1e6}, o.patience);
  visit(Field{"beside", "m", "links this near to a blocked one, in its direction, are doubted too", 0, 10}, o.beside);
}

/// Drives to the links of a map that contacts speak against and tries to pass them: [Z+] rule (8) never comes to links
/// behind a new wall, and contacts come to them by chance. A link that was passed is beyond doubt; one where contacts
/// hold the robot up has one more against it, which suspends it.
class Revisit {
 public:
  Revisit(std::shared_ptr<TopologicMap> map, const RevisitOptions& options);
  /// Plans the way to the nearest doubted link that is due; false when none is, or none can be reached.
  bool begin();
  /// Where to drive next, in the map's frame; nothing when this try is over. Call once after each sample.
  std::optional<Vec2> next(const WhiskerContacts& contacts);
  /// The link that was planned for last, from the end at which the robot comes to it.
  std::optional<std::pair<int, int>> link() const;
  /// Is this half of a link doubted, and to be tried now?
  bool due(int from, const Link& link) const;

 private:
  /// A link that was tried.
  struct Tried {
    int a, b;
    std::uint64_t serial_a, serial_b;
    int tries;            ///< without passing
    std::int64_t sample;  ///< of the last
  };
  enum class Phase { approach, pass };

  const CellPool& cells() const { return map_->net().cells(); }
  Vec2 here() const { return map_->pose().position(); }
  Vec2 at(int cell) const { return cells()[cell].position; }
  const Tried* tried(int a, int b) const;
  void forget_removed();
  void aim();
  bool comes_nearer(double left);
  std::optional<Vec2> approach();
  std::optional<Vec2> pass(const WhiskerContacts& contacts);
  bool held_by(const WhiskerContacts& contacts) const;
  void judge(bool passed, bool blocked);
  void doubt_beside(const Vec2& direction);

  std::shared_ptr<TopologicMap> map_;
  RevisitOptions options_;
  std::vector<Tried> tried_;
  std::vector<int> way_;  ///< over the links; the last link is the one that is tried
  std::size_t next_ = 0;
  Phase phase_ = Phase::approach;
  std::uint64_t serial_a_ = 0, serial_b_ = 0;
  Vec2 start_{0, 0}, end_{0, 0};  ///< of the stretch that is driven, in the map's frame
  double nearest_ = 0;            ///< to the next place so far [m]
  int since_ = 0;                 ///< samples without coming nearer
  int held_ = 0;                  ///< of them with contacts ahead
};

}  // namespace meander::topology
