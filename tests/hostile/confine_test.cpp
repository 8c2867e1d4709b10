// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The second wall of a sandbox alone: what C++ code that an attacker has taken over could do. Each test confines a
// forked child, there is no way back.
#include "app/confine.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <functional>
#include <thread>

namespace meander {
namespace {

namespace fs = std::filesystem;

class Confine : public ::testing::Test {
 protected:
  Confine() : folder_(fs::temp_directory_path() / ("meander_confine_" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "box");
  }
  ~Confine() override { fs::remove_all(folder_); }

  /// The exit code of a child in which `attempt` runs behind the walls; -1 when a signal ended it.
  int inside(const std::function<int()>& attempt) const {
    const pid_t process = fork();
    if (process == 0) {
      confine({.folder = (folder_ / "box").string(), .memory = 64, .seconds = 0.5, .output = 1}, {});
      _exit(attempt());
    }
    int status = 0;
    waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// 0 or the errno of opening a file.
  static int opened(const std::string& path, int flags) { return open(path.c_str(), flags, 0600) >= 0 ? 0 : errno; }

  fs::path folder_;
};

TEST_F(Confine, FilesOfTheFolderOnly) {
  if (inside([&] { return confine_files(folder_.string(), {}) ? 0 : 1; }) != 0) GTEST_SKIP() << "no Landlock";
  EXPECT_EQ(inside([&] { return opened(folder_ / "box" / "new", O_WRONLY | O_CREAT); }), 0);
  EXPECT_EQ(inside([&] { return opened(folder_ / "new", O_WRONLY | O_CREAT); }), EACCES);
  EXPECT_EQ(inside([] { return opened("/etc/passwd", O_RDONLY); }), EACCES);
  EXPECT_EQ(inside([] { return opened("/proc/self/environ", O_RDONLY); }), EACCES);
}

TEST_F(Confine, NoOtherPrograms) {
  EXPECT_EQ(inside([] {
              execl("/bin/true", "true", nullptr);
              return errno;
            }),
            EPERM);
}

TEST_F(Confine, NoNetwork) {
  EXPECT_EQ(inside([] { return socket(AF_INET, SOCK_STREAM, 0) >= 0 ? 0 : errno; }), EPERM);
  EXPECT_EQ(inside([] { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0 ? 0 : errno; }), EPERM);
}

TEST_F(Confine, NoLinks) {
  EXPECT_EQ(inside([&] { return symlink("/etc", (folder_ / "box" / "etc").c_str()) == 0 ? 0 : errno; }), EPERM);
}

TEST_F(Confine, NothingIsTypedIntoTheTerminal) {
  EXPECT_EQ(inside([] { return ioctl(-1, TIOCSTI, "x") == 0 ? 0 : errno; }), EPERM);
  EXPECT_EQ(inside([] { return ioctl(-1, TIOCGWINSZ, nullptr) == 0 ? 0 : errno; }), EBADF) << "others pass";
}

TEST_F(Confine, WorkersAndThreadsStillStart) {
  EXPECT_EQ(inside([] {
              const pid_t process = fork();
              if (process == 0) _exit(7);
              int status = 0;
              waitpid(process, &status, 0);
              std::thread([] {}).join();
              return WEXITSTATUS(status);
            }),
            7);
}

TEST_F(Confine, NoFileGrowsWithoutEnd) {
  EXPECT_EQ(inside([&] {
              const int file = open((folder_ / "box" / "large").c_str(), O_WRONLY | O_CREAT, 0600);
              return ftruncate(file, 2 << 20) == 0 ? 0 : errno;
            }),
            EFBIG);
}

TEST_F(Confine, AnEndlessLoopEnds) {
  EXPECT_EQ(inside([] {
              for (volatile bool on = true; on;) {
              }
              return 0;
            }),
            1);
}

}  // namespace
}  // namespace meander
