// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lauxlib.h>

#include "base/visible_text.hpp"
#include "geometry/angle.hpp"
#include "script/any.hpp"
#include "script/bind.hpp"
#include "script/help_text.hpp"
#include "script/kit_module.hpp"
#include "script/picture.hpp"
#include "script/terminal_device.hpp"
#include "script/wrapped_text.hpp"

namespace meander::script {
namespace {

double deg(double angle) { return radians(angle); }
double rad(double angle) { return degrees(angle); }

void show(const Any& value, const Call& call) { call.write(terminal_picture(*drawing_of(value.L, value.index), call)); }

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

/// Lines are broken for a terminal only: files and pipes may want to find words that stand beside each other.
std::size_t line_width(const Call& call) { return session(call.L).write ? 0 : text_width(); }

void help(const std::optional<Any>& what, const Call& call) {
  const Docs& docs = session(call.L).docs;
  const std::size_t width = line_width(call);
  call.write(what ? help_text(docs, *record_meant(*what, docs), width) : wrapped(overview_text(docs), width));
}

void apropos(const std::string& word, const Call& call) {
  const std::string found = apropos_text(session(call.L).docs, word);
  call.write(found.empty() ? "nothing is known about '" + visible_text(word) + "'\n"
                           : wrapped(found, line_width(call)));
}

}  // namespace

void bind_help(lua_State* L) {
  Module(L, "", "")
      .function<&deg>(Doc{
          .name = "deg",
          .text =
              "Radians from degrees: heading = deg(30). Angles are in radians everywhere; Lua's math.rad is the same.",
          .args = {{"angle", "in degrees"}},
          .returns = "the angle in radians",
          .example = "print(deg(180))"})
      .function<&rad>(
          Doc{.name = "rad",
              .text = "Degrees from radians: rad(math.pi) is 180. For printing angles; Lua's math.deg is the same.",
              .args = {{"angle", "in radians", "rad"}},
              .returns = "the angle in degrees",
              .example = "print(rad(math.pi))"})
      .function<&show>(
          Doc{.name = "show",
              .text = "Draws in the terminal: a world, a sim, a run, a sonar reading, a picture; numbers as a curve, a "
                      "matrix or a list of rows as a heat map.",
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
