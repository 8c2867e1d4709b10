// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"

namespace meander {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "meander_atomic_XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string at(const char* name) const { return (folder_ / name).string(); }
  static std::string content(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  std::string refusal(const std::string& path, std::string_view text = "x") const {
    try {
      write_file_atomically(path, text);
    } catch (const FileError& error) {
      return error.what();
    }
    return "written";
  }

  fs::path folder_;
};

TEST_F(AtomicFile, WritesAndReplacesWholeContent) {
  write_file_atomically(at("a"), "first, and longer");
  write_file_atomically(at("a"), std::string_view("sec\0ond", 7));
  EXPECT_EQ(content(at("a")), std::string("sec\0ond", 7));
  write_file_atomically(at("a"), "");
  EXPECT_EQ(content(at("a")), "");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, NewFileFollowsUmaskAndOldFileKeepsItsMode) {
  const mode_t before = ::umask(027);
  write_file_atomically(at("new"), "x");
  ::umask(before);
  write_file_atomically(at("old"), "x");
  ASSERT_EQ(::chmod(at("old").c_str(), 0751), 0);
  write_file_atomically(at("old"), "y");
  EXPECT_EQ(fs::status(at("new")).permissions(), fs::perms(0640));
  EXPECT_EQ(fs::status(at("old")).permissions(), fs::perms(0751));
}

TEST_F(AtomicFile, FollowsSymbolicLinks) {
  write_file_atomically(at("target"), "old");
  fs::create_symlink(at("target"), at("link"));
  write_file_atomically(at("link"), "new");
  EXPECT_TRUE(fs::is_symlink(at("link")));
  EXPECT_EQ(content(at("target")), "new");
}

TEST_F(AtomicFile, FollowsLinksToWhatIsNotThereYet) {
  fs::create_directory(at("sub"));
  fs::create_symlink("sub/second", at("first"));
  fs::create_symlink("target", at("sub/second"));
  write_file_atomically(at("first"), "new");
  EXPECT_TRUE(fs::is_symlink(at("first")));
  EXPECT_TRUE(fs::is_symlink(at("sub/second")));
  EXPECT_EQ(content(at("sub/target")), "new");
  write_file_atomically(at("first"), "newer");
  EXPECT_EQ(content(at("sub/target")), "newer");
  fs::create_symlink("nowhere/target", at("lost"));
  EXPECT_EQ(refusal(at("lost")), at("lost") + ": cannot be written: No such file or directory");
  fs::create_symlink("loop", at("loop"));
  EXPECT_EQ(refusal(at("loop")), at("loop") + ": cannot be written: Too many levels of symbolic links");
  EXPECT_TRUE(fs::is_symlink(at("lost")));
  EXPECT_EQ(files(), 4u);
}

TEST_F(AtomicFile, NamesMayBeAsLongAsTheSystemAllows) {
  const std::string longest(255, 'n');
  write_file_atomically(at(longest.c_str()), "old");
  write_file_atomically(at(longest.c_str()), "new");
  EXPECT_EQ(content(at(longest.c_str())), "new");
  EXPECT_EQ(files(), 1u);
  EXPECT_EQ(refusal(at((longest + "n").c_str())),
            at((longest + "n").c_str()) + ": cannot be written: File name too long");
}

TEST_F(AtomicFile, RefusalNamesFileAndReason) {
  EXPECT_EQ(refusal(at("no/such/file")),
            at("no/such/file") + ": cannot be written: there is no folder '" + at("no/such") + "'");
  EXPECT_EQ(refusal(folder_.string()), folder_.string() + ": cannot be written: Is a directory");
  EXPECT_EQ(refusal(""), ": cannot be written: No such file or directory");
  EXPECT_EQ(files(), 0u);
}

TEST_F(AtomicFile, ReadOnlyFileIsNotReplaced) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  write_file_atomically(at("locked"), "old");
  ASSERT_EQ(::chmod(at("locked").c_str(), 0444), 0);
  EXPECT_EQ(refusal(at("locked")), at("locked") + ": cannot be written: Permission denied");
  EXPECT_EQ(content(at("locked")), "old");
}

TEST_F(AtomicFile, DevicesAreWrittenDirectly) {
  EXPECT_EQ(refusal("/dev/null"), "written");
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(refusal("/dev/full"), "/dev/full: cannot be written: No space left on device");
}

TEST_F(AtomicFile, FailedWriteLeavesTheOldFileAndNothingElse) {
  write_file_atomically(at("a"), "old");
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{1000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &tight);
  const std::string message = refusal(at("a"), std::string(5000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, at("a") + ": cannot be written: File too large");
  EXPECT_EQ(content(at("a")), "old");
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace meander
