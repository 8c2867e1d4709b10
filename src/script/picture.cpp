// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/picture.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

#include "render/draw_run.hpp"
#include "render/draw_world.hpp"
#include "render/picture_file.hpp"
#include "render/terminal.hpp"

namespace meander::script {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

TerminalSize terminal_size() {
  winsize size{};
  if (isatty(STDOUT_FILENO) && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 2)
    return {std::min<int>(size.ws_col, 1000), std::min<int>(size.ws_row - 2, 1000)};  // room for the prompt
  return {};
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
    draw_scan(list, options.platform.sonar, options.sonar, sim.state(i).pose_world, sim.observation(i).readings.sonar);
    draw_robot(list, sim.state(i).pose_world, options.platform.body.radius, colors);
  }
  return list;
}

void draw_scan(DrawList& list, const RingLayout& layout, const SonarOptions& sonar, const Pose2& pose,
               std::span<const double> ranges) {
  const std::vector<Pose2> transducers = transducer_poses(layout, pose);
  if (transducers.size() != ranges.size()) return;
  draw_readings(list, {transducers, ranges, sonar.half_cone, sonar.range_max}, theme(Background::light));
}

std::vector<Pose2> transducer_poses(const RingLayout& layout, const Pose2& pose) {
  std::vector<Pose2> poses;
  for (int i = 0; i < layout.count; ++i) {
    const double bearing = layout.first + 2 * kPi * i / layout.count;
    const SinCos t = sin_cos(bearing);
    poses.push_back(pose * Pose2{layout.radius * t.cos, layout.radius * t.sin, wrap_angle(bearing)});
  }
  return poses;
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

std::string terminal_picture(const DrawList& list, const Call& call) {
  const TerminalMode mode = terminal_mode({.is_terminal = session(call.L).terminal,
                                           .term = environment("TERM"),
                                           .colorterm = environment("COLORTERM"),
                                           .no_color = environment("NO_COLOR"),
                                           .force_color = environment("CLICOLOR_FORCE"),
                                           .graphics = environment("MEANDER_GRAPHICS")});
  const std::string picture = text(terminal_frame(list, terminal_size(), mode));
  return mode == TerminalMode::ascii ? picture + legend(list) + "\n" : picture;
}

void save_drawing(const std::string& path, const DrawList& list, const char* suffixes) {
  if (!path.ends_with(".svg") && !path.ends_with(".png")) fail("{}: unknown suffix, {} expected", path, suffixes);
  save_picture(path, list);
}

}  // namespace meander::script
