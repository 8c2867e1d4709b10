// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/command_argument.hpp"
#include "script/example_text.hpp"
#include "script/file_access.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/picture.hpp"
#include "script/robot_options.hpp"

namespace meander::script {

/// Everything sim.new takes: the world, one robot or several, and the clock.
struct SimTable : RobotTable {
  Required<std::shared_ptr<World>> world;
  std::optional<std::vector<RobotTable>> robots;
  SimOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SimTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"world", "", "where it happens; edits take effect at the next step"}, o.world);
  robot_fields(o, visit);
  visit(Field{"robots", "", "several robots instead of one, each with a table of its own"}, o.robots);
  fields(o.options, visit);
}

namespace {

using SimPtr = std::shared_ptr<Sim>;

SimPtr make(const SimTable& table) {
  const World& world = *table.world.value;
  std::vector<RobotOptions> robots;
  if (table.robots && table.robots->empty()) fail("option 'robots': at least one table of options expected, got {{}}");
  for (const RobotTable& robot : table.robots.value_or(std::vector<RobotTable>{table}))
    robots.push_back(robot_options(robot, world));
  return std::make_shared<Sim>(table.world.value, std::move(robots), table.options);
}

Observation step(Sim& sim, const CommandArgument& commands, const std::optional<double>& w, const Call& call) {
  const InUse in_use(call.L, &sim, "sim");
  sim.step(commands.for_robots(sim.robot_count(), w));
  return sim.observation();
}
void reset(Sim& sim, const std::optional<std::uint64_t>& seed, const Call& call) {
  const InUse in_use(call.L, &sim, "sim");
  sim.reset(seed.value_or(sim.options().seed));
}
SimPtr fork(const Sim& sim) { return std::make_shared<Sim>(sim.fork()); }
std::string hash(const Sim& sim) { return fmt::format("{:016x}", sim.hash()); }

Observation observation(const Sim& sim) { return sim.observation(); }
Pose2 pose(const Sim& sim) { return sim.state().pose_world; }
RobotView state(const SimPtr& sim) { return {sim, 0}; }
std::uint64_t seed(const Sim& sim) { return sim.options().seed; }
std::vector<RobotView> robots(const SimPtr& sim) {
  std::vector<RobotView> list;
  for (std::size_t i = 0; i < sim->robot_count(); ++i) list.push_back({sim, i});
  return list;
}

void save(const Sim& sim, const OutputFile& file) { save_drawing(file.path, picture_of(sim), ".svg or .png"); }
DrawList picture(const Sim& sim) { return picture_of(sim); }
std::string text(const Sim& sim) {
  const Pose2 at = sim.state().pose_world;
  return fmt::format("sim: \"{}\", {} robot{}, {:.1f} s, at ({:.2f}, {:.2f}) heading {:.2f}, seed {}",
                     sim.world().header().title, sim.robot_count(), sim.robot_count() == 1 ? "" : "s", sim.time(), at.x,
                     at.y, at.heading, sim.options().seed);
}

void bind_properties(Type<Sim>& type) {
  type
      .property<&Sim::time>(PropertyDoc{
          .name = "time", .text = "Time since the start.", .unit = "s", .example = EXAMPLE_SIM "print(s.time)"})
      .property<&Sim::period>(PropertyDoc{.name = "period",
                                          .text = "Length of a control cycle.",
                                          .unit = "s",
                                          .example = EXAMPLE_SIM "print(s.period)"})
      .property<&seed>(
          PropertyDoc{.name = "seed", .text = "Seed of all random streams.", .example = EXAMPLE_SIM "print(s.seed)"})
      .property<&Sim::shared_world>(
          PropertyDoc{.name = "world", .text = "The world it runs in.", .example = EXAMPLE_SIM "print(s.world)"})
      .property<&observation>(PropertyDoc{.name = "observation",
                                          .text = "What the first robot sees and its odometry says.",
                                          .example = EXAMPLE_SIM "print(s.observation.sonar[1])"})
      .property<&pose>(PropertyDoc{.name = "pose",
                                   .text = "True pose of the first robot.",
                                   .unit = "m, rad",
                                   .example = EXAMPLE_SIM "print(s.pose.x)"})
      .property<&state>(PropertyDoc{.name = "state",
                                    .text = "The truth about the first robot.",
                                    .example = EXAMPLE_SIM "print(s.state.contacts)"})
      .property<&robots>(PropertyDoc{
          .name = "robots", .text = "The truth about every robot.", .example = EXAMPLE_SIM "print(#s.robots)"});
}

}  // namespace

void bind_sim(lua_State* L) {
  Module(L, "meander.sim", "Simulation: commands in, observations out.")
      .function<&make>(Doc{.name = "new",
                           .text = "Places robots in a world and starts the clock.",
                           .args = {{"options", "the world, the robot and the seed"}},
                           .returns = "the simulation",
                           .errors = "no start; a start that is not free; a number out of range",
                           .example = "s = meander.sim.new { world = meander.world.open 'worlds/office.toml', robot = "
                                      "'nomad200', sonar = 'nomad', seed = 7 }"});
  Type<Sim> type(L, "A simulation: a world, its robots, a clock.");
  type.method<&step>(
          Doc{.name = "step",
              .text = "One control cycle.",
              .args = {{"command", "forward speed, {v =, w =}, or a list of these for several robots", "m/s"},
                       {"w", "turning rate, when the first argument is a speed", "rad/s"}},
              .returns = "what the first robot sees then",
              .errors = "not one command per robot",
              .example = EXAMPLE_SIM "print(s:step(0.3, 0).pose, s:step { v = 0.3, w = 0.1 }.time)"})
      .method<&reset>(Doc{.name = "reset",
                          .text = "Back to the start, in the world as it is now.",
                          .args = {{"seed", "another seed; the same one, and so the same run, when left out"}},
                          .example = EXAMPLE_SIM "s:step(0.3, 0) s:reset()"})
      .method<&fork>(Doc{.name = "fork",
                         .text = "An independent copy in this moment, with its own copy of the world.",
                         .returns = "the copy",
                         .example = EXAMPLE_SIM "print(s:fork():hash() == s:hash())"})
      .method<&hash>(Doc{.name = "hash",
                         .text = "Hash of everything that decides how it goes on.",
                         .returns = "16 hexadecimal digits",
                         .example = EXAMPLE_SIM "print(s:hash())"})
      .method<&save>(Doc{.name = "save",
                         .text = "Writes a picture of this moment (.svg, .png).",
                         .args = {{"path", "the suffix says what is written"}},
                         .errors = "unknown suffix; the file cannot be written",
                         .example = EXAMPLE_SIM "s:save(os.tmpname() .. '.svg')"})
      .text<&text>()
      .picture<&picture>();
  bind_properties(type);
}

}  // namespace meander::script
