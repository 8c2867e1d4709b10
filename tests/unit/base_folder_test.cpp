// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "own_folder.hpp"

namespace meander {
namespace {

TEST(Folder, MakesAllThatIsMissing) {
  const auto top = own_folder() / "top";
  std::filesystem::remove_all(top);
  make_folder(top / "a" / "b");
  EXPECT_TRUE(std::filesystem::is_directory(top / "a" / "b"));
  make_folder(top / "a" / "b");
  std::filesystem::remove_all(top);
}

TEST(Folder, RefusesAPathWithAFileInIt) {
  const auto file = own_folder() / "file";
  std::ofstream(file) << "x";
  EXPECT_THROW(make_folder(file), FileError);
  EXPECT_THROW(make_folder(file / "below"), FileError);
  EXPECT_THROW(make_folder(""), FileError);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace meander
