// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/numbers.hpp"
#include "script/objects.hpp"

namespace meander::script {

/// The figures of a RunStep that can be seen as a sequence.
enum class TraceName {
  time,
  x,
  y,
  heading,
  odometry_x,
  odometry_y,
  odometry_heading,
  command_v,
  command_w,
  v,
  w,
  clearance
};

/// A view into the run's steps.
Numbers trace_of(const std::shared_ptr<RunRecord>& record, TraceName name);

/// One row of ranges per step.
Matrix sonar_of(const Run& run);

}  // namespace meander::script

namespace meander {

template <>
struct EnumNames<script::TraceName> {
  using enum script::TraceName;
  static constexpr std::pair<script::TraceName, const char*> entries[] = {{time, "time"},
                                                                          {x, "x"},
                                                                          {y, "y"},
                                                                          {heading, "heading"},
                                                                          {odometry_x, "odometry_x"},
                                                                          {odometry_y, "odometry_y"},
                                                                          {odometry_heading, "odometry_heading"},
                                                                          {command_v, "command_v"},
                                                                          {command_w, "command_w"},
                                                                          {v, "v"},
                                                                          {w, "w"},
                                                                          {clearance, "clearance"}};
};

}  // namespace meander
