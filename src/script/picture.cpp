// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/picture.hpp"

#include <cstdlib>

#include "render/draw_run.hpp"
#include "render/draw_world.hpp"
#include "render/picture_file.hpp"
#include "render/plot.hpp"
#include "render/still.hpp"
#include "script/terminal_device.hpp"
#include "script/terminal_query.hpp"
#include "script/values.hpp"

namespace meander {

std::size_t native_size(const DrawList& list) {
  std::size_t bytes = sizeof(DrawList) + list.items.size() * sizeof(DrawItem);
  for (const DrawItem& item : list.items)
    if (const auto* cells = std::get_if<DrawCells>(&item)) bytes += cells->colors.size() * (sizeof(Color) + 1);
  return bytes;
}

}  // namespace meander

namespace meander::script {
namespace {

DrawList heat_map(const Matrix& matrix) {
  return draw_heat_map(*matrix.cells, static_cast<int>(matrix.rows), static_cast<int>(matrix.columns));
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// Room for a still picture: the prompt follows it.
StillRoom still_room() {
  const auto window = window_size();
  if (!window) return {};
  const TerminalSize size{window->columns, std::max(1, window->rows - 2)};
  const CellSize cell = cell_size();
  return {size, size.columns * cell.width, size.rows * cell.height};
}

}  // namespace

DrawList picture_of(const World& world) { return draw_world(world); }

DrawList picture_of(const Sim& sim) {
  WorldLook look;
  look.movers = false;
  DrawList list = draw_world(sim.world(), look);
  const Theme& colors = theme(look.background);
  const std::vector<Pole>& moving = sim.scene().moving;  // robots first
  for (std::size_t i = sim.robot_count(); i < moving.size(); ++i)
    list.items.push_back(DrawDisc{moving[i].disc, colors.mover, Mark::mover});
  for (std::size_t i = 0; i < sim.robot_count(); ++i) {
    const RobotOptions& options = sim.robot(i);
    draw_scan(list, look_of(options), sim.state(i).pose_world, sim.observation(i).readings.sonar, colors);
    draw_robot(list, sim.state(i).pose_world, options.platform.body.radius, colors);
  }
  return list;
}

RobotLook look_of(const RingLayout& ring, const SonarOptions& sonar, double radius) {
  return {radius, ring, sonar.half_cone, sonar.range_max};
}

RobotLook look_of(const RobotOptions& robot) {
  return look_of(robot.platform.sonar, robot.sonar, robot.platform.body.radius);
}

DrawList picture_of(const Run& run, const World& world) {
  DrawList list = draw_world(world);
  std::vector<Pose2> poses;
  std::vector<Vec2> contacts;
  bool touched = false;
  for (const RunStep& step : run.steps) {
    poses.push_back(step.pose_world);
    if (step.touching && !touched) contacts.push_back(step.pose_world.position());
    touched = step.touching;
  }
  std::vector<TrackGoal> goals;
  for (std::size_t i = 0; i < run.goals.size(); ++i)
    goals.push_back({run.goals[i].position, run.goals[i].tolerance, static_cast<int>(i) < run.reached});
  draw_track(list, {poses, run.robot_radius, goals, contacts}, theme(Background::light));
  return list;
}

TerminalEnvironment terminal_environment(const Call& call) {
  return {.is_terminal = session(call.L).terminal,
          .term = environment("TERM"),
          .colorterm = environment("COLORTERM"),
          .no_color = environment("NO_COLOR"),
          .force_color = environment("CLICOLOR_FORCE"),
          .graphics = environment("MEANDER_GRAPHICS"),
          .multiplexed = !environment("TMUX").empty() || !environment("STY").empty()};
}

std::string terminal_picture(const DrawList& list, const Call& call) {
  const TerminalEnvironment environment = terminal_environment(call);
  const Session& session = script::session(call.L);
  const auto decided = still_mode(environment);
  const bool may_ask = !session.write && !session.stop.requested();  // a terminal may take its time to answer
  const StillMode still = decided ? *decided : may_ask ? asked_still_mode(session.at_prompt) : StillMode::characters;
  return still_picture(list, still_room(), still, terminal_mode(environment));
}

std::shared_ptr<const DrawList> drawing_of(lua_State* L, int index) {
  const Path path{.kind = Path::Kind::value, .name = "picture"};
  if (test_box(L, index, tag_of<DrawList>)) return read_object<DrawList>(L, index, path);
  if (is_nested(L, index)) return std::make_shared<DrawList>(heat_map(Lua<Rows>::read(L, index, path).matrix));
  if (lua_istable(L, index)) return std::make_shared<DrawList>(draw_curve(Lua<Drawn>::read(L, index, path).list));
  if (lua_isnoneornil(L, index) || luaL_getmetafield(L, index, "__show") == LUA_TNIL)
    fail("something that can be seen expected (a world, a sim, a run, a reading, numbers), got {}{}",
         describe(L, index), test_box(L, index, tag_of<Observation>) ? "; its .sonar can be shown" : "");
  lua_pushvalue(L, index);
  lua_call(L, 1, 1);
  const auto drawing = read_object<DrawList>(L, -1, path);
  lua_pop(L, 1);
  return drawing;
}

void save_drawing(const std::string& path, const DrawList& list, const char* suffixes) {
  if (!path.ends_with(".svg") && !path.ends_with(".png")) fail("{}: unknown suffix, {} expected", path, suffixes);
  save_picture(path, list);
}

}  // namespace meander::script
