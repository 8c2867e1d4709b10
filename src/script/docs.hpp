// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace meander::script {

/// One key of an option table, as its fields() listing tells it.
struct OptionDoc {
  std::string name{};
  std::string type{};  ///< as in messages: "number", "{x, y}", "'a' | 'b'"
  std::string unit{};
  std::string text{};
  std::string standard{};  ///< the default, empty where there is none
  bool required = false;
  std::vector<std::string> values{};  ///< of an enumeration or a preset name
  std::vector<OptionDoc> options{};   ///< of a nested table
};

/// One argument of a function or method; self is not counted.
struct ArgumentDoc {
  std::string name{};
  std::string type{};
  std::string unit{};
  std::string text{};
  bool optional = false;
  std::vector<std::string> values{};
  std::vector<OptionDoc> options{};
};

enum class DocKind { module, type, function, method, property, metamethod };

/// The one text about a name of the Lua surface: help(), completion, argument names in messages, annotation stubs and
/// the reference page all read it.
struct Record {
  DocKind kind = DocKind::function;
  std::string owner{};   ///< "meander.sim", "sim", or "" for globals
  std::string member{};  ///< "new", "drive"
  std::string text{};    ///< one or two sentences
  std::vector<ArgumentDoc> arguments{};
  std::string returns_type{};  ///< as in messages; empty when nothing is returned
  std::string returns{};
  std::string errors{};   ///< what makes the call fail, empty when nothing does
  std::string example{};  ///< runs as it stands after `meander` is loaded
  bool settable = false;

  /// "meander.sim.new", "sim:drive", "run.length", "world", "show".
  std::string name() const;
  /// Is a table of options its only argument?
  bool takes_options() const;
  /// The name with its arguments: "world:rename(thing, name)".
  std::string signature() const;
};

/// The member that stands for what [i] gives.
inline constexpr const char* kElementName = "[i]";

/// All records of one interpreter, in the order of registration. References stay valid.
class Docs {
 public:
  /// Records of metamethods only give messages their name: they are kept, but not listed.
  Record& add(Record record);
  const std::deque<Record>& all() const { return records_; }
  /// By full name ("sim:drive" or "sim.drive" alike), or nullptr.
  const Record* find(std::string_view name) const;
  /// What a module or a type offers, in the order of registration.
  std::vector<const Record*> members(std::string_view owner) const;
  /// What [i] of a type gives, or nullptr.
  const Record* element(std::string_view owner) const;

 private:
  std::deque<Record> records_;
  std::deque<Record> events_;
  std::map<std::string, const Record*, std::less<>> by_name_;
};

}  // namespace meander::script
