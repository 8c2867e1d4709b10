// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_aria.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "geometry/angle.hpp"
#include "world/import_raster.hpp"
#include "world/text.hpp"

namespace meander {
namespace {

constexpr double kMetre = 1000;    // [mm]
constexpr double kMargin = 0.2;    // of the bounds around everything [m]
constexpr double kFarthest = 1e8;  // [mm]
constexpr const char* kHead = "2D-Map";

struct Drawing {
  std::vector<Chain> walls;
  std::optional<Pose2> start;
  std::vector<Vec2> goals;
  int dropped = 0;  // lines without length
};

class AriaReader {
 public:
  AriaReader(const std::string& text, const std::string& path) : lines_(text), path_(path) {}

  Drawing read(const Work& work) {
    Drawing drawing;
    bool walls = false;
    for (std::string line; std::getline(lines_, line);) {
      if (++number_ % 1024 == 0) work.poll();
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
      if (line == "DATA") break;  // points that a laser saw
      if (line == "LINES")
        walls = true;
      else if (walls && !line.empty())
        add_wall(drawing, line);
      else if (line.starts_with("Cairn:"))
        add_cairn(drawing, line);
    }
    return drawing;
  }

 private:
  template <std::size_t N>
  std::array<double, N> numbers(std::istream& in, const std::string& line) const {
    std::array<double, N> values{};
    for (double& value : values)
      if (!(in >> value) || !(std::abs(value) <= kFarthest))
        fail<FileError>("{}:{}: {} numbers up to {:g} expected, got '{}'", path_, number_, N, kFarthest,
                        printable(line));
    return values;
  }

  void add_wall(Drawing& drawing, const std::string& line) const {
    std::istringstream in(line);
    const auto ends = numbers<4>(in, line);
    const Vec2 a(ends[0] / kMetre, ends[1] / kMetre), b(ends[2] / kMetre, ends[3] / kMetre);
    if ((a - b).norm() < 1e-6)
      ++drawing.dropped;
    else
      drawing.walls.push_back(Chain{.points = {a, b}});
  }

  void add_cairn(Drawing& drawing, const std::string& line) const {
    std::istringstream in(line.substr(6));
    std::string kind;
    in >> kind;
    if (kind != "RobotHome" && !kind.starts_with("Goal")) return;
    const auto pose = numbers<3>(in, line);
    const Vec2 at(pose[0] / kMetre, pose[1] / kMetre);
    if (kind == "RobotHome")
      drawing.start = Pose2(at.x(), at.y(), wrap_angle(radians(std::fmod(pose[2], 360))));
    else
      drawing.goals.push_back(at);
  }

  std::istringstream lines_;
  const std::string& path_;
  int number_ = 0;
};

Box bounds_of(const Drawing& drawing) {
  Box box{drawing.walls.front().points.front(), drawing.walls.front().points.front()};
  const auto include = [&](const Vec2& point) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  };
  for (const Chain& wall : drawing.walls)
    for (const Vec2& point : wall.points) include(point);
  for (const Vec2& goal : drawing.goals) include(goal);
  if (drawing.start) include(drawing.start->position());
  return {box.low - Vec2(kMargin, kMargin), box.high + Vec2(kMargin, kMargin)};
}

}  // namespace

bool is_aria_map(const std::string& text) { return text.starts_with(kHead); }

Imported aria_from_text(const std::string& text, const std::string& path, const Work& work) {
  if (!is_aria_map(text)) fail<FileError>("{}:1: '{}' expected", path, kHead);
  Drawing drawing = AriaReader(text, path).read(work);
  if (drawing.walls.empty()) fail<FileError>("{}: no walls: lines of four numbers after LINES expected", path);
  Header header;
  header.title = title_of(path);
  header.bounds = bounds_of(drawing);
  header.start = drawing.start;
  Imported result{World(header), {fmt::format("{} walls", drawing.walls.size())}};
  if (drawing.dropped > 0) result.report.push_back(fmt::format("{} lines without length left out", drawing.dropped));
  if (!drawing.start) result.report.push_back("no RobotHome: the world has no start");
  for (Chain& wall : drawing.walls) {
    work.poll();
    result.world.add(Obstacle{.name = {}, .shape = std::move(wall), .surface = {}});
  }
  int number = 0;
  for (const Vec2& goal : drawing.goals)
    result.world.add(
        Place{.name = fmt::format("goal_{}", ++number), .position = goal, .heading = {}, .tolerance = 0.25});
  result.world.forget_history();
  return result;
}

}  // namespace meander
