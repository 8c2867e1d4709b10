// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "base/text_file.hpp"
#include "world/import_ros_map.hpp"
#include "world/import_yaml.hpp"
#include "world_import_support.hpp"

namespace meander {
namespace {

const std::string kGood =
    "image: map.pgm\nresolution: 0.05\norigin: [1, -2.5, 0.5]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

std::string without(const std::string& key) {
  const std::size_t from = kGood.find(key + ":");
  return kGood.substr(0, from) + kGood.substr(kGood.find('\n', from) + 1);
}

std::string with(const std::string& key, const std::string& value) { return without(key) + key + ": " + value + "\n"; }

TEST(FlatYaml, GivesBackEveryWrittenScalar) {
  Stream stream(5, "scalars");
  const std::string letters = "ab 1.:#'\"\\[]{},&*!|>%@`-\n~/_";
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (int n = stream.below(8); n > 0; --n)
      text += letters[static_cast<std::size_t>(stream.below(static_cast<int>(letters.size())))];
    const auto entries = flat_yaml("key: " + yaml_scalar(text) + "\nlist: [" + yaml_scalar(text) + ", 2]\n", "yaml");
    ASSERT_EQ(entries.size(), 2u) << text;
    EXPECT_EQ(entries[0].values[0], text);
    EXPECT_EQ(entries[1].values[0], text);
  }
}

TEST(FlatYaml, ReadsEveryForm) {
  const std::string path = std::string(MEANDER_SOURCE_DIR) + "/tests/fuzz/corpus/world_ros_yaml_fuzz/every_form.yaml";
  const auto entries = flat_yaml(read_text_file(path, 1 << 20), "yaml");
  ASSERT_EQ(entries.size(), 8u);
  EXPECT_EQ(entries[0].key, "image");
  EXPECT_EQ(entries[0].line, 3);
  EXPECT_EQ(entries[0].values, (std::vector<std::string>{"maps/it's here.png"}));
  EXPECT_EQ(entries[3].values, (std::vector<std::string>{"-1.5", "2.", "0.25"}));
  EXPECT_TRUE(entries[3].list);
  EXPECT_EQ(entries[7].values, (std::vector<std::string>{"one", "two, three", "four"}));
  EXPECT_EQ(entries[7].line, 14);
}

TEST(FlatYaml, ReadsWindowsLinesAndByteOrderMark) {
  const auto entries = flat_yaml("\xef\xbb\xbfimage: a.pgm\r\nresolution: 0.1\r\n", "yaml");
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].values[0], "a.pgm");
  EXPECT_EQ(entries[1].values[0], "0.1");
}

TEST(FlatYaml, NamesTheLineOfWhatItDoesNotUnderstand) {
  const std::pair<const char*, const char*> cases[] = {
      {"a: 1\nb:\n  c: 2\n", "map.yaml:3: a key in the first column expected"},
      {"a: 1\n\nb: {c: d}\n", "map.yaml:3: a plain or quoted value expected, got '{c: d}'"},
      {"a: 1\na: 2\n", "map.yaml:2: key 'a' comes twice, first in line 1"},
      {"a: [1, 2\n", "expected"},
      {"a: [1, [2]]\n", "map.yaml:1: a plain or quoted value expected"},
      {"a: 'x\n", "map.yaml:1: ' expected at the end"},
      {"a: \"\\q\"\n", "map.yaml:1: the escape '\\q'"},
      {"a: b: c\n", "map.yaml:1: a single value expected"},
      {"a: |\n  text\n", "map.yaml:1: a plain or quoted value"},
      {"no colon\n", "map.yaml:1: 'key: value' expected, got 'no colon'"},
      {"a: 1\n---\nb: 2\n", "map.yaml:2: a second document"},
      {"a:\nb: 1\n", "map.yaml:1: key 'a': a value expected"},
      {"a: 'x' y\n", "map.yaml:1: the end of the line expected, got 'y'"}};
  for (const auto& [text, expected] : cases) {
    const std::string got = message([&, &yaml = text] { flat_yaml(yaml, "map.yaml"); });
    EXPECT_NE(got.find(expected), std::string::npos) << text << " -> " << got;
  }
}

TEST(RosMapFile, ReadsEveryKey) {
  const RosMapFile file = ros_map_file(kGood + "mode: scale\n", "map.yaml");
  EXPECT_EQ(file.image, "map.pgm");
  EXPECT_EQ(file.resolution, 0.05);
  EXPECT_EQ(file.origin, (Pose2{1, -2.5, 0.5}));
  EXPECT_FALSE(file.negate);
  EXPECT_EQ(file.mode, RosMapMode::scale);
  EXPECT_TRUE(file.notes.empty());
  EXPECT_TRUE(ros_map_file(with("negate", "true"), "map.yaml").negate);
}

TEST(RosMapFile, SaysWhatIsWrongAndWhere) {
  const std::pair<std::string, const char*> cases[] = {
      {with("resolution", "fine"),
       "map.yaml:6: key 'resolution': a number from 0.001 to 1000 [m/pixel] expected, got 'fine'"},
      {with("resolution", "-0.05"), "got '-0.05'"},
      {with("resolution", "0"), "got '0'"},
      {with("resolution", "nan"), "got 'nan'"},
      {with("resolution", "[0.05]"), "expected, got a list of 1"},
      {without("resolution"), "map.yaml: key 'resolution' is missing"},
      {without("resolution") + "resolutoin: 0.05\n", "is 'resolutoin' meant for it?"},
      {without("image"), "key 'image' is missing"},
      {with("origin", "[1, 2]"), "key 'origin': [x, y, yaw] in metres and radians expected, got a list of 2"},
      {with("origin", "[1, 2, north]"), "[x, y, yaw]"},
      {with("origin", "1"), "[x, y, yaw]"},
      {with("negate", "2"), "key 'negate': 0, 1, true or false expected, got '2'"},
      {with("free_thresh", "1.5"), "a number from 0 to 1 expected"},
      {with("free_thresh", "0.7"), "free_thresh below occupied_thresh expected, got 0.7 and 0.65"},
      {kGood + "mode: binary\n", "one of trinary, scale, raw expected, got 'binary'"}};
  for (const auto& [text, expected] : cases) {
    const std::string got = message([&, &yaml = text] { ros_map_file(yaml, "map.yaml"); });
    EXPECT_NE(got.find(expected), std::string::npos) << text << " -> " << got;
  }
}

TEST(RosMapFile, NotesDefaultsAndUnknownKeys) {
  EXPECT_TRUE(mentions(ros_map_file(without("free_thresh"), "m").notes, "'free_thresh' is missing, 0.196 is taken"));
  EXPECT_TRUE(mentions(ros_map_file(kGood + "mod: raw\n", "m").notes, "key 'mod' is not known; did you mean 'mode'?"));
}

}  // namespace
}  // namespace meander
