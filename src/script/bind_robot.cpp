// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/robot_options.hpp"

namespace meander::script {
namespace {

Platform platform_options(const Preset<Platform>& robot) { return robot.value; }

}  // namespace

void bind_robot(lua_State* L) {
  Module(L, "meander.robot", "Kinds of robots.")
      .function<&platform_names>(Doc{.name = "platforms",
                                     .text = "The names that sim.new takes as robot.",
                                     .returns = "list of names",
                                     .example = "print(table.concat(meander.robot.platforms(), ' '))"})
      .function<&platform_options>(Doc{.name = "platform",
                                       .text = "A kind of robot in detail: body, sensor places, control period.",
                                       .args = {{"robot", "its name, or a table that changes one"}},
                                       .returns = "table of options, as sim.new takes it",
                                       .errors = "unknown name; a number out of range",
                                       .example = "print(meander.robot.platform('nomad200').body.radius)"});
}

}  // namespace meander::script
