// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>

#include "geometry/pose.hpp"
#include "grid/image_file.hpp"
#include "world/import_result.hpp"
#include "world/trace.hpp"

namespace meander {

/// What becomes of the cells of a map that are neither free nor occupied.
enum class Unknown { automatic, free, occupied };
template <>
struct EnumNames<Unknown> {
  static constexpr std::pair<Unknown, const char*> entries[] = {
      {Unknown::automatic, "auto"}, {Unknown::free, "free"}, {Unknown::occupied, "occupied"}};
};

/// Whose reading of a map file counts where they differ: nav2 compares with the thresholds inclusively and takes
/// see-through pixels as unknown; ROS 1 compares strictly and averages alpha into the brightness.
enum class RosConvention { nav2, ros1 };
template <>
struct EnumNames<RosConvention> {
  static constexpr std::pair<RosConvention, const char*> entries[] = {{RosConvention::nav2, "nav2"},
                                                                      {RosConvention::ros1, "ros1"}};
};

enum class RosMapMode { trinary, scale, raw };
template <>
struct EnumNames<RosMapMode> {
  static constexpr std::pair<RosMapMode, const char*> entries[] = {
      {RosMapMode::trinary, "trinary"}, {RosMapMode::scale, "scale"}, {RosMapMode::raw, "raw"}};
};

struct RosMapOptions {
  Unknown unknown = Unknown::automatic;
  RosConvention convention = RosConvention::nav2;
  TraceOptions trace;
  std::function<void(const std::string& path)> opens{};  ///< told of the image before it is opened; may throw
};

/// The YAML file of map_server.
struct RosMapFile {
  std::string image;      ///< as written: relative to the folder of the YAML file
  double resolution = 0;  ///< [m/pixel]
  Pose2 origin;           ///< of the lower left corner of the image
  bool negate = false;    ///< light is occupied
  double occupied_thresh = 0.65;
  double free_thresh = 0.196;
  RosMapMode mode = RosMapMode::trinary;
  std::vector<std::string> notes;  ///< defaults taken, keys ignored
};

/// Throws FileError "name:line: key 'resolution': ...".
RosMapFile ros_map_file(const std::string& text, const std::string& name);

/// 0 free .. 100 occupied, -1 unknown: what map_server publishes. Row 0 is the bottom.
Grid<std::int8_t> ros_occupancy(const RosMapFile& file, const Image& image, RosConvention convention);

/// The solid cells of a ROS map, traced. Free and occupied are what map_server makes of the file, with one exception:
/// in trinary maps grey 205 always is unknown, because that is the grey that map savers write for it, although a
/// free_thresh above 0.196 would call it free. Unknown cells are solid, nobody should drive where nobody has looked,
/// unless `unknown` is "free"; "auto" also warns where the exception matters. In the modes scale and raw a cell is
/// occupied from 50 % on. Throws FileError.
Imported import_ros_map(const std::string& yaml_path, const RosMapOptions& options = {}, const Work& work = {});

}  // namespace meander
