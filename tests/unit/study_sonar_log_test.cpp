// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/sonar_log.hpp"

#include <gtest/gtest.h>

#include "base/atomic_file.hpp"
#include "base/random.hpp"
#include "own_folder.hpp"

namespace meander {
namespace {

SonarLogOptions refusing() {
  SonarLogOptions options;
  options.bad = BadRecords::refuse;
  return options;
}

std::string refusal_of_csv(const std::string& text) {
  try {
    sonar_log_from_csv(text, "a.csv", refusing());
  } catch (const FileError& error) {
    return error.what();
  }
  return "taken";
}

TEST(SonarLogCsv, ReadsTimePoseAndRangesByTheNamesOfTheColumns) {
  const SonarLog log = sonar_log_from_csv(
      "sonar_1,time,note,theta,y,x,sonar_0\n"
      "2.5, 10, hello ,0.5,2,1,1.5\r\n"
      "9,11,,-4,2,1,0.2\n\n",
      "a.csv");
  ASSERT_EQ(log.scans.size(), 2U);
  EXPECT_EQ(log.sonars, 2);
  EXPECT_EQ(log.scans[0].readings.sonar, (std::vector<double>{1.5, 2.5}));
  EXPECT_EQ(log.scans[0].odometry.pose, (Pose2{1, 2, 0.5}));
  EXPECT_EQ(log.scans[1].readings.sonar, (std::vector<double>{0.2, 6.477})) << "beyond the range: no echo";
  EXPECT_EQ(log.scans[1].period, 1);
  EXPECT_NEAR(log.scans[1].odometry.pose.heading, 2 * kPi - 4, 1e-12);
  EXPECT_EQ(log.scans[1].readings.sonar_pose.size(), 2U);
  EXPECT_EQ(log.report.scans, 2);
  EXPECT_FALSE(log.ring);
}

TEST(SonarLogCsv, PrefersTheOdometry) {
  const SonarLog log =
      sonar_log_from_csv("time,x,y,heading,odometry_x,odometry_y,odometry_heading,s1\n0,9,9,9,1,2,3,4\n", "run.csv");
  EXPECT_EQ(log.scans.at(0).odometry.pose, (Pose2{1, 2, 3}));
}

TEST(SonarLogCsv, CountsWhatCannotBeRight) {
  const std::string head = "time,x,y,heading,s1,s2\n";
  const SonarLog log = sonar_log_from_csv(head +
                                              "0,0,0,0,1,2\n"
                                              "1,0,0,0,1\n"         // a column missing
                                              "1,0,0,zero,1,2\n"    // no number
                                              "2,nan,0,0,1,2\n"     // no place
                                              "3,0,0,0,-1,nan\n"    // impossible ranges
                                              "2.5,0,0,0,1,2\n"     // late
                                              "4,0,0,0,1e9,6.4\n",  // impossible
                                          "a.csv");
  EXPECT_EQ(log.report.scans, 3);
  EXPECT_EQ(log.report.short_records, 3);
  EXPECT_EQ(log.report.out_of_order, 1);
  EXPECT_EQ(log.report.bad_ranges, 3);
  EXPECT_EQ(log.scans[1].readings.sonar, (std::vector<double>{6.477, 6.477}));
}

TEST(SonarLogCsv, RefusesWhenAskedTo) {
  const std::string head = "time,x,y,heading,s1,s2\n0,0,0,0,1,2\n";
  EXPECT_EQ(refusal_of_csv(head), "taken");
  EXPECT_EQ(refusal_of_csv(head + "1,0,0,0,1\n"),
            "a.csv:3: 6 columns with numbers for time, pose and 2 ranges expected, got '1,0,0,0,1'");
  EXPECT_EQ(refusal_of_csv(head + "-1,0,0,0,1,2\n"), "a.csv:3: time -1 is before that of the last record, 0");
  EXPECT_EQ(refusal_of_csv(head + "1,0,0,0,1,-2\n"), "a.csv:3: a range from 0 to 30 m expected, got -2");
  EXPECT_EQ(refusal_of_csv("time,y,heading,s1\n"), "a.csv:1: no column 'x' in the head line 'time,y,heading,s1'");
  EXPECT_EQ(refusal_of_csv("time,x,y,heading\n"), "a.csv:1: no columns 'sonar_0', 'sonar_1', ... in the head line");
  EXPECT_EQ(refusal_of_csv(""), "a.csv:1: a head line expected, got nothing");
}

TEST(SonarLogCsv, RefusesRingsThatItCannotPutInOrder) {
  const auto head = [](const std::string& columns) { return refusal_of_csv("time,x,y,heading," + columns + "\n"); };
  EXPECT_EQ(head("s1,s2,s3"), "taken");
  EXPECT_EQ(head("sonar_2,sonar_0,sonar_1,s_total"), "taken");
  EXPECT_EQ(head("sonar_0,sonar_2"), "a.csv:1: column 'sonar_1' is missing");
  EXPECT_EQ(head("s2,s3"), "a.csv:1: column 's1' is missing");
  EXPECT_EQ(head("s0,s1,s1"), "a.csv:1: column 's1' is there twice");
  EXPECT_EQ(head("s0,s1,s01"), "a.csv:1: column 's1' is there twice");
  EXPECT_EQ(head("s1,sonar_0"), "a.csv:1: columns of one ring expected, got 'sonar_0' and 's1'");
  EXPECT_EQ(head("sonar_0,whisker_0,whisker_2"), "a.csv:1: column 'whisker_1' is missing");
  EXPECT_EQ(head("light_0,light_0"), "a.csv:1: column 'light_0' is there twice");
  EXPECT_EQ(head("s1,x"), "a.csv:1: column 'x' is there twice");
}

TEST(SonarLogCsv, TakesTheMarkBeforeUtf8) {
  EXPECT_EQ(sonar_log_from_csv("\xEF\xBB\xBFtime,x,y,heading,s1\n0,0,0,0,1\n", "a.csv").scans.size(), 1U);
}

TEST(SonarLogCsv, ATimeFarOffIsBlamedAndNotWhatFollowsIt) {
  const std::string head = "time,x,y,heading,s1\n", rest = "1,0,0,0,1\n2,0,0,0,1\n3,0,0,0,1\n";
  for (const std::string wrong : {"1e9,0,0,0,1\n", "-1e9,0,0,0,1\n", "1e300,0,0,0,1\n"})
    for (const std::string& text : {head + wrong + rest, head + "0,0,0,0,1\n0,0,0,0,1\n" + wrong + rest}) {
      const SonarLog log = sonar_log_from_csv(text, "a.csv");
      // Nothing contradicts a first record that is much too early.
      const int left_out = log.report.out_of_order + log.report.short_records;
      EXPECT_EQ(left_out, wrong[0] == '-' && text.find(wrong) == head.size() ? 0 : 1) << text;
      EXPECT_EQ(log.scans.back().time, 3) << text;
    }
  EXPECT_EQ(refusal_of_csv(head + "0,0,0,0,1\n1e9,0,0,0,1\n" + rest),
            "a.csv:3: time 1000000000 is after that of the next record, 1");
  EXPECT_EQ(refusal_of_csv(head + rest + "2.5,0,0,0,1\n4,0,0,0,1\n"),
            "a.csv:5: time 2.5 is before that of the last record, 3");
}

TEST(SonarLogCsv, KeepsAsManyRecordsInOrderAsThereAre) {
  Stream draw(2000, "times");
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> times(10);
    std::string text = "time,x,y,heading,s1\n";
    for (double& time : times) {
      time = std::floor(draw.uniform(0, 8));
      text += fmt::format("{},0,0,0,1\n", time);
    }
    std::size_t most = 0;
    for (unsigned subset = 0; subset < 1024; ++subset) {
      std::vector<double> kept;
      for (std::size_t i = 0; i < times.size(); ++i)
        if (subset >> i & 1) kept.push_back(times[i]);
      if (std::is_sorted(kept.begin(), kept.end())) most = std::max(most, kept.size());
    }
    const SonarLog log = sonar_log_from_csv(text, "a.csv");
    EXPECT_EQ(log.scans.size(), most) << text;
    EXPECT_EQ(log.report.out_of_order, 10 - static_cast<int>(most));
    EXPECT_TRUE(std::is_sorted(log.scans.begin(), log.scans.end(), [](auto& a, auto& b) { return a.time < b.time; }));
  }
}

/// Four sonars, listed clockwise from behind.
constexpr const char* kOffsets = " -0.2 0 3.14159 0 0.2 1.5708 0.2 0 0 0 -0.2 -1.5708";

std::string sonar_line(const std::string& ranges, double time) {
  return "SONAR 0.26 4 " + ranges + kOffsets + fmt::format(" {} host {}\n", time, time);
}
std::string odom_line(double x, double time) { return fmt::format("ODOM {} 0 0 0.1 0 0 {} host {}\n", x, time, time); }

TEST(SonarLogCarmen, BringsTheSonarsIntoRingOrderAndPosesThemBetweenTheOdometry) {
  const SonarLog log =
      sonar_log_from_carmen("# a log\nPARAM robot scout 0 h 0\n" + odom_line(1, 10) + sonar_line("1 2 3 4", 10.25) +
                                odom_line(2, 11) + sonar_line("5 6 7 8", 12),
                            "a.log");
  ASSERT_EQ(log.scans.size(), 2U);
  EXPECT_EQ(log.scans[0].readings.sonar, (std::vector<double>{3, 2, 1, 4})) << "forward, left, behind, right";
  EXPECT_NEAR(log.scans[0].odometry.pose.x, 1.25, 1e-12);
  EXPECT_NEAR(log.scans[1].odometry.pose.x, 2, 1e-12) << "the last pose that is known";
  ASSERT_TRUE(log.ring);
  EXPECT_EQ(log.ring->count, 4);
  EXPECT_NEAR(log.ring->radius, 0.2, 1e-9);
  EXPECT_NEAR(log.ring->first, 0, 1e-4);
  EXPECT_EQ(log.report.other, 1);
}

TEST(SonarLogCarmen, CountsOrRefusesWhatCannotBeRight) {
  const std::string text = sonar_line("1 2 3 4", 1) + odom_line(0, 2) + sonar_line("1 -2 3 4", 3) +
                           sonar_line("1 2 3 4", 2.5) + "SONAR 0.26 4 1 2 3 4 host 5\n" + "SONAR 0.26 -7 1 h 2\n" +
                           "SONAR\nODOM 1 2\nODOM nan 0 0 0 0 0 9 h 9\n";
  const SonarLog log = sonar_log_from_carmen(text, "a.log");
  EXPECT_EQ(log.report.scans, 1);
  EXPECT_EQ(log.report.without_pose, 1);
  EXPECT_EQ(log.report.bad_ranges, 1);
  EXPECT_EQ(log.report.out_of_order, 1);
  EXPECT_EQ(log.report.short_records, 5);
  EXPECT_THROW(sonar_log_from_carmen(text, "a.log", refusing()), FileError);
  // A ring that no map can read is never taken.
  EXPECT_THROW(sonar_log_from_carmen(odom_line(0, 0) + "SONAR 0.26 2 1 2 0.2 0 0 0.2 0 0.3 1 h 1\n", "a.log"),
               FileError);
}

TEST(SonarLogCarmen, ATimeFarOffIsBlamedAndNotWhatFollowsIt) {
  std::string text = odom_line(0, 1);
  for (const double time : {2.0, 1e9, 3.0, 4.0, 5.0}) text += sonar_line("1 2 3 4", time) + odom_line(time, time);
  const SonarLog log = sonar_log_from_carmen(text, "a.log");
  EXPECT_EQ(log.report.scans, 4);
  EXPECT_EQ(log.report.out_of_order, 2);
  EXPECT_EQ(log.scans.back().time, 5);
}

TEST(SonarLogFile, SuffixesTellTheKind) {
  const auto file = [](const char* name) { return (own_folder() / name).string(); };
  write_file_atomically(file("a.csv"), "time,x,y,heading,s1\n0,0,0,0,1\n");
  write_file_atomically(file("a.log"), odom_line(0, 0) + sonar_line("1 2 3 4", 1));
  write_file_atomically(file("a.txt"), "");
  EXPECT_EQ(read_sonar_log(file("a.csv")).scans.size(), 1U);
  EXPECT_EQ(read_sonar_log(file("a.log")).scans.size(), 1U);
  EXPECT_THROW(read_sonar_log(file("a.txt")), FileError);
  EXPECT_THROW(read_sonar_log(file("none.csv")), FileError);
}

}  // namespace
}  // namespace meander
