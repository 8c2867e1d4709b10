// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/example_text.hpp"
#include "script/file_access.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/picture.hpp"
#include "script/reading.hpp"

namespace meander::script {
namespace {

SonarOptions sonar_options(const Preset<SonarOptions>& sonar) { return sonar.value; }

Numbers ranges(const std::shared_ptr<Reading>& reading) { return numbers_of(reading, reading->ranges); }
Pose2 pose(const Reading& reading) { return reading.pose; }
double range_max(const Reading& reading) { return reading.sonar.range_max; }
std::vector<Pose2> transducers(const Reading& reading) { return transducer_poses(reading.layout, reading.pose); }

std::vector<Vec2> points(const Reading& reading) {
  std::vector<Vec2> echoes;
  const std::vector<Pose2> from = transducer_poses(reading.layout, reading.pose);
  for (std::size_t i = 0; i < from.size(); ++i)
    if (reading.ranges[i] < reading.sonar.range_max) echoes.push_back(from[i] * Vec2(reading.ranges[i], 0));
  return echoes;
}

void save(const Reading& reading, const OutputFile& file) {
  save_drawing(file.path, picture_of(reading), ".svg or .png");
}
DrawList picture(const Reading& reading) { return picture_of(reading); }
std::string text(const Reading& reading) {
  const std::size_t echoes = points(reading).size();
  return fmt::format("reading: {} sonars, {} echo{}, at ({:.2f}, {:.2f}) heading {:.2f}", reading.ranges.size(), echoes,
                     echoes == 1 ? "" : "es", reading.pose.x, reading.pose.y, reading.pose.heading);
}

void bind_reading(lua_State* L) {
  Type<Reading>(L, "One scan of a sonar ring.")
      .method<&points>(Doc{.name = "points",
                           .text = "Where the echoes would be if they came from the axes of the sonars.",
                           .returns = "list of points [m], without sonars that heard nothing",
                           .example = EXAMPLE_SCAN "print(#r:points())"})
      .method<&save>(Doc{.name = "save",
                         .text = "Writes a picture (.svg, .png).",
                         .args = {{"path", "the suffix says what is written"}},
                         .errors = "unknown suffix; the file cannot be written",
                         .example = EXAMPLE_SCAN "r:save(os.tmpname() .. '.svg')"})
      .property<&ranges>(PropertyDoc{.name = "ranges",
                                     .text = "Ranges in ring order, the first forward, counter-clockwise.",
                                     .unit = "m",
                                     .example = EXAMPLE_SCAN "print(r.ranges:min())"})
      .property<&range_max>(PropertyDoc{.name = "range_max",
                                        .text = "The range that stands for no echo.",
                                        .unit = "m",
                                        .example = EXAMPLE_SCAN "print(r.range_max)"})
      .property<&pose>(PropertyDoc{
          .name = "pose", .text = "Where the robot stood.", .unit = "m, rad", .example = EXAMPLE_SCAN "print(r.pose)"})
      .property<&transducers>(PropertyDoc{.name = "transducers",
                                          .text = "Where the sonars were.",
                                          .unit = "m, rad",
                                          .example = EXAMPLE_SCAN "print(r.transducers[1].heading)"})
      .text<&text>()
      .picture<&picture>();
}

}  // namespace

void bind_sensor(lua_State* L) {
  bind_reading(L);
  Module(L, "meander.sensor", "Sensors: from the truth to readings.")
      .function<&scan>(Doc{.name = "scan",
                           .text = "One scan of the sonars, standing still.",
                           .args = {{"options", "the world, the pose and the sonar model"}},
                           .returns = "the reading",
                           .errors = "no pose; a number out of range",
                           .example = "show(meander.sensor.scan { world = meander.world.open 'worlds/office.toml', "
                                      "sonar = 'ideal' })"})
      .function<&ray>(Doc{.name = "ray",
                          .text = "The first wall or solid on a straight ray.",
                          .args = {{"options", "the world and the ray"}},
                          .returns = "range [m], the thing hit and the point hit [m]; nil when there is nothing",
                          .errors = "a number out of range",
                          .example = "print(meander.sensor.ray { world = meander.world.open 'worlds/office.toml', "
                                     "from = {1, 1}, heading = deg(90) })"})
      .function<&sonar_preset_names>(Doc{.name = "sonars",
                                         .text = "The names that sim.new and scan take as sonar.",
                                         .returns = "list of names",
                                         .example = "print(table.concat(meander.sensor.sonars(), ' '))"})
      .function<&sonar_options>(Doc{.name = "sonar",
                                    .text = "A sonar model in detail: every effect with its switch.",
                                    .args = {{"sonar", "its name, or a table that changes one"}},
                                    .returns = "table of options, as sim.new and scan take it",
                                    .errors = "unknown name; a number out of range",
                                    .example = "print(meander.sensor.sonar('real').dropout)"});
}

}  // namespace meander::script
