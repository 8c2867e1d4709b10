// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_movingai.hpp"

#include <filesystem>

#include "base/text_file.hpp"
#include "grid/movingai.hpp"
#include "world/import_raster.hpp"
#include "world/text.hpp"

namespace meander {

Imported movingai_from_text(const std::string& text, const std::string& path, const MovingAiOptions& options,
                            const Work& work) {
  MovingAiMap map = movingai_map(text, path);
  map.blocked.frame.resolution = options.resolution;
  std::vector<std::string> report{
      fmt::format("{}: {}", printable(std::filesystem::path(path).filename().string()), size_text(map.blocked))};
  if (map.water > 0) report.push_back(fmt::format("warning: {} cells of water are solid", map.water));
  if (map.swamp > 0) report.push_back(fmt::format("{} cells of swamp are free", map.swamp));
  return world_from_raster(map.blocked, path, options.trace, std::move(report), work);
}

Imported import_movingai(const std::string& path, const MovingAiOptions& options, const Work& work) {
  return movingai_from_text(read_text_file(path, 256 << 20), path, options, work);
}

}  // namespace meander
