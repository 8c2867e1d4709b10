// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"

namespace meander {
namespace {

TEST(Folder, MakesAllThatIsMissing) {
  const auto top = std::filesystem::path(testing::TempDir()) / "meander_folder_test";
  std::filesystem::remove_all(top);
  make_folder(top / "a" / "b");
  EXPECT_TRUE(std::filesystem::is_directory(top / "a" / "b"));
  make_folder(top / "a" / "b");
  std::filesystem::remove_all(top);
}

TEST(Folder, RefusesAPathWithAFileInIt) {
  const auto file = std::filesystem::path(testing::TempDir()) / "meander_folder_file";
  std::ofstream(file) << "x";
  EXPECT_THROW(make_folder(file), FileError);
  EXPECT_THROW(make_folder(file / "below"), FileError);
  EXPECT_THROW(make_folder(""), FileError);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace meander
