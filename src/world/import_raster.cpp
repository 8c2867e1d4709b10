// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_raster.hpp"

#include <algorithm>
#include <filesystem>

#include "world/text.hpp"

namespace meander {
namespace {

Box bounds_of(const Grid<std::uint8_t>& grid) {
  const Vec2 size = grid.frame.resolution * Vec2(grid.width(), grid.height());
  Box box{grid.frame.origin.position(), grid.frame.origin.position()};
  for (const Vec2& corner : {Vec2(size.x(), 0), Vec2(0, size.y()), size}) {
    const Vec2 p = grid.frame.origin * corner;
    box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
  }
  return box;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

std::string title_of(const std::string& path) { return printable(std::filesystem::path(path).stem().string()); }

std::string size_text(const Grid<std::uint8_t>& grid) {
  const double side = grid.frame.resolution;
  return fmt::format("{} x {} cells of {:.6g} m, {:.6g} m x {:.6g} m", grid.width(), grid.height(), side,
                     grid.width() * side, grid.height() * side);
}

Imported world_from_raster(const Grid<std::uint8_t>& solid, const std::string& path, const TraceOptions& options,
                           std::vector<std::string> report, const Work& work) {
  Traced traced = trace(solid, options, work);
  Header header;
  header.title = title_of(path);
  header.note =
      fmt::format("Traced from {}: {}.", printable(std::filesystem::path(path).filename().string()), size_text(solid));
  header.bounds = bounds_of(solid);
  Imported result{World(header), std::move(report)};
  for (Polygon& polygon : traced.solids) {
    work.poll();
    result.world.add(Obstacle{"", std::move(polygon), {}});
  }
  result.world.forget_history();
  result.report.push_back(fmt::format("{} with {} and {}; {} dropped", counted(result.world.size(), "solid", "solids"),
                                      counted(traced.edges, "edge", "edges"), counted(traced.holes, "hole", "holes"),
                                      counted(static_cast<std::size_t>(traced.specks), "speck", "specks")));
  const auto& cells = solid.cells();
  if (result.world.size() == 0) result.report.push_back("warning: nothing is solid");
  if (std::all_of(cells.begin(), cells.end(), [](auto cell) { return cell != 0; }))
    result.report.push_back("warning: everything is solid");
  return result;
}

}  // namespace meander
