// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// transcripts PROGRAM [--bless] FILE...
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/error.hpp"
#include "transcript.hpp"

namespace meander {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::vector<std::string> lines;
  std::istringstream text(read_file(path));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// Where the commands of one transcript run.
class Workshop {
 public:
  explicit Workshop(const fs::path& program) {
    std::string pattern = (fs::temp_directory_path() / "meander-transcript-XXXXXX").string();
    if (!mkdtemp(pattern.data())) fail<FileError>("{}: cannot be made", pattern);
    root_ = pattern;
    fs::create_directories(root_ / "io");
    fs::create_directories(root_ / "bin");
    fs::create_directories(root_ / "work");
    fs::create_symlink(fs::absolute(program), root_ / "bin" / "meander");
    for (const char* folder : {"docs", "examples", "lua", "worlds"})
      fs::create_directory_symlink(fs::path(MEANDER_SOURCE_DIR) / folder, root_ / "work" / folder);
    fs::create_symlink(fs::path(MEANDER_SOURCE_DIR) / "README.md", root_ / "work" / "README.md");
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  TranscriptStep run(const TranscriptStep& step) const {
    std::ofstream input(root_ / "io" / "in", std::ios::trunc);
    for (const std::string& line : step.input) input << line << '\n';
    input.close();
    const pid_t child = fork();
    if (child == 0) become(step.command);
    int status = 0;
    waitpid(child, &status, 0);
    TranscriptStep done = step;
    done.out = lines_of(root_ / "io" / "out");
    done.err = lines_of(root_ / "io" / "err");
    done.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return done;
  }

 private:
  void redirect(int descriptor, const char* name, int flags) const {
    const int file = open((root_ / "io" / name).c_str(), flags, 0600);
    if (file < 0 || dup2(file, descriptor) < 0) _exit(126);
    close(file);
  }

  [[noreturn]] void become(const std::string& command) const {
    redirect(STDIN_FILENO, "in", O_RDONLY);
    redirect(STDOUT_FILENO, "out", O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, "err", O_WRONLY | O_CREAT | O_TRUNC);
    const std::string work = (root_ / "work").string();
    const std::string path = (root_ / "bin").string() + ":" + std::getenv("PATH");
    if (chdir(work.c_str()) != 0) _exit(126);
    for (const char* name : {"XDG_STATE_HOME", "XDG_CONFIG_HOME", "NO_COLOR", "LUA_PATH", "LUA_INIT"}) unsetenv(name);
    setenv("PATH", path.c_str(), 1);
    setenv("HOME", work.c_str(), 1);
    setenv("TERM", "dumb", 1);
    std::signal(SIGINT, SIG_DFL);  // ignored where the tests run in the background
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }

  fs::path root_;
};

/// The number of commands that did something else; with `bless`, the file is rewritten to say what they did.
int run_transcript(const fs::path& program, const std::string& path, bool bless) {
  Transcript transcript = parse_transcript(path, read_file(path));
  const Workshop workshop(program);
  int failed = 0;
  for (TranscriptStep& step : transcript.steps) {
    const TranscriptStep done = workshop.run(step);
    const std::string differs = difference(step, done);
    if (differs.empty()) continue;
    ++failed;
    fmt::print("{}:{}: $ {}\n{}", path, step.line, step.command, differs);
    if (bless) step = blessed(step, done);
  }
  fmt::print("{}: {} of {} as expected\n", path, transcript.steps.size() - failed, transcript.steps.size());
  if (bless && failed) std::ofstream(path, std::ios::trunc) << transcript_text(transcript);
  return bless ? 0 : failed;
}

int run(int argc, char** argv) {
  if (argc < 3) return fmt::print(stderr, "transcripts PROGRAM [--bless] FILE...\n"), 2;
  const bool bless = std::string_view(argv[2]) == "--bless";
  int failed = 0;
  for (int i = bless ? 3 : 2; i < argc; ++i) failed += run_transcript(argv[1], argv[i], bless);
  return failed ? 1 : 0;
}

}  // namespace
}  // namespace meander

int main(int argc, char** argv) {
  try {
    return meander::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "transcripts: {}\n", error.what());
    return 2;
  }
}
