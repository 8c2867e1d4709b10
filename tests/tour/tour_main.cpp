// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// tour [--bless] PAGE: types what stands in the ```console blocks of a page into the built program on a terminal and
// compares what comes with what stands there. See docs/prompt.md.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>

#include "../unit/repl_pty.hpp"

namespace meander::test {
namespace {

using Lines = std::vector<std::string>;

constexpr std::string_view kShell = "$ ";
constexpr std::string_view kInput = "> ";
constexpr std::string_view kMore = ">> ";
constexpr const char* kKey = "^C";       // pressed where it stands
constexpr const char* kLeftOut = "...";  // in a page: any number of lines

Lines lines_of(std::string text) {
  std::erase(text, '\r');
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}

bool is_typed(const std::string& line) {
  return line.starts_with(kShell) || line.starts_with(kInput) || line.starts_with(kMore);
}

/// `...` stands for any number of lines.
bool agrees(std::span<const std::string> page, std::span<const std::string> answer) {
  if (page.empty()) return answer.empty();
  if (page[0] != kLeftOut) return !answer.empty() && page[0] == answer[0] && agrees(page.subspan(1), answer.subspan(1));
  for (std::size_t skipped = 0; skipped <= answer.size(); ++skipped)
    if (agrees(page.subspan(1), answer.subspan(skipped))) return true;
  return false;
}

/// A reader at a terminal of his own, in a folder with the worlds.
class Reader {
 public:
  Reader() {
    namespace fs = std::filesystem;
    fs::create_directory_symlink(fs::path(MEANDER_SOURCE_DIR) / "worlds", home_ / "worlds");
    fs::create_directory(home_ / "bin");
    fs::create_symlink(MEANDER_PROGRAM, home_ / "bin/meander");
  }

  /// What comes when the line is typed; `expected` tells whether and when Ctrl-C is pressed.
  Lines type(const std::string& line, const Lines& expected) {
    if (line.starts_with(kShell)) return command(line.substr(kShell.size()));
    if (!session_) throw std::runtime_error("'" + line + "' stands before '$ meander'");
    const std::string text = line.substr(line.starts_with(kMore) ? kMore.size() : kInput.size());
    if (text == ".quit") {
      session_->send(text + "\r");
      session_->wait_for_exit();
      session_.reset();
      return {};
    }
    const auto key = std::find(expected.begin(), expected.end(), kKey);
    if (key != expected.end()) return interrupted(text, {expected.begin(), key});
    const std::string answer = session_->enter(text);
    return answer == ">>" ? Lines{} : lines_of(answer);
  }

 private:
  Lines command(const std::string& line) {
    if (session_) throw std::runtime_error("'" + line + "': the prompt is still open");
    const std::map<std::string, std::string> environment = {{"PATH", home_ / "bin" + ":/usr/bin:/bin"}};
    auto terminal = std::make_unique<Terminal>(home_.path(), shell("stty rows 40 cols 90; " + line), environment);
    if (line != "meander") {
      terminal->wait_for_exit();
      return lines_of(terminal->transcript());
    }
    session_ = std::move(terminal);
    std::string greeting = session_->wait_for("\r\n> ");
    greeting.resize(greeting.size() - 2);
    return lines_of(greeting);
  }

  Lines interrupted(const std::string& text, const Lines& before) {
    session_->send(text + "\r");
    session_->wait_for("\r\n");
    std::string answer;
    for (const std::string& line : before) answer += session_->wait_for(line + "\r\n");
    session_->send("\x03");
    answer += session_->wait_for("\r\n> ");
    answer.resize(answer.size() - 2);
    return lines_of(answer);
  }

  TemporaryFolder home_;
  std::unique_ptr<Terminal> session_;
};

struct Page {
  Lines now;  ///< with the answers of the program
  int differences = 0;
};

/// Walks through the page; only what stands in ```console blocks is typed.
Page walk(const std::string& path, const Lines& page) {
  Reader reader;
  Page result;
  bool console = false;
  for (std::size_t i = 0; i < page.size();) {
    const std::string& line = page[i++];
    result.now.push_back(line);
    if (line.starts_with("```")) console = !console && line == "```console";
    if (!console || !is_typed(line)) continue;
    Lines expected;
    while (i < page.size() && !is_typed(page[i]) && page[i] != "```") expected.push_back(page[i++]);
    const Lines answer = reader.type(line, expected);
    const bool same = agrees(expected, answer);
    const Lines& kept = same ? expected : answer;
    result.now.insert(result.now.end(), kept.begin(), kept.end());
    if (same) continue;
    ++result.differences;
    fmt::print("{}: {}\n", path, line);
    for (const std::string& text : expected) fmt::print("  - {}\n", text);
    for (const std::string& text : answer) fmt::print("  + {}\n", text);
  }
  return result;
}

int run(int argc, char** argv) {
  const bool bless = argc == 3 && std::string_view(argv[1]) == "--bless";
  if (argc != 2 && !bless) return fmt::print(stderr, "tour [--bless] PAGE\n"), 2;
  const std::string path = argv[argc - 1];
  std::ifstream file(path);
  const Page page = walk(path, lines_of({std::istreambuf_iterator<char>(file), {}}));
  fmt::print("{}: {} differences\n", path, page.differences);
  if (!bless || page.differences == 0) return page.differences > 0;
  std::ofstream out(path, std::ios::trunc);
  for (const std::string& line : page.now) out << line << '\n';
  return 0;
}

}  // namespace
}  // namespace meander::test

int main(int argc, char** argv) {
  try {
    return meander::test::run(argc, argv);
  } catch (const std::exception& failure) {
    fmt::print(stderr, "tour: {}\n", failure.what());
    return 1;
  }
}
