// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/objects.hpp"

namespace meander::script {
namespace {

const Item& item(const Thing& thing) { return thing.world->item(thing.id); }
std::string name(const Thing& thing) { return name_of(item(thing)); }
std::string kind(const Thing& thing) { return kind_of(item(thing)); }
int number(const Thing& thing) { return static_cast<int>(thing.id.slot) + 1; }
bool alive(const Thing& thing) { return thing.world->alive(thing.id); }
std::shared_ptr<World> world(const Thing& thing) { return thing.world; }

std::string text(const Thing& thing) {
  if (!alive(thing)) return fmt::format("removed thing {}", number(thing));
  return fmt::format("{} {} \"{}\"", kind(thing), number(thing), name(thing));
}

bool equal(const Thing& a, const Thing& b) { return a.world == b.world && a.id == b.id; }

}  // namespace

void bind_thing(lua_State* L) {
  Type<Thing>(
      L,
      "A thing in a world. Its handle stays the same when it is moved, renamed, or removed and brought back. In "
      "another world, such as a fork, it means the thing of the same number and name; if there is none, that is "
      "an error.")
      .property<&name>(PropertyDoc{.name = "name",
                                   .text = "Its name.",
                                   .example = "print(meander.world.open('worlds/office.toml'):thing('hall').name)"})
      .property<&kind>(PropertyDoc{.name = "kind",
                                   .text = "'obstacle', 'door', 'mover', 'light' or 'place'.",
                                   .example = "print(meander.world.open('worlds/office.toml'):thing('hall').kind)"})
      .property<&number>(PropertyDoc{.name = "number",
                                     .text = "Its number in the order of adding.",
                                     .example = "print(meander.world.open('worlds/office.toml'):thing('hall').number)"})
      .property<&alive>(PropertyDoc{.name = "alive",
                                    .text = "Is it in the world? False after it was removed, true again after undo.",
                                    .example = "print(meander.world.open('worlds/office.toml'):thing('hall').alive)"})
      .property<&world>(PropertyDoc{.name = "world",
                                    .text = "The world it is in.",
                                    .example = "print(meander.world.open('worlds/office.toml'):thing('hall').world)"})
      .text<&text>()
      .equal<&equal>();
}

}  // namespace meander::script
