// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// hostile PROGRAM SCRIPT: runs a script that wants what it must not, as `PROGRAM --sandbox SCRIPT`, in a folder beside
// which a secret lies, and checks how it ended. The head of the script says what must happen, a line each:
//   -- exit: 1
//   -- error: a regular expression that stderr must match
//   -- output: one for stdout
//   -- options: further options of the program
//   -- prompt: the script is typed at the prompt
//   -- sanitizer: no (native memory is not counted there, or it takes too long)
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kSecret = "secret-3141592653";
/// The limits of every script, unless its head says others.
constexpr double kSeconds = 2, kMemory = 128;  // [s], [MiB]
/// Beyond the limit of time; and beyond that of memory, for the program itself and what a limit is noticed late by.
constexpr double kLate = 2, kProgram = 96;  // [s], [MiB]
/// On a machine that has much else to do; after this the script hangs [s].
constexpr double kPatience = 40;
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// What the head of a script asks for.
struct Wanted {
  int exit = 0;
  std::string error, output;
  std::vector<std::string> options;
  bool prompt = false;
  bool sanitizer = true;  ///< also in builds with one
};

Wanted wanted_by(const std::string& script) {
  Wanted wanted;
  std::istringstream lines(script);
  const std::regex form("-- (exit|error|output|options|prompt|sanitizer):? ?(.*)");
  std::smatch found;
  for (std::string line; std::getline(lines, line) && line.starts_with("--");) {
    if (!std::regex_match(line, found, form)) continue;
    const std::string value = found[2];
    if (found[1] == "exit") wanted.exit = std::stoi(value);
    if (found[1] == "error") wanted.error = value;
    if (found[1] == "output") wanted.output = value;
    if (found[1] == "prompt") wanted.prompt = true;
    if (found[1] == "sanitizer") wanted.sanitizer = false;
    std::istringstream words(found[1] == "options" ? value : "");
    for (std::string word; words >> word;) wanted.options.push_back(word);
  }
  return wanted;
}

/// A folder for the script, and beside it what it must not reach.
struct Surroundings {
  fs::path folder, box;
  std::set<std::string> beside;

  explicit Surroundings(const std::string& name)
      : folder(fs::temp_directory_path() / fmt::format("meander_hostile_{}_{}", name, getpid())), box(folder / "box") {
    fs::remove_all(folder);
    fs::create_directories(box);
    write(folder / "secret.txt", kSecret);
    write(folder / "secret.lua", std::string("print '") + kSecret + "'");
    write(folder / "secret.pgm", std::string("P5\n2 2\n255\n") + "\1\2\3\4");
    fs::create_symlink("../secret.txt", box / "link");
    fs::create_symlink("..", box / "up");
    fs::create_symlink("../made.txt", box / "dangling");
    mkfifo((box / "pipe").c_str(), 0600);
    beside = names();
  }
  ~Surroundings() { fs::remove_all(folder); }

  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder)) all.insert(entry.path().filename());
    return all;
  }
};

struct End {
  int status = 0;
  double computed = 0, memory = 0;  // [s], with all its workers, and [MiB]
  bool late = false;
  std::string output, error;
};

[[noreturn]] void become(const std::vector<std::string>& words, const Surroundings& place, const std::string& input) {
  setsid();
  const auto redirect = [](const fs::path& path, int flags, int to) { dup2(open(path.c_str(), flags, 0600), to); };
  redirect(input.empty() ? "/dev/null" : input, O_RDONLY, STDIN_FILENO);
  redirect(place.folder.string() + ".out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect(place.folder.string() + ".err", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  if (chdir(place.box.c_str()) != 0) _exit(99);
  if (kSanitized) setenv("ASAN_OPTIONS", "detect_leaks=0", 1);  // it looks for leaks in /proc, which is closed
  setenv("MEANDER_SECRET", kSecret, 1);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  _exit(98);
}

std::string taken(const fs::path& path) {
  std::string text = content(path);
  while (text.ends_with('\n')) text.pop_back();
  fs::remove(path);
  return text;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

End run(const std::vector<std::string>& words, const Surroundings& place, const std::string& input) {
  End end;
  const auto start = Clock::now();
  const auto waited = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const pid_t process = fork();
  if (process == 0) become(words, place, input);
  rusage usage{};
  while (wait4(process, &end.status, WNOHANG, &usage) == 0) {
    if (waited() > kPatience && !end.late) {
      end.late = true;
      kill(-process, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  end.computed = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.memory = static_cast<double>(usage.ru_maxrss) / 1024;
  end.output = taken(place.folder.string() + ".out");
  end.error = taken(place.folder.string() + ".err");
  return end;
}

/// Waits a moment for orphans, which come to this process.
bool processes_left() {
  for (int i = 0; i < 100; ++i) {
    const pid_t orphan = waitpid(-1, nullptr, WNOHANG);
    if (orphan < 0) return false;
    if (orphan == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

bool secret_in(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_symlink() && entry.is_regular_file() && content(entry.path()).find(kSecret) != std::string::npos)
      return true;
  return false;
}

bool matches(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern));
}

std::vector<std::string> complaints(const Wanted& wanted, const End& end, const Surroundings& place) {
  std::vector<std::string> list;
  const auto check = [&](bool good, std::string text) {
    if (!good) list.push_back(std::move(text));
  };
  check(!end.late, "hangs");
  check(kSanitized || end.computed < kSeconds + kLate, fmt::format("computed for {:.1f} s", end.computed));
  check(WIFEXITED(end.status) && WEXITSTATUS(end.status) == wanted.exit,
        WIFEXITED(end.status) ? fmt::format("exit code {}", WEXITSTATUS(end.status))
                              : fmt::format("ended by signal {}", WTERMSIG(end.status)));
  check(matches(end.error, wanted.error), "stderr does not match '" + wanted.error + "'");
  check(matches(end.output, wanted.output), "stdout does not match '" + wanted.output + "'");
  check((end.output + end.error).find(kSecret) == std::string::npos, "the secret was read");
  check(!secret_in(place.box), "the secret was copied");
  check(content(place.folder / "secret.txt") == kSecret, "the secret was changed");
  check(place.names() == place.beside, "something was made or removed outside of the folder");
  check(!processes_left(), "a process is left");
  check(kSanitized || end.memory < kMemory + kProgram, fmt::format("took {:.0f} MiB", end.memory));
  return list;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fmt::print(stderr, "usage: hostile PROGRAM SCRIPT\n"), 2;
  const std::string program = fs::absolute(argv[1]), source = fs::absolute(argv[2]);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const Wanted wanted = wanted_by(content(source));
  if (kSanitized && !wanted.sanitizer) return fmt::print("not under the sanitizer\n"), 0;
  const Surroundings place(fs::path(source).stem());
  fs::copy_file(source, place.box / "hostile.lua");
  std::vector<std::string> words = {program, fmt::format("--sandbox-seconds={}", kSeconds),
                                    fmt::format("--sandbox-memory={}", kMemory), "--sandbox-instructions=100000000"};
  words.insert(words.end(), wanted.options.begin(), wanted.options.end());
  if (wanted.prompt)
    words.push_back("-i");
  else
    words.insert(words.end(), {"hostile.lua", place.folder.string()});
  const End end = run(words, place, wanted.prompt ? source : "");
  const auto list = complaints(wanted, end, place);
  fmt::print("{:.2f} s, {:.0f} MiB\n", end.computed, end.memory);
  if (list.empty()) return 0;
  for (const std::string& complaint : list) fmt::print("{}\n", complaint);
  fmt::print("stdout:\n{:.2000}\nstderr:\n{:.2000}\n", end.output, end.error);
  return 1;
}
