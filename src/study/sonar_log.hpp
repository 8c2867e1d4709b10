// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "base/work.hpp"
#include "robot/observation.hpp"
#include "robot/platform.hpp"

namespace meander {

/// What becomes of records that cannot be right: left out and counted, or the whole file refused at the first.
enum class BadRecords { skip, refuse };
template <>
struct EnumNames<BadRecords> {
  static constexpr std::pair<BadRecords, const char*> entries[] = {{BadRecords::skip, "skip"},
                                                                   {BadRecords::refuse, "refuse"}};
};

struct SonarLogOptions {
  BadRecords bad = BadRecords::skip;
  double range_max = 6.477;
  double range_possible = 30;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SonarLogOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"bad", "", "records that cannot be right: skip and count them, or refuse the file"}, o.bad);
  visit(Field{"range_max", "m", "a reading from here on is no echo", 0.1, 1000}, o.range_max);
  visit(Field{"range_possible", "m", "a reading above this, below 0 or no number is impossible; skipped as no echo",
              0.1, 1e6},
        o.range_possible);
}

/// What was met in a log, so that nobody takes half of one for all of it.
struct SonarLogReport {
  int lines = 0;
  int scans = 0;          ///< taken
  int short_records = 0;  ///< columns missing, too many, or no numbers: left out
  int out_of_order = 0;   ///< so few that without them times never fall: left out
  int bad_ranges = 0;     ///< impossible: taken as no echo
  int without_pose = 0;   ///< scans before anything told where the robot was: left out
  int other = 0;          ///< records of kinds that are not read
};

/// Scans with poses that a robot has recorded. Each is taken as if all sonars had fired at once.
struct SonarLog {
  std::vector<Observation> scans;
  std::optional<RingLayout> ring;  ///< where the sonars sit, when the file tells
  int sonars = 0;
  SonarLogReport report;
};

/// Reads by suffix: .csv; .log, .clf and .carmen. Throws FileError.
SonarLog read_sonar_log(const std::string& path, const SonarLogOptions& options = {}, const Work& work = {});

/// A table with a head line: `time` [s], a pose [m, rad] as `odometry_x, odometry_y, odometry_heading` or else as
/// `x, y, heading` (or `theta`), and ranges [m] in ring order as `sonar_0, sonar_1, ...` (`s1, s2, ...` will do);
/// contacts and brightness of robots that have such sensors as `whisker_0, ...` and `light_0, ...`. Other columns are
/// left alone. What save_csv(run) writes is such a table.
SonarLog sonar_log_from_csv(const std::string& text, const std::string& name, const SonarLogOptions& options = {},
                            const Work& work = {});

/// CARMEN's log: `SONAR cone count ranges... offsets...` records (offsets are x y theta of each sonar on the robot),
/// posed between the `ODOM x y theta tv rv accel` records before and after. Lines end with ipc time, host, logger time;
/// the last counts. The sonars are brought into ring order, forward first, counter-clockwise.
SonarLog sonar_log_from_carmen(const std::string& text, const std::string& name, const SonarLogOptions& options = {},
                               const Work& work = {});

}  // namespace meander
