// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/hash.hpp"
#include "world/edit.hpp"

namespace meander {

/// The truth: what stands where. A value: copying it is forking it. Every change goes through apply(), which checks
/// everything before it changes anything, and can be undone.
class World {
 public:
  World() = default;
  explicit World(Header header);

  // --- reading -------------------------------------------------------------------------------------------------------
  const Header& header() const { return header_; }
  /// All living things in slot order.
  std::vector<Id> ids() const;
  bool alive(Id id) const;
  /// Throws StaleError that says what was removed.
  const Item& item(Id id) const;
  /// By name; throws ArgumentError with the nearest name.
  Id find(const std::string& name) const;
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
  void replace(Id id, Item item);
  void set_header(Header header);

  /// Undoes / redoes up to `steps` steps (a transaction is one step); returns how many were there.
  int undo(int steps = 1);
  int redo(int steps = 1);
  /// All or nothing: when `body` throws, everything it did is taken back and the exception goes on.
  void transaction(const std::function<void()>& body);

  /// Every edit ever applied, undos included, oldest first. revision() is its length; a simulation that has seen n of
  /// them catches up by reading from n on.
  const std::vector<Edit>& log() const { return log_; }
  std::uint64_t revision() const { return log_.size(); }

  /// Hash of header and living items (not of the history).
  std::uint64_t hash() const;
  /// Same header and same living items under the same names, in the same order.
  bool operator==(const World& other) const;

 private:
  struct Slot {
    std::uint32_t generation = 0;
    std::optional<Item> item;
    std::string last_name;  ///< for the message of a stale handle
  };
  void check(const Edit& edit) const;
  Edit perform(const Edit& edit);

  Header header_;
  std::vector<Slot> slots_;
  std::vector<Edit> log_;
  std::vector<std::vector<Edit>> done_;    ///< inverses, per undo step
  std::vector<std::vector<Edit>> undone_;
  int transaction_depth_ = 0;
};

}  // namespace meander
