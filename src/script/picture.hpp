// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <string>
#include <vector>

#include "render/draw_list.hpp"
#include "script/kit_call.hpp"
#include "script/objects.hpp"

namespace meander::script {

DrawList picture_of(const World& world);
/// This moment: robots, movers and the last scan.
DrawList picture_of(const Sim& sim);
/// The way through the world.
DrawList picture_of(const Run& run, const World& world);

/// Adds the cones of one scan that was taken at a pose.
void draw_scan(DrawList& list, const RingLayout& layout, const SonarOptions& sonar, const Pose2& pose,
               std::span<const double> ranges);
/// Where the transducers of a ring are when the robot is at a pose.
std::vector<Pose2> transducer_poses(const RingLayout& layout, const Pose2& pose);

/// The picture as text for the terminal that the session writes to, as large as it is.
std::string terminal_picture(const DrawList& list, const Call& call);

/// Writes .svg or .png. Another suffix is an error that names `suffixes`, the ones that the caller takes.
void save_drawing(const std::string& path, const DrawList& list, const char* suffixes);

}  // namespace meander::script
