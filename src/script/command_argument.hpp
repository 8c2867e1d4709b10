// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "robot/observation.hpp"
#include "script/kit_options.hpp"

namespace meander {

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, Command>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"v", "m/s", "forward speed"}, o.v);
  visit(Field{"w", "rad/s", "turning rate, counter-clockwise"}, o.w);
  visit(Field{"vy", "m/s", "speed to the left; 0 for unicycles"}, o.vy);
}

}  // namespace meander

namespace meander::script {

/// What sim:step takes: a speed (the turning rate is the next argument), one command, or a list of commands.
struct CommandArgument {
  std::optional<double> v;
  std::vector<Command> commands;
  /// One command per robot; throws ArgumentError when the numbers differ.
  std::vector<Command> for_robots(std::size_t count, const std::optional<double>& w) const;
};
template <>
struct Lua<CommandArgument> {
  static CommandArgument read(lua_State* L, int index, const Path& path);
  static std::string type() { return "number, {v =, w =} or list of {v =, w =}"; }
};

}  // namespace meander::script
