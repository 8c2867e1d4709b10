// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/run_file.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"

namespace meander {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;

std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

Json json_of(const Vec2& p) { return {p.x(), p.y()}; }
Json json_of(const Pose2& p) { return {p.x, p.y, p.heading}; }

/// All options of a struct by name, nested structs as objects.
template <Listed Options>
Json json_of(const Options& options) {
  Json object = Json::object();
  fields(options, [&](const Field& field, const auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (Listed<T>)
      object[field.name] = json_of(value);
    else if constexpr (NamedEnum<T>)
      object[field.name] = to_string(value);
    else
      object[field.name] = value;
  });
  return object;
}

Json json_of(const Subgoal& goal) {
  Json object{{"position", json_of(goal.position)}, {"tolerance", goal.tolerance}};
  if (goal.heading) object["heading"] = *goal.heading;
  if (!goal.name.empty()) object["name"] = goal.name;
  return object;
}

Json head(const Run& run) {
  Json goals = Json::array();
  for (const Subgoal& goal : run.goals) goals.push_back(json_of(goal));
  Json robot{{"platform", json_of(run.robot.platform)},
             {"sonar", json_of(run.robot.sonar)},
             {"drift", json_of(run.robot.drift)}};
  if (run.robot.start) robot["start"] = json_of(*run.robot.start);
  return {{"record", "meander run"},
          {"format", kFormat},
          {"version", MEANDER_VERSION},
          {"seed", run.seed},
          {"world", hex(run.world_hash)},
          {"navigator", run.navigator},
          {"guide", run.guide},
          {"sim", json_of(run.sim)},
          {"robot", robot},
          {"goals", goals}};
}

Json summary(const Run& run) {
  return {{"navigator", run.navigator},
          {"guide", run.guide},
          {"seed", run.seed},
          {"success", run.success},
          {"reason", run.reason},
          {"reached", run.reached},
          {"subgoals", run.subgoals},
          {"contacts", run.contacts},
          {"fault_contacts", run.fault_contacts},
          {"trapped", run.trapped},
          {"time", run.time},
          {"length", run.length},
          {"clearance_min", run.clearance_min},
          {"clearance_mean", run.clearance_mean},
          {"turning", run.turning},
          {"jerk", run.jerk},
          {"cycles", run.cycles},
          {"hash", hex(run.hash)}};
}

Json json_of(const RunStep& step) {
  Json object{{"t", step.time},
              {"pose", json_of(step.pose_world)},
              {"odometry", json_of(step.odometry)},
              {"command", {step.command.v, step.command.w}},
              {"v", step.v},
              {"w", step.w},
              {"clearance", step.clearance},
              {"touching", step.touching},
              {"status", to_string(step.status)},
              {"sonar", step.sonar}};
  if (!step.whisker.empty()) object["whisker"] = step.whisker;
  if (!step.light.empty()) object["light"] = step.light;
  return object;
}

void add_columns(std::string& head, const char* name, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) head += fmt::format(",{}_{}", name, i);
}
template <class Values>
void add_values(std::string& row, const Values& values) {
  for (const auto value : values) fmt::format_to(std::back_inserter(row), ",{}", value);
}

/// Text that is no UTF-8 must not keep a run from being saved.
std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::string summary_json(const Run& run) { return line(summary(run)); }

void save_jsonl(const Run& run, const std::string& path) {
  std::string text = line(head(run)) + '\n';
  for (const RunStep& step : run.steps) text += line(json_of(step)) + '\n';
  text += line(summary(run)) + '\n';
  write_file_atomically(path, text);
}

void save_csv(const Run& run, const std::string& path) {
  std::string text =
      "time,x,y,heading,odometry_x,odometry_y,odometry_heading,command_v,command_w,v,w,clearance,touching,status";
  const RunStep first = run.steps.empty() ? RunStep{} : run.steps.front();
  add_columns(text, "sonar", first.sonar.size());
  add_columns(text, "whisker", first.whisker.size());
  add_columns(text, "light", first.light.size());
  text += '\n';
  for (const RunStep& s : run.steps) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},{}", s.time, s.pose_world.x,
                   s.pose_world.y, s.pose_world.heading, s.odometry.x, s.odometry.y, s.odometry.heading, s.command.v,
                   s.command.w, s.v, s.w, s.clearance, int{s.touching}, to_string(s.status));
    add_values(text, s.sonar);
    add_values(text, s.whisker);
    add_values(text, s.light);
    text += '\n';
  }
  write_file_atomically(path, text);
}

}  // namespace meander
