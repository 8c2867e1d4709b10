// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Reads the YAML file of a ROS map.
#include <charconv>
#include <cmath>

#include "world/import_ros_map.hpp"
#include "world/import_yaml.hpp"
#include "world/text.hpp"

namespace meander {
namespace {

const std::vector<std::string> kKeys = {"image",           "resolution",  "origin", "negate",
                                        "occupied_thresh", "free_thresh", "mode"};

std::optional<double> to_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

class MapFileReader {
 public:
  MapFileReader(const std::string& text, const std::string& name) : name_(name), entries_(flat_yaml(text, name)) {}

  RosMapFile read() {
    RosMapFile file;
    file.image = text_of(needed("image"));
    const YamlEntry& resolution = needed("resolution");
    file.resolution = number(resolution, 0.001, 1000, "a number from 0.001 to 1000 [m/pixel]");
    file.origin = pose(needed("origin"));
    if (const auto* entry = wanted("negate", "0")) file.negate = flag(*entry);
    if (const auto* entry = wanted("occupied_thresh", "0.65")) file.occupied_thresh = share(*entry);
    if (const auto* entry = wanted("free_thresh", "0.196")) file.free_thresh = share(*entry);
    if (const auto* entry = find("mode")) file.mode = mode(*entry);
    if (file.free_thresh >= file.occupied_thresh)
      fail<FileError>("{}: free_thresh below occupied_thresh expected, got {} and {}", name_, file.free_thresh,
                      file.occupied_thresh);
    note_unknown_keys();
    file.notes = std::move(notes_);
    return file;
  }

 private:
  const YamlEntry* find(std::string_view key) const {
    for (const YamlEntry& entry : entries_)
      if (entry.key == key) return &entry;
    return nullptr;
  }

  const YamlEntry& needed(const std::string& key) const {
    if (const YamlEntry* entry = find(key)) return *entry;
    std::vector<std::string> there;
    for (const YamlEntry& entry : entries_) there.push_back(entry.key);
    const auto near = nearest_name(key, there);
    fail<FileError>("{}: key '{}' is missing{}", name_, key,
                    near ? fmt::format("; is '{}' meant for it?", printable(*near)) : "");
  }

  const YamlEntry* wanted(const char* key, const char* otherwise) {
    const YamlEntry* entry = find(key);
    if (!entry) notes_.push_back(fmt::format("warning: key '{}' is missing, {} is taken", key, otherwise));
    return entry;
  }

  [[noreturn]] void complain(const YamlEntry& entry, std::string_view expected) const {
    fail<FileError>("{}:{}: key '{}': {} expected, got {}", name_, entry.line, entry.key, expected,
                    entry.list ? fmt::format("a list of {}", entry.values.size())
                               : fmt::format("'{}'", printable(entry.values[0])));
  }

  std::string text_of(const YamlEntry& entry) const {
    if (entry.list || entry.values[0].empty() || entry.values[0].find('\0') != std::string::npos)
      complain(entry, "the name of an image file");
    return entry.values[0];
  }

  double number(const YamlEntry& entry, double least, double most, std::string_view expected) const {
    const auto value = entry.list ? std::nullopt : to_number(entry.values[0]);
    if (!value || *value < least || *value > most) complain(entry, expected);
    return *value;
  }

  double share(const YamlEntry& entry) const { return number(entry, 0, 1, "a number from 0 to 1"); }

  Pose2 pose(const YamlEntry& entry) const {
    constexpr const char* kExpected = "[x, y, yaw] in metres and radians";
    std::vector<double> numbers;
    for (const std::string& text : entry.values) {
      const auto value = to_number(text);
      if (!value || std::abs(*value) > 1e5) complain(entry, kExpected);
      numbers.push_back(*value);
    }
    if (!entry.list || numbers.size() != 3) complain(entry, kExpected);
    return {numbers[0], numbers[1], wrap_angle(numbers[2])};
  }

  bool flag(const YamlEntry& entry) const {
    const std::string text = entry.list ? "" : entry.values[0];
    if (text == "1" || text == "true" || text == "True") return true;
    if (text != "0" && text != "false" && text != "False") complain(entry, "0, 1, true or false");
    return false;
  }

  RosMapMode mode(const YamlEntry& entry) const {
    const auto value = entry.list ? std::nullopt : enum_from<RosMapMode>(entry.values[0]);
    if (!value) complain(entry, "one of " + listing(enum_names<RosMapMode>()));
    return *value;
  }

  void note_unknown_keys() {
    for (const YamlEntry& entry : entries_)
      if (std::find(kKeys.begin(), kKeys.end(), entry.key) == kKeys.end())
        notes_.push_back(
            fmt::format("warning: key '{}' is not known{}", printable(entry.key), did_you_mean(entry.key, kKeys)));
  }

  const std::string& name_;
  std::vector<YamlEntry> entries_;
  std::vector<std::string> notes_;
};

}  // namespace

RosMapFile ros_map_file(const std::string& text, const std::string& name) { return MapFileReader(text, name).read(); }

}  // namespace meander
