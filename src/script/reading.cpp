// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/reading.hpp"

#include "render/draw_run.hpp"
#include "render/draw_world.hpp"
#include "script/picture.hpp"

namespace meander::script {
namespace {

Pose2 pose_in(const ScanTable& table) {
  const World& world = *table.world.value;
  if (table.pose) return table.pose->in(world);
  if (!world.header().start) fail("option 'pose': missing, and the world has no start; {{x, y, heading}} expected");
  return *world.header().start;
}

}  // namespace

Reading scan(const ScanTable& table) {
  const Platform& platform = table.robot.value;
  Reading reading{std::make_shared<const World>(*table.world.value),
                  platform.sonar,
                  table.sonar.value,
                  pose_in(table),
                  platform.body.radius,
                  std::vector<double>(static_cast<std::size_t>(platform.sonar.count))};
  Scene scene;
  scene.follow(*reading.world);
  SonarRing ring(platform.sonar, table.sonar.value, table.seed);
  const std::vector<Pose2> poses(reading.ranges.size(), reading.pose);
  ring.scan(scene, poses, SonarRing::kNobody, reading.ranges);
  return reading;
}

std::tuple<std::optional<double>, std::optional<Thing>, std::optional<Vec2>> ray(const RayTable& table) {
  Scene scene;
  scene.follow(*table.world.value);
  const SinCos t = sin_cos(wrap_angle(table.heading));
  const auto hit = scene.walls().cast(table.from.value, {t.cos, t.sin}, table.range);
  if (!hit) return {};
  return {hit->range, Thing{table.world.value, table.world.value->id_at(hit->owner)}, hit->point};
}

DrawList picture_of(const Reading& reading) {
  DrawList list = draw_world(*reading.world);
  const RobotLook look = look_of(reading.layout, reading.sonar, reading.body_radius);
  draw_scan(list, look, reading.pose, reading.ranges, theme(Background::light));
  draw_robot(list, reading.pose, reading.body_radius, theme(Background::light));
  return list;
}

}  // namespace meander::script
