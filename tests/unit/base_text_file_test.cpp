// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/text_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "own_folder.hpp"

namespace meander {
namespace {

namespace fs = std::filesystem;

std::string refusal(const std::string& path, std::size_t most) {
  try {
    read_text_file(path, most);
  } catch (const FileError& error) {
    return error.what();
  }
  return "read";
}

TEST(TextFile, ReadsAllBytesUpToTheLimit) {
  const std::string path = (own_folder() / "text.txt").string();
  std::string content(200'000, 'x');
  content[7] = '\0';
  write_file_atomically(path, content);
  EXPECT_EQ(read_text_file(path, content.size()), content);
  EXPECT_EQ(refusal(path, content.size() - 1), path + ": larger than the allowed 0 MB");
  fs::remove(path);
}

TEST(TextFile, SaysWhatIsWrong) {
  const std::string source = MEANDER_SOURCE_DIR;
  EXPECT_EQ(refusal(source + "/src", 10), source + "/src: is a folder");
  EXPECT_EQ(refusal(source + "/CMakeLits.txt", 10),
            source + "/CMakeLits.txt: no such file; did you mean '" + source + "/CMakeLists.txt'?");
  EXPECT_EQ(refusal(source + "/nothing/like/it", 10), source + "/nothing/like/it: no such file");
  EXPECT_EQ(refusal("/dev/zero", 1 << 20), "/dev/zero: larger than the allowed 1 MB");
}

}  // namespace
}  // namespace meander
