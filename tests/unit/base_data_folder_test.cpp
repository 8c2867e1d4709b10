// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/data_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder.hpp"
#include "base/near_path.hpp"
#include "own_folder.hpp"

namespace meander {
namespace {

namespace fs = std::filesystem;

/// A data folder with two files, and an empty working folder.
class DataFolder : public testing::Test {
 protected:
  DataFolder() : before_(fs::current_path()) {
    make_folder(data_ + "/things");
    make_folder((own_folder() / "work").string());
    write_file_atomically(data_ + "/things/alpha.toml", "a");
    write_file_atomically(data_ + "/things/beta.lua", "b");
    fs::current_path(own_folder() / "work");
    setenv("MEANDER_DATA_DIR", data_.c_str(), 1);
  }
  ~DataFolder() override {
    unsetenv("MEANDER_DATA_DIR");
    fs::current_path(before_);
    fs::remove_all(own_folder() / "work");
    fs::remove_all(data_);
  }

  const std::string data_ = (own_folder() / "data").string();

 private:
  fs::path before_;
};

std::string refusal(const std::string& path) {
  try {
    return readable_file(path);
  } catch (const FileError& error) {
    return error.what();
  }
}

TEST_F(DataFolder, IsLookedInAfterTheWorkingFolder) {
  EXPECT_EQ(data_folder(), data_);
  EXPECT_EQ(find_file("things/alpha.toml"), data_ + "/things/alpha.toml");
  make_folder("things");
  write_file_atomically("things/alpha.toml", "mine");
  EXPECT_EQ(find_file("things/alpha.toml"), "things/alpha.toml");
  EXPECT_EQ(find_file("things/beta.lua"), data_ + "/things/beta.lua");
}

TEST_F(DataFolder, IsNotLeftByAName) {
  write_file_atomically(data_ + "/../outside.toml", "");
  EXPECT_EQ(find_file("x/../../outside.toml"), std::nullopt);
  EXPECT_EQ(find_file("/things/alpha.toml"), std::nullopt);
  EXPECT_EQ(find_file(""), std::nullopt);
  fs::remove(data_ + "/../outside.toml");
}

TEST_F(DataFolder, MessagesHintOrSayWhereWasLooked) {
  EXPECT_EQ(refusal("thing/alfa.toml"), "thing/alfa.toml: no such file; did you mean 'things/alpha.toml'?");
  EXPECT_EQ(refusal("things/beta"), "things/beta: no such file; did you mean 'things/beta.lua'?");
  EXPECT_EQ(refusal("nothing.like"), "nothing.like: no such file, here or in " + data_);
  EXPECT_EQ(refusal("/nothing.like"), "/nothing.like: no such file");
}

TEST_F(DataFolder, CompletesNames) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(data_files(""), Names{"things/"});
  EXPECT_EQ(data_files("th"), Names{"things/"});
  EXPECT_EQ(data_files("things/"), (Names{"things/alpha.toml", "things/beta.lua"}));
  EXPECT_EQ(data_files("things/b"), Names{"things/beta.lua"});
  EXPECT_EQ(data_files("../"), Names());
  EXPECT_EQ(data_files("nothing/"), Names());
}

TEST(DataFolderOfABuild, IsBesideEveryProgram) {
  EXPECT_TRUE(fs::exists(data_folder() + "/worlds/office.toml")) << data_folder();
  EXPECT_TRUE(fs::exists(data_folder() + "/examples/first_run.lua"));
}

TEST(NearPath, FollowsEveryPart) {
  const std::string source = MEANDER_SOURCE_DIR;
  EXPECT_EQ(near_path("wolrds/ofice.toml", source), "worlds/office.toml");
  EXPECT_EQ(near_path("examples/first_run", source), "examples/first_run.lua");
  EXPECT_EQ(near_path("nowhere/office.toml", source), std::nullopt);
  EXPECT_EQ(near_path("", source), std::nullopt);
}

}  // namespace
}  // namespace meander
