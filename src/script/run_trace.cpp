// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/run_trace.hpp"

namespace meander::script {
namespace {

const double& figure(const RunStep& step, TraceName name) {
  switch (name) {
    case TraceName::time:
      return step.time;
    case TraceName::x:
      return step.pose_world.x;
    case TraceName::y:
      return step.pose_world.y;
    case TraceName::heading:
      return step.pose_world.heading;
    case TraceName::odometry_x:
      return step.odometry.x;
    case TraceName::odometry_y:
      return step.odometry.y;
    case TraceName::odometry_heading:
      return step.odometry.heading;
    case TraceName::command_v:
      return step.command.v;
    case TraceName::command_w:
      return step.command.w;
    case TraceName::v:
      return step.v;
    case TraceName::w:
      return step.w;
    case TraceName::clearance:
      return step.clearance;
  }
  return step.time;
}

}  // namespace

Numbers trace_of(const std::shared_ptr<RunRecord>& record, TraceName name) {
  const std::vector<RunStep>& steps = record->run.steps;
  if (steps.empty()) return {};
  return Numbers(record, &figure(steps.front(), name), steps.size(), sizeof(RunStep));
}

Matrix sonar_of(const Run& run) {
  auto cells = std::make_shared<std::vector<float>>();
  const std::size_t columns = run.steps.empty() ? 0 : run.steps.front().sonar.size();
  cells->reserve(run.steps.size() * columns);
  for (const RunStep& step : run.steps) cells->insert(cells->end(), step.sonar.begin(), step.sonar.end());
  return {std::move(cells), run.steps.size(), columns};
}

}  // namespace meander::script
