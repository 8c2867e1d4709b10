// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/hash.hpp"
#include "world/edit.hpp"

namespace meander {

/// The truth: what stands where. A value: copying it is forking it. Every change is an Edit that is checked before it
/// changes anything, and can be undone. What is refused stands in validity.hpp (a thing by itself) and placement.hpp
/// (things against each other).
class World {
 public:
  World() = default;
  explicit World(Header header);

  // --- reading -------------------------------------------------------------------------------------------------------
  const Header& header() const { return header_; }
  /// All living things in slot order, which is the order in which they were added.
  std::vector<Id> ids() const;
  std::size_t size() const { return by_name_.size(); }
  bool alive(Id id) const;
  /// Throws StaleError that says what was removed.
  const Item& item(Id id) const;
  /// By name; throws ArgumentError with the nearest name.
  Id find(const std::string& name) const;
  bool has(const std::string& name) const { return by_name_.contains(name); }
  std::vector<std::string> names() const;
  /// Number of slots ever used; slot -> item is what the simulation indexes by.
  std::size_t slots() const { return slots_.size(); }
  /// The living item in a slot, or nullptr.
  const Item* slot(std::uint32_t slot) const;
  Id id_at(std::uint32_t slot) const;

  // --- editing -------------------------------------------------------------------------------------------------------
  /// Adds a thing; an empty name becomes "kind number". Throws ArgumentError and changes nothing when it is not valid.
  Id add(Item item);
  void remove(Id id);
  /// The new thing is of the same kind; an empty name keeps the old one.
  void replace(Id id, Item item);
  void set_header(Header header);
  /// The four above as one. An added thing gets the id that the edit says, so that a log can be replayed.
  void apply(const Edit& edit);

  /// Undoes / redoes up to `steps` steps (a transaction is one step); returns how many were there.
  int undo(int steps = 1);
  int redo(int steps = 1);
  /// All or nothing: when `body` throws, everything it did is taken back and the exception goes on. Inside, things may
  /// stand in each other's way for a while: that is checked at the end of the outermost transaction. A world cannot be
  /// copied, undone or redone inside.
  void transaction(const std::function<void()>& body);
  /// What stands now is the beginning: undo() goes no further back.
  void forget_history();

  /// Every edit ever applied, undos included, oldest first. revision() is its length; a simulation that has seen n of
  /// them catches up by reading from n on.
  const std::vector<Edit>& log() const { return log_; }
  std::uint64_t revision() const { return log_.size(); }

  /// One undo step: what was done, and what takes it back when applied in reverse order.
  struct Step {
    std::vector<Edit> forward;
    std::vector<Edit> backward;
  };
  /// The steps that stand, oldest first: undone ones are not among them.
  const std::vector<Step>& history() const { return done_; }

  /// Hash of header and living items (not of the history).
  std::uint64_t hash() const;
  /// Same header and same living items under the same names, in the same order.
  bool operator==(const World& other) const;

 private:
  struct Slot {
    std::uint32_t generation = 0;   ///< of the thing that is or was here last
    std::uint32_t generations = 0;  ///< ever given out
    std::optional<Item> item;
  };
  /// The transaction that is going on.
  struct Open {
    int depth = 0;
    Step step;
    Open() = default;
    Open(const Open& other);
    Open& operator=(const Open& other);  // also where a world is moved: both refuse while a transaction is going on
  };
  class Rollback;

  Id next_id() const;
  std::string free_name(const Item& item, std::uint32_t slot) const;
  Edit completed(Edit edit) const;
  void check(const Edit& edit) const;
  void check_id(const Add& add) const;
  void check_name_free(const std::string& name, Id user) const;
  void check_placement(const Edit& edit) const;
  void check_item_placement(const Item& item) const;
  void check_header_placement(const Header& header) const;
  void check_all_placements() const;
  void check_no_transaction(const char* what) const;
  [[noreturn]] void refuse_stale(Id id) const;

  void perform(const Edit& edit);
  Edit inverse_of(const Edit& edit) const;
  void put(Id id, const Item& item);
  void take(Id id);
  void take_back(Step& step, std::size_t down_to);

  Open open_;  // the first member: refuses a copy before any other is touched
  Header header_;
  std::vector<Slot> slots_;
  std::uint32_t next_slot_ = 0;  ///< undoing an addition gives its slot back, for another generation
  std::map<std::string, Id> by_name_;
  std::set<std::uint32_t> standing_;  ///< slots of things that need free ground
  std::vector<Edit> log_;
  std::vector<Step> done_;
  std::vector<Step> undone_;
};

}  // namespace meander
