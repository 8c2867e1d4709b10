// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/picture.hpp"

#include <cstdlib>

#include "render/draw_run.hpp"
#include "render/draw_world.hpp"
#include "render/picture_file.hpp"
#include "render/terminal.hpp"
#include "script/terminal_device.hpp"

namespace meander::script {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// Room for a still picture: the prompt follows it.
TerminalSize still_size() {
  const auto window = window_size();
  return window ? TerminalSize{window->columns, std::max(1, window->rows - 2)} : TerminalSize{};
}

}  // namespace

DrawList picture_of(const World& world) { return draw_world(world); }

DrawList picture_of(const Sim& sim) {
  WorldLook look;
  look.movers = false;
  DrawList list = draw_world(sim.world(), look);
  const Theme& colors = theme(look.background);
  for (const Pole& moving : sim.scene().moving) list.items.push_back(DrawDisc{moving.disc, colors.mover, Mark::mover});
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
          .graphics = environment("MEANDER_GRAPHICS")};
}

std::string terminal_picture(const DrawList& list, const Call& call) {
  const TerminalMode mode = terminal_mode(terminal_environment(call));
  const std::string picture = text(terminal_frame(list, still_size(), mode));
  return mode == TerminalMode::ascii ? picture + legend(list) + "\n" : picture;
}

void save_drawing(const std::string& path, const DrawList& list, const char* suffixes) {
  if (!path.ends_with(".svg") && !path.ends_with(".png")) fail("{}: unknown suffix, {} expected", path, suffixes);
  save_picture(path, list);
}

}  // namespace meander::script
