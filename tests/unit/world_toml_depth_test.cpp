// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/toml_depth.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "world/world_file.hpp"

namespace meander {
namespace {

std::string repeated(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

bool refused(const std::string& text) {
  try {
    check_key_depth(text, "demo.toml");
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("a key of more than 64 parts"), std::string::npos) << error.what();
    return true;
  }
  return false;
}

TEST(TomlDepth, KeysOfManyPartsAreRefused) {
  EXPECT_TRUE(refused(repeated("a.", 100) + "b = 1"));
  EXPECT_TRUE(refused("x = 1\n[" + repeated("a . ", 100) + "b]"));
  EXPECT_TRUE(refused("x = { " + repeated("1.", 100) + "b = 1 }"));
  EXPECT_TRUE(refused(repeated("\"a,]\".", 100) + "b = 1"));
  EXPECT_TRUE(refused(repeated("'\"'.", 100) + "b = 1"));
  EXPECT_TRUE(refused("x = \"\"\"\n\"quoted\"\"\"\n" + repeated("a.", 100) + "b = 1"));
  EXPECT_TRUE(refused("x = { y = \"\"\"a\"\"\"\"\"," + repeated("a.", 100) + "b = 1 }"));
  EXPECT_TRUE(refused("x = \"\\\"\" # \"\n" + repeated("a.", 100) + "b = 1"));
}

TEST(TomlDepth, DotsElsewhereAreNone) {
  EXPECT_FALSE(refused("x = [" + repeated("[0.5, 1.5], ", 1000) + "]"));
  EXPECT_FALSE(refused("x = '" + repeated("a.", 1000) + "'"));
  EXPECT_FALSE(refused("x = \"\"\"" + repeated("a.\n", 1000) + "\"\"\""));
  EXPECT_FALSE(refused("# " + repeated("a.", 1000)));
  EXPECT_FALSE(refused(repeated("a.b.c = 1\n", 1000)));
}

TEST(TomlDepth, NestedAsDeepAsAllowedIsRead) {
  const std::string deepest =
      repeated("[" + repeated("a.", 62) + "b]\n", 1) + repeated(repeated("a.", 62) + "b = {", 200) + repeated("}", 200);
  EXPECT_THROW(world_from_toml(deepest), FileError);
}

}  // namespace
}  // namespace meander
