// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/movingai.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "base/text_file.hpp"
#include "base/visible_text.hpp"

namespace meander {
namespace {

constexpr std::size_t kLargestFile = 256 << 20;  // [bytes]
constexpr std::size_t kMostCells = 100'000'000;
constexpr std::string_view kBlank = " \t\r";

class Lines {
 public:
  Lines(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  /// The next line without its end; false behind the last.
  bool next() {
    if (rest_.empty()) return ended_ = true, line_ = {}, false;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    while (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    ++number_;
    return true;
  }
  std::string_view line() const { return line_; }
  std::vector<std::string_view> words() const {
    std::vector<std::string_view> words;
    for (std::size_t from = line_.find_first_not_of(kBlank); from != std::string_view::npos;) {
      const std::size_t end = std::min(line_.find_first_of(kBlank, from), line_.size());
      words.push_back(line_.substr(from, end - from));
      from = line_.find_first_not_of(kBlank, end);
    }
    return words;
  }
  [[noreturn]] void expected(const char* what) const {
    if (ended_) fail<FileError>("{}:{}: {} expected, got the end of the file", name_, number_ + 1, what);
    fail<FileError>("{}:{}: {} expected, got '{}'", name_, number_, what, visible_text(line_.substr(0, 64)));
  }
  /// A number from `least` to a million.
  template <class Number>
  Number number(std::string_view word, Number least, const char* what) const {
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !(value >= least && value <= Number(1'000'000)))
      expected(what);
    return value;
  }

 private:
  std::string_view rest_, line_;
  const std::string& name_;
  std::size_t number_ = 0;
  bool ended_ = false;
};

/// "height 49": the number behind the word.
int dimension(Lines& lines, std::string_view word, const char* what) {
  lines.next();
  const auto words = lines.words();
  if (words.size() != 2 || words[0] != word) lines.expected(what);
  return lines.number(words[1], 1, what);
}

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Every letter that the format does not name is ground.
void put(MovingAiMap& map, Cell cell, char terrain) {
  const char kind = upper(terrain);
  map.blocked[cell] = kind == '@' || kind == 'O' || kind == 'T' || kind == 'W' ? 1 : 0;
  map.water += kind == 'W';
  map.swamp += kind == 'S';
}

Cell cell_of(const Lines& lines, std::string_view x, std::string_view y, int width, int height) {
  const char* const inside = "a cell inside of the map";
  const Cell cell{lines.number(x, 0, inside), lines.number(y, 0, inside)};
  if (cell.x >= width || cell.y >= height) lines.expected(inside);
  return {cell.x, height - 1 - cell.y};
}

}  // namespace

MovingAiMap movingai_map(const std::string& text, const std::string& name) {
  Lines lines(text, name);
  lines.next();
  if (const auto words = lines.words(); words.size() != 2 || words[0] != "type") lines.expected("'type octile'");
  const int height = dimension(lines, "height", "'height N'"), width = dimension(lines, "width", "'width N'");
  if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > std::min(kMostCells, text.size()))
    fail<FileError>("{}: {} x {} cells promised, more than the file has", name, width, height);
  if (!lines.next() || lines.line().substr(0, 3) != "map") lines.expected("'map'");
  MovingAiMap map{.blocked = Grid<std::uint8_t>(width, height)};
  for (int y = height - 1; y >= 0; --y) {
    lines.next();
    if (lines.line().size() != static_cast<std::size_t>(width))
      lines.expected(fmt::format("a row of {} cells", width).c_str());
    for (int x = 0; x < width; ++x) put(map, {x, y}, lines.line()[static_cast<std::size_t>(x)]);
  }
  while (lines.next())
    if (!lines.words().empty()) lines.expected("nothing more");
  return map;
}

std::vector<MovingAiScenario> movingai_scenarios(const std::string& text, const std::string& name, int width,
                                                 int height) {
  Lines lines(text, name);
  std::vector<MovingAiScenario> scenarios;
  if (!lines.next() || lines.line().substr(0, 9) != "version 1") lines.expected("'version 1'");
  while (lines.next()) {
    const auto words = lines.words();
    if (words.empty()) continue;
    if (words.size() != 9) lines.expected("bucket, map, width, height, start x y, goal x y, length");
    if (lines.number(words[2], 0, "a width") != width || lines.number(words[3], 0, "a height") != height)
      lines.expected(fmt::format("the size {} x {} of the map", width, height).c_str());
    scenarios.push_back({.bucket = lines.number(words[0], 0, "a bucket number"),
                         .map = std::string(words[1]),
                         .start = cell_of(lines, words[4], words[5], width, height),
                         .goal = cell_of(lines, words[6], words[7], width, height),
                         .length = lines.number(words[8], 0.0, "a length")});
  }
  return scenarios;
}

MovingAiMap read_movingai_map(const std::string& path) {
  return movingai_map(read_text_file(path, kLargestFile), path);
}

std::vector<MovingAiScenario> read_movingai_scenarios(const std::string& path, int width, int height) {
  return movingai_scenarios(read_text_file(path, kLargestFile), path, width, height);
}

}  // namespace meander
