// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lauxlib.h>

#include "geometry/angle.hpp"
#include "script/any.hpp"
#include "script/bind.hpp"
#include "script/help_text.hpp"
#include "script/kit_module.hpp"

namespace meander::script {

namespace {

double deg(double angle) { return radians(angle); }
double rad(double angle) { return degrees(angle); }

void show(const Any& value, const Call& call) {
  if (lua_isnoneornil(value.L, value.index) || luaL_getmetafield(value.L, value.index, "__show") == LUA_TNIL)
    fail("something that can be seen expected (a world, a sim, a run, a reading), got {}",
         describe(value.L, value.index));
  lua_pushvalue(value.L, value.index);
  lua_call(value.L, 1, 1);
  call.write(read_text(value.L, -1, Path{.kind = Path::Kind::value, .name = "__show"}));
}

const Record* record_meant(const Any& what, const Docs& docs) {
  if (lua_type(what.L, what.index) != LUA_TSTRING) {
    const Record* record = record_of(what.L, what.index);
    if (record) return record;
    fail("a name, a function of meander or one of its objects expected, got {}", describe(what.L, what.index));
  }
  const std::string name = lua_tostring(what.L, what.index);
  const Record* record = find_record(docs, name);
  if (!record) fail("nothing is known about '{}'{}", name.substr(0, 60), did_you_mean(name, record_names(docs)));
  return record;
}

void help(const std::optional<Any>& what, const Call& call) {
  const Docs& docs = session(call.L).docs;
  call.write(what ? help_text(docs, *record_meant(*what, docs)) : overview_text(docs));
}

void apropos(const std::string& word, const Call& call) {
  const std::string found = apropos_text(session(call.L).docs, word);
  call.write(found.empty() ? "nothing is known about '" + word + "'\n" : found);
}

}  // namespace

void bind_help(lua_State* L) {
  Module(L, "", "")
      .function<&deg>(
          Doc{.name = "deg",
              .text = "An angle given in degrees, in radians: heading = deg(30); math.deg goes the other way.",
              .args = {{"angle", "in degrees"}},
              .returns = "the angle in radians",
              .example = "print(deg(180))"})
      .function<&rad>(Doc{
          .name = "rad",
          .text =
              "An angle given in radians, in degrees: the reverse of deg, for printing; math.rad goes the other way.",
          .args = {{"angle", "in radians", "rad"}},
          .returns = "the angle in degrees",
          .example = "print(rad(math.pi))"})
      .function<&show>(Doc{.name = "show",
                           .text = "Draws an object in the terminal: a world, a sim, a run, a sonar reading.",
                           .args = {{"object", "what to draw"}},
                           .errors = "something that has no picture",
                           .example = "show(meander.world.open 'worlds/office.toml')"})
      .function<&help>(
          Doc{.name = "help",
              .text = "Says what something is and how it is used.",
              .args = {{"what", "a function, module or object of meander, or a name; everything when left out"}},
              .errors = "nothing is known about it",
              .example = "help 'sim:drive'"})
      .function<&apropos>(Doc{.name = "apropos",
                              .text = "Lists everything whose name, description or options contain a word.",
                              .args = {{"word", "what to look for"}},
                              .example = "apropos 'sonar'"});
}

}  // namespace meander::script
