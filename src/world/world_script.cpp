// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <fmt/format.h>

#include <limits>
#include <map>

#include "world/attributes.hpp"
#include "world/world_diff.hpp"

namespace meander {
namespace {

/// "{ center = {1, 2}, name = "crate" }": the name last, as people write it. `complete` spells out usual values too.
std::string table_text(const Attributes& attributes, bool complete) {
  std::string text = "{ ";
  const auto append = [&](const Attribute& attribute) {
    if (text.size() > 2) text += ", ";
    text += attribute.key + std::string(" = ") + value_text(attribute.value, kLua);
  };
  for (const Attribute& attribute : attributes)
    if (std::string(attribute.key) != "name" && (complete || !attribute.usual)) append(attribute);
  for (const Attribute& attribute : attributes)
    if (std::string(attribute.key) == "name") append(attribute);
  return text + " }";
}

const char* method(const Item& item) {
  static constexpr const char* kForShape[] = {"add_wall", "add_polygon", "add_box", "add_disc"};
  static constexpr const char* kForKind[] = {nullptr, "add_door", "add_mover", "add_light", "add_place"};
  const auto* obstacle = std::get_if<Obstacle>(&item);
  return obstacle ? kForShape[obstacle->shape.index()] : kForKind[item.index()];
}

class ScriptWriter {
 public:
  void begin(const World& base) {
    text_ = "local world = meander.world.new " + table_text(attributes(base.header()), false) + "\n";
    for (const Id id : base.ids()) write(Add{id, base.item(id)}, "");
  }

  void step(const World::Step& step) {
    const bool several = step.forward.size() > 1;
    if (several) text_ += "world:transaction(function()\n";
    for (const Edit& edit : step.forward) std::visit([&](const auto& e) { write(e, several ? "  " : ""); }, edit);
    if (several) text_ += "end)\n";
  }

  std::string finished() && { return std::move(text_) + "return world\n"; }

 private:
  void write(const Add& add, const char* indent) {
    text_ += fmt::format("{}world:{} {}\n", indent, method(add.item), table_text(attributes(add.item), false));
    names_[add.id] = name_of(add.item);
  }
  void write(const Remove& remove, const char* indent) {
    text_ += fmt::format("{}world:remove({})\n", indent, kLua.quoted(names_[remove.id]));
  }
  void write(const Replace& replace, const char* indent) {
    text_ += fmt::format("{}world:replace({}, {})\n", indent, kLua.quoted(names_[replace.id]),
                         table_text(attributes(replace.item), true));
    names_[replace.id] = name_of(replace.item);
  }
  void write(const SetHeader& set, const char* indent) {
    std::string table = table_text(attributes(set.header), true);
    if (!set.header.start) table.insert(table.size() - 2, ", start = false");
    text_ += fmt::format("{}world:set {}\n", indent, table);
  }

  std::string text_;
  std::map<Id, std::string> names_;  ///< as of the line being written
};

}  // namespace

std::string world_script(const World& world) {
  World base = world;
  base.undo(std::numeric_limits<int>::max());
  ScriptWriter writer;
  writer.begin(base);
  for (const World::Step& step : world.history()) writer.step(step);
  return std::move(writer).finished();
}

}  // namespace meander
