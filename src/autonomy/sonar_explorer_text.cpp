// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/sonar_explorer_text.hpp"

#include "base/atomic_file.hpp"
#include "base/text_file.hpp"
#include "indicator/indicator_text.hpp"
#include "indicator/occupancy_text.hpp"
#include "indicator/option_text.hpp"

namespace meander {
namespace {

constexpr const char* kKind = "sonar_explorer";
constexpr std::size_t kMostBytes = 256u << 20;

}  // namespace

std::string to_text(const SonarExplorer& explorer) {
  return fmt::format("meander {} 1\n", kKind) + goal_line(explorer.goal()) + option_lines(explorer.options()) +
         option_lines(explorer.platform(), "robot.") + occupancy_lines(explorer.map()) + explorer.doors_.lines() +
         explorer.tried_.lines() + state_lines(explorer.explorer());
}

std::shared_ptr<SonarExplorer> sonar_explorer_from_text(const std::string& text, const std::string& path) {
  TextLines lines(text, path);
  check_header(lines, kKind);
  const Vec2 goal = read_goal_line(lines);
  SonarExplorerOptions options;
  read_option_lines(lines, options);
  check_options(lines, options);
  Platform robot;
  read_option_lines(lines, robot, "robot.");
  check_options(lines, robot);
  auto explorer = std::make_shared<SonarExplorer>(goal, robot, options);
  read_occupancy_lines(lines, explorer->map_);
  explorer->doors_.read(lines, explorer->map_);
  explorer->tried_.read(lines);
  read_state_lines(lines, explorer->explorer_);
  return explorer;
}

void write_sonar_explorer(const SonarExplorer& explorer, const std::string& path) {
  write_file_atomically(path, to_text(explorer));
}
std::shared_ptr<SonarExplorer> read_sonar_explorer(const std::string& path) {
  return sonar_explorer_from_text(read_text_file(path, kMostBytes), path);
}

}  // namespace meander
