// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "render/draw_list.hpp"
#include "render/draw_scan.hpp"
#include "render/terminal_caps.hpp"
#include "script/kit_call.hpp"
#include "script/objects.hpp"

namespace meander {

std::size_t native_size(const DrawList& list);

}  // namespace meander

namespace meander::script {

template <>
struct ObjectName<DrawList> {
  static constexpr const char* value = "picture";
};

DrawList picture_of(const World& world);
/// This moment: robots, movers and the last scan.
DrawList picture_of(const Sim& sim);
/// The way through the world.
DrawList picture_of(const Run& run, const World& world);

/// What a picture must know of a robot.
RobotLook look_of(const RingLayout& ring, const SonarOptions& sonar, double radius);
RobotLook look_of(const RobotOptions& robot);

/// What the environment says about the terminal that the session writes to.
TerminalEnvironment terminal_environment(const Call& call);
/// What shows the picture on the terminal that the session writes to, as large as it is: graphics where it understands
/// them, else characters.
std::string terminal_picture(const DrawList& list, const Call& call);
/// The picture of a value: whatever a type shows (Type::picture), or a list of numbers. Throws ArgumentError.
std::shared_ptr<const DrawList> drawing_of(lua_State* L, int index);

/// Writes .svg or .png. Another suffix is an error that names `suffixes`, the ones that the caller takes.
void save_drawing(const std::string& path, const DrawList& list, const char* suffixes);

}  // namespace meander::script
