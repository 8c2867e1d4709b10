// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/example_text.hpp"
#include "script/kit_type.hpp"
#include "script/numbers.hpp"
#include "script/objects.hpp"

namespace meander::script {
namespace {

using ObservationPtr = std::shared_ptr<Observation>;

Pose2 pose(const Observation& o) { return o.odometry.pose; }
double v(const Observation& o) { return o.odometry.v; }
double w(const Observation& o) { return o.odometry.w; }
double vy(const Observation& o) { return o.odometry.vy; }
Numbers sonar(const ObservationPtr& o) { return numbers_of(o, o->readings.sonar); }
std::vector<Pose2> sonar_poses(const Observation& o) { return o.readings.sonar_pose; }
Numbers bumper(const ObservationPtr& o) { return numbers_of(o, o->readings.bumper); }
Numbers whisker(const ObservationPtr& o) { return numbers_of(o, o->readings.whisker); }
Numbers light(const ObservationPtr& o) { return numbers_of(o, o->readings.light); }
bool bumped(const Observation& o) {
  return std::any_of(o.readings.bumper.begin(), o.readings.bumper.end(), [](std::uint8_t pressed) { return pressed; });
}
std::string observation_text(const Observation& o) {
  const Pose2 at = o.odometry.pose;
  return fmt::format("observation: {:.2f} s, odometry ({:.2f}, {:.2f}) heading {:.2f}, {} sonars", o.time, at.x, at.y,
                     at.heading, o.readings.sonar.size());
}

const RobotState& of(const RobotView& robot) { return robot.sim->state(robot.index); }
Pose2 true_pose(const RobotView& robot) { return of(robot).pose_world; }
double true_v(const RobotView& robot) { return of(robot).v; }
double true_w(const RobotView& robot) { return of(robot).w; }
double true_vy(const RobotView& robot) { return of(robot).vy; }
bool touching(const RobotView& robot) { return of(robot).touching; }
int contacts(const RobotView& robot) { return of(robot).contacts; }
int fault_contacts(const RobotView& robot) { return of(robot).fault_contacts; }
double travelled(const RobotView& robot) { return of(robot).travelled; }
double clearance(const RobotView& robot) { return of(robot).clearance; }
Observation seen(const RobotView& robot) { return robot.sim->observation(robot.index); }
std::string platform_name(const RobotView& robot) { return robot.sim->robot(robot.index).platform.name; }
double radius(const RobotView& robot) { return robot.sim->robot(robot.index).platform.body.radius; }
int number(const RobotView& robot) { return static_cast<int>(robot.index) + 1; }
std::string robot_text(const RobotView& robot) {
  const Pose2 at = true_pose(robot);
  return fmt::format("robot {} ({}): ({:.2f}, {:.2f}) heading {:.2f}, {} contact{}", number(robot),
                     platform_name(robot), at.x, at.y, at.heading, contacts(robot), contacts(robot) == 1 ? "" : "s");
}

void bind_robot_view(lua_State* L) {
  Type<RobotView>(L, "The truth about a robot of a simulation, for scores and pictures.")
      .property<&number>(PropertyDoc{
          .name = "number", .text = "Which robot, 1 first.", .example = EXAMPLE_SIM "print(s.state.number)"})
      .property<&platform_name>(PropertyDoc{
          .name = "platform", .text = "What kind of robot it is.", .example = EXAMPLE_SIM "print(s.state.platform)"})
      .property<&radius>(PropertyDoc{
          .name = "radius", .text = "Radius of its body.", .unit = "m", .example = EXAMPLE_SIM "print(s.state.radius)"})
      .property<&true_pose>(PropertyDoc{
          .name = "pose", .text = "Its true pose.", .unit = "m, rad", .example = EXAMPLE_SIM "print(s.state.pose)"})
      .property<&true_v>(PropertyDoc{
          .name = "v", .text = "Its true forward speed.", .unit = "m/s", .example = EXAMPLE_SIM "print(s.state.v)"})
      .property<&true_w>(PropertyDoc{
          .name = "w", .text = "Its true turning rate.", .unit = "rad/s", .example = EXAMPLE_SIM "print(s.state.w)"})
      .property<&true_vy>(PropertyDoc{.name = "vy",
                                      .text = "Its true speed to the left; 0 for unicycles.",
                                      .unit = "m/s",
                                      .example = EXAMPLE_SIM "print(s.state.vy)"})
      .property<&touching>(PropertyDoc{.name = "touching",
                                       .text = "Was it in contact at the end of the cycle?",
                                       .example = EXAMPLE_SIM "print(s.state.touching)"})
      .property<&contacts>(
          PropertyDoc{.name = "contacts", .text = "Contacts so far.", .example = EXAMPLE_SIM "print(s.state.contacts)"})
      .property<&fault_contacts>(PropertyDoc{.name = "fault_contacts",
                                             .text = "Contacts by its own motion so far.",
                                             .example = EXAMPLE_SIM "print(s.state.fault_contacts)"})
      .property<&travelled>(PropertyDoc{.name = "travelled",
                                        .text = "Its way so far.",
                                        .unit = "m",
                                        .example = EXAMPLE_SIM "print(s.state.travelled)"})
      .property<&clearance>(PropertyDoc{.name = "clearance",
                                        .text = "From its hull to the nearest obstacle, 10 at most.",
                                        .unit = "m",
                                        .example = EXAMPLE_SIM "print(s.state.clearance)"})
      .property<&seen>(PropertyDoc{.name = "observation",
                                   .text = "What it sees and its odometry says.",
                                   .example = EXAMPLE_SIM "print(s.state.observation)"})
      .text<&robot_text>();
}

}  // namespace

void bind_observation(lua_State* L) {
  Type<Observation>(
      L, "All that the robot side gets to see in a control cycle: sonar, bumpers, whiskers, light, odometry.")
      .property<&Observation::time>(PropertyDoc{.name = "time",
                                                .text = "Time since the start.",
                                                .unit = "s",
                                                .example = EXAMPLE_SIM "print(s.observation.time)"})
      .property<&Observation::period>(PropertyDoc{.name = "period",
                                                  .text = "Length of the cycle that ends here.",
                                                  .unit = "s",
                                                  .example = EXAMPLE_SIM "print(s.observation.period)"})
      .property<&pose>(PropertyDoc{.name = "pose",
                                   .text = "Where the odometry says it is.",
                                   .unit = "m, rad",
                                   .example = EXAMPLE_SIM "print(s.observation.pose)"})
      .property<&v>(PropertyDoc{
          .name = "v", .text = "Forward speed.", .unit = "m/s", .example = EXAMPLE_SIM "print(s.observation.v)"})
      .property<&w>(PropertyDoc{
          .name = "w", .text = "Turning rate.", .unit = "rad/s", .example = EXAMPLE_SIM "print(s.observation.w)"})
      .property<&vy>(PropertyDoc{.name = "vy",
                                 .text = "Speed to the left; 0 for unicycles.",
                                 .unit = "m/s",
                                 .example = EXAMPLE_SIM "print(s.observation.vy)"})
      .property<&sonar>(
          PropertyDoc{.name = "sonar",
                      .text = "Ranges in ring order, the first forward, counter-clockwise; the largest range: no echo.",
                      .unit = "m",
                      .example = EXAMPLE_SIM "print(s.observation.sonar:min())"})
      .property<&sonar_poses>(PropertyDoc{.name = "sonar_poses",
                                          .text = "Odometry pose of the robot at which each range was taken.",
                                          .unit = "m, rad",
                                          .example = EXAMPLE_SIM "print(s.observation.sonar_poses[1])"})
      .property<&bumper>(PropertyDoc{.name = "bumper",
                                     .text = "Bumpers in ring order; 1: pressed.",
                                     .example = EXAMPLE_SIM "print(#s.observation.bumper)"})
      .property<&whisker>(PropertyDoc{.name = "whisker",
                                      .text = "Whiskers in ring order; 1: bent.",
                                      .example = EXAMPLE_SIM "print(#s.observation.whisker)"})
      .property<&light>(PropertyDoc{.name = "light",
                                    .text = "Light sensors in ring order: brightness, compressed by the logarithm.",
                                    .example = EXAMPLE_SIM "print(#s.observation.light)"})
      .property<&bumped>(PropertyDoc{
          .name = "bumped", .text = "Is any bumper pressed?", .example = EXAMPLE_SIM "print(s.observation.bumped)"})
      .text<&observation_text>();
  bind_robot_view(L);
}

}  // namespace meander::script
