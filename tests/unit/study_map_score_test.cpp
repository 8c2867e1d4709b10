// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/map_score.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace meander {
namespace {

/// A robot in a room of 6 m with a wall 1 m ahead of it and a disc behind that.
Sim room() {
  Header header;
  header.bounds = {{0, 0}, {6, 6}};
  header.start = Pose2{3, 3, 0};
  auto world = std::make_shared<World>(header);
  world->add(Obstacle{.name = {}, .shape = Polygon{{{4, 2}, {4.2, 2}, {4.2, 4}, {4, 4}}, {}}, .surface = {}});
  world->add(Obstacle{.name = {}, .shape = Disc{{4.4, 3}, 0.1}, .surface = {}});
  return Sim(world,
             {RobotOptions{
                 .platform = platform("nomad200"), .sonar = {}, .drift = {}, .whisker = {}, .light = {}, .start = {}}},
             {});
}

const GridFrame kWindow{0.05, {1.5, 1.5, 0}};

Grid<float> perfect(const Sim& sim) {
  const Grid<CellTruth> truth = map_truth(sim, 0, 60, 60, kWindow);
  Grid<float> map(60, 60, 0.5F, kWindow);
  for (std::size_t i = 0; i < map.cells().size(); ++i)
    if (truth.cells()[i] != CellTruth::hidden) map.cells()[i] = truth.cells()[i] == CellTruth::occupied ? 1.0F : 0.0F;
  return map;
}

TEST(MapTruth, TellsWhatTheRobotCanSee) {
  const Sim sim = room();
  const Grid<CellTruth> truth = map_truth(sim, 0, 60, 60, kWindow);
  const auto at = [&](double x, double y) { return truth[kWindow.cell({x, y})]; };
  EXPECT_EQ(at(3.9, 3.0), CellTruth::free);
  EXPECT_EQ(at(4.02, 3.0), CellTruth::occupied);
  EXPECT_EQ(at(4.12, 3.0), CellTruth::hidden) << "deeper in the wall than the slack";
  EXPECT_EQ(at(4.4, 3.0), CellTruth::hidden) << "behind the wall";
  EXPECT_EQ(at(3.1, 3.1), CellTruth::hidden) << "under the robot";
  EXPECT_EQ(at(1.52, 3.0), CellTruth::free);
  const Grid<CellTruth> outside = map_truth(sim, 0, 10, 10, {0.05, {-0.5, 2.8, 0}});
  for (const CellTruth cell : outside.cells()) EXPECT_EQ(cell, CellTruth::hidden) << "outside the world";
  EXPECT_THROW(map_truth(sim, 0, 9, 9, {0.05, {0, 0, 1}}), ArgumentError);
  EXPECT_THROW(map_truth(sim, 0, 9000, 9000, kWindow), ArgumentError);
}

TEST(MapScore, PerfectMapHasNoError) {
  const Sim sim = room();
  const MapScore score = score_map(perfect(sim), sim, 0);
  EXPECT_LT(score.ce, 2e-4);
  EXPECT_EQ(score.brier, 0);
  EXPECT_EQ(score.auc, 1);
  EXPECT_EQ(score.ece, 0);
  EXPECT_LT(score.error, 0.02);
  EXPECT_LT(score.missed, 0.05);
  EXPECT_EQ(score.phantom, 0);
  EXPECT_GT(score.occupied, 20);
  EXPECT_GT(score.free, 1000);
}

TEST(MapScore, EmptyMapIsACoin) {
  const Sim sim = room();
  const MapScore score = score_map(Grid<float>(60, 60, 0.5F, kWindow), sim, 0);
  EXPECT_NEAR(score.ce, std::log(2.0), 1e-9);
  EXPECT_NEAR(score.brier, 0.25, 1e-9);
  EXPECT_NEAR(score.auc, 0.5, 1e-12);
  EXPECT_NEAR(score.ece, 0, 1e-9);
  EXPECT_EQ(score.missed, 1);
}

TEST(MapScore, ClassesWeighTheSame) {
  const Sim sim = room();
  const MapScore all_free = score_map(Grid<float>(60, 60, 0.1F, kWindow), sim, 0);
  EXPECT_NEAR(all_free.ce, 0.5 * (-std::log(0.9) - std::log(0.1)), 1e-6) << "though most cells are free";
  EXPECT_NEAR(all_free.ece, 0.4, 1e-6);
  double weight = 0;
  for (const ReliabilityBin& bin : all_free.reliability) weight += bin.weight;
  EXPECT_NEAR(weight, 1, 1e-9);
}

TEST(MapScore, DirectionsMeasureWhereTheMapEnds) {
  const Sim sim = room();
  Grid<float> late = perfect(sim);
  // The wall 10 cm nearer than it is.
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 58; ++x) late[{x, y}] = late[{x + 2, y}];
  MapScoreOptions ahead;
  ahead.directions = 1;
  EXPECT_NEAR(score_map(late, sim, 0, ahead).error, 0.1, 0.015);
}

TEST(MapScore, OneClassAloneHasNoFigures) {
  Header header;
  header.bounds = {{0, 0}, {60, 60}};
  header.start = Pose2{30, 30, 0};
  const Sim sim(
      std::make_shared<World>(header),
      {RobotOptions{
          .platform = platform("nomad200"), .sonar = {}, .drift = {}, .whisker = {}, .light = {}, .start = {}}},
      {});
  const MapScore score = score_map(Grid<float>(20, 20, 0.2F, {0.05, {30.5, 30, 0}}), sim, 0);
  EXPECT_EQ(score.occupied, 0);
  EXPECT_TRUE(std::isnan(score.ce));
}

}  // namespace
}  // namespace meander
