// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_world.hpp"

#include <algorithm>
#include <filesystem>

#include "base/text_file.hpp"
#include "world/import_aria.hpp"
#include "world/text.hpp"
#include "world/world_file.hpp"

namespace meander {
namespace {

using Importer = Imported (*)(const std::string&, const ImportOptions&, const Work&);

TraceOptions trace_options(const ImportOptions& o) { return {o.epsilon, o.min_area}; }

Imported from_toml(const std::string& path, const ImportOptions&, const Work& work) {
  return {read_world(path, work), {}};
}

Imported from_ros_map(const std::string& path, const ImportOptions& o, const Work& work) {
  return import_ros_map(path, {o.unknown, o.convention, trace_options(o), o.opens}, work);
}

Imported from_picture(const std::string& path, const ImportOptions& o, const Work& work) {
  return import_floor_plan(path, {o.resolution, o.threshold, o.negate, trace_options(o)}, work);
}

Imported from_barn(const std::string& path, const ImportOptions& o, const Work& work) {
  return import_barn(path, {o.index}, work);
}

Imported from_map(const std::string& path, const ImportOptions& o, const Work& work) {
  const std::string text = read_text_file(path, 256 << 20);
  if (is_aria_map(text)) return aria_from_text(text, path, work);
  return movingai_from_text(text, path, {o.resolution, trace_options(o)}, work);
}

constexpr std::pair<const char*, Importer> kImporters[] = {
    {".toml", from_toml},   {".yaml", from_ros_map}, {".yml", from_ros_map},  {".png", from_picture},
    {".pgm", from_picture}, {".jpg", from_picture},  {".jpeg", from_picture}, {".bmp", from_picture},
    {".tif", from_picture}, {".tiff", from_picture}, {".csv", from_barn},     {".map", from_map}};

}  // namespace

std::vector<std::string> import_suffixes() {
  std::vector<std::string> suffixes;
  for (const auto& [suffix, importer] : kImporters) suffixes.emplace_back(suffix);
  return suffixes;
}

Imported import_world(const std::string& path, const ImportOptions& options, const Work& work) {
  validate(options);
  std::string suffix = std::filesystem::path(path).extension().string();
  for (char& c : suffix)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const auto& [known, importer] : kImporters)
    if (suffix == known) return importer(path, options, work);
  fail<FileError>("{}: a file of a known format ({}) expected, got {}", path, listing(import_suffixes()),
                  suffix.empty() ? "no suffix" : "'" + printable(suffix) + "'");
}

}  // namespace meander
