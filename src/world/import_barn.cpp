// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_barn.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "base/text_file.hpp"
#include "world/import_raster.hpp"
#include "world/text.hpp"

namespace meander {
namespace {

constexpr std::size_t kLargestTable = 256 << 20;  // [bytes]
constexpr Pose2 kStart{-2.25, 3, kPi / 2};
constexpr double kGoalAhead = 10, kGoalTolerance = 1;
constexpr double kMargin = 1;  // of the bounds around everything [m]

const std::vector<std::string> kColumns = {"world", "x_m", "y_m", "radius_m"};

struct Row {
  int world;
  Disc disc;
};

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  /// The rows of one world; `found` gets the numbers of all.
  std::vector<Disc> read(int index, std::set<int>& found, const Work& work) {
    next_line();
    read_head();
    std::vector<Disc> discs;
    while (next_line()) {
      if (line_number_ % 10000 == 0) work.poll();
      if (line_.empty()) continue;
      const Row row = read_row();
      found.insert(row.world);
      if (row.world == index) discs.push_back(row.disc);
    }
    return discs;
  }

 private:
  bool next_line() {
    if (rest_.empty()) return line_ = {}, false;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    while (!line_.empty() && (line_.back() == '\r' || line_.back() == ' ')) line_.remove_suffix(1);
    ++line_number_;
    return true;
  }

  std::vector<std::string_view> cells() const {
    std::vector<std::string_view> cells;
    for (std::size_t from = 0; from <= line_.size();) {
      const std::size_t end = std::min(line_.find(',', from), line_.size());
      std::string_view cell = line_.substr(from, end - from);
      while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
      while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
      cells.push_back(cell);
      from = end + 1;
    }
    return cells;
  }

  void read_head() {
    const auto names = cells();
    width_ = names.size();
    for (const std::string& column : kColumns) {
      const auto at = std::find(names.begin(), names.end(), column);
      if (at == names.end())
        fail<FileError>("{}:1: a head line with the columns {} expected, got '{}'", name_, listing(kColumns),
                        printable(line_));
      where_.push_back(static_cast<std::size_t>(at - names.begin()));
    }
  }

  template <class Number>
  Number number(std::string_view cell, std::size_t column, Number least, const char* expected) const {
    Number value{};
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !(value >= least && value <= Number(1e6)))
      fail<FileError>("{}:{}: column '{}': {} expected, got '{}'", name_, line_number_, kColumns[column], expected,
                      printable(cell));
    return value;
  }

  Row read_row() const {
    const auto all = cells();
    if (all.size() != width_)
      fail<FileError>("{}:{}: {} values expected, got {}", name_, line_number_, width_, all.size());
    const auto cell = [&](std::size_t column) { return all[where_[column]]; };
    return {number<int>(cell(0), 0, 0, "a whole number from 0 on"),
            {{number(cell(1), 1, -1e6, "a position [m]"), number(cell(2), 2, -1e6, "a position [m]")},
             number(cell(3), 3, kShortest, "a radius > 0 [m]")}};
  }

  std::string_view rest_, line_;
  const std::string& name_;
  std::size_t line_number_ = 0;
  std::size_t width_ = 0;
  std::vector<std::size_t> where_;  ///< position of each of kColumns
};

/// "0 to 149", or a list where there are gaps.
std::string range_text(const std::set<int>& numbers) {
  if (numbers.empty()) return "none";
  if (static_cast<std::size_t>(*numbers.rbegin() - *numbers.begin()) + 1 == numbers.size())
    return fmt::format("{} to {}", *numbers.begin(), *numbers.rbegin());
  std::vector<std::string> texts;
  for (const int number : numbers) {
    texts.push_back(std::to_string(number));
    if (texts.size() > 13) break;
  }
  return listing(texts);
}

/// Discs that are there twice answer as one.
std::size_t drop_repeated(std::vector<Disc>& discs) {
  std::set<std::array<double, 3>> seen;
  const std::size_t before = discs.size();
  std::erase_if(discs, [&](const Disc& d) { return !seen.insert({d.center.x(), d.center.y(), d.radius}).second; });
  return before - discs.size();
}

Header header_for(const std::vector<Disc>& discs, const Vec2& goal, const std::string& path, int index) {
  Header header;
  header.title = fmt::format("{} {}", title_of(path), index);
  header.note = fmt::format("World {} of {}.", index, printable(std::filesystem::path(path).filename().string()));
  header.start = kStart;
  Box box{kStart.position().cwiseMin(goal), kStart.position().cwiseMax(goal)};
  for (const Disc& disc : discs) {
    const Vec2 reach(disc.radius, disc.radius);
    box = {box.low.cwiseMin(disc.center - reach), box.high.cwiseMax(disc.center + reach)};
  }
  header.bounds = {box.low - Vec2(kMargin, kMargin), box.high + Vec2(kMargin, kMargin)};
  return header;
}

}  // namespace

Imported barn_from_csv(const std::string& text, const std::string& path, const BarnOptions& options, const Work& work) {
  validate(options);
  std::set<int> found;
  std::vector<Disc> discs = CsvReader(text, path).read(options.index, found, work);
  if (!found.count(options.index))
    fail<FileError>("{}: no world {}; there are {}", path, options.index, range_text(found));
  const std::size_t repeated = drop_repeated(discs);
  const Vec2 goal = kStart * Vec2(kGoalAhead, 0);
  Imported result{World(header_for(discs, goal, path, options.index)), {}};
  result.world.add(Place{"goal", goal, {}, kGoalTolerance});
  for (const Disc& disc : discs) {
    work.poll();
    result.world.add(Obstacle{"", disc, {}});
  }
  result.world.forget_history();
  result.report.push_back(fmt::format("world {} of {}: {} cylinders, {} repeated ones dropped", options.index,
                                      range_text(found), discs.size(), repeated));
  result.report.push_back("start (-2.25, 3) looking along y, place 'goal' 10 m ahead");
  return result;
}

Imported import_barn(const std::string& csv_path, const BarnOptions& options, const Work& work) {
  return barn_from_csv(read_text_file(csv_path, kLargestTable), csv_path, options, work);
}

}  // namespace meander
