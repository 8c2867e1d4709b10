// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/map_text.hpp"

#include <concepts>
#include <iterator>
#include <limits>
#include <utility>

#include "base/hash.hpp"
#include "base/text_lines.hpp"

namespace meander::topology {
namespace {

constexpr const char* kTitle = "meander topologic map";
constexpr int kFormat = 2;
constexpr int kMostCells = 10'000'000;
constexpr std::size_t kMostSenses = 100'000'000;  ///< of all cells: 400 MB
constexpr std::int64_t kMostSamples = std::int64_t{1} << 53;

using Out = std::back_insert_iterator<std::string>;

template <Listed Options>
void write_options(Out& out, const Options& options, const std::string& where) {
  fields(options, [&](const Field& field, const auto& value) {
    if constexpr (Listed<std::remove_cvref_t<decltype(value)>>)
      write_options(out, value, where + field.name + ".");
    else
      fmt::format_to(out, "option {}{} {}\n", where, field.name, value);
  });
}

/// Sets the option of that name, if there is one.
template <Listed Options>
bool read_option(const TextLines& lines, Options& options, std::string_view name) {
  bool found = false;
  fields(options, [&](const Field& field, auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    const std::string_view own = field.name;
    if constexpr (Listed<T>) {
      if (name.size() > own.size() && name.starts_with(own) && name[own.size()] == '.')
        found = read_option(lines, value, name.substr(own.size() + 1)) || found;
    } else if (name == own) {
      if constexpr (std::integral<T>)
        value = lines.integer<T>(2, 0, std::numeric_limits<T>::max());
      else
        value = lines.number(2);
      found = true;
    }
  });
  return found;
}

std::string checksum(std::string_view text) { return Hash().add(text).hex(); }

}  // namespace

/// The parts of a map that are not open to others.
struct PoolState {
  static void write(Out& out, const CellPool& pool) {
    fmt::format_to(out, "cells {} {}\n", pool.slots(), pool.serials_);
    for (int id = 0; id < pool.slots(); ++id) {
      const Cell& cell = pool[id];
      if (!cell.alive()) continue;
      fmt::format_to(out, "cell {} {} {} {} {} {}", id, cell.position.x(), cell.position.y(), cell.serial, cell.born,
                     cell.hits);
      for (std::size_t k = 0; k < pool.stride(); ++k)
        fmt::format_to(out, " {}", static_cast<double>(pool.senses(id)[k]));
      fmt::format_to(out, "\n");
    }
    for (int id = 0; id < pool.slots(); ++id)
      for (const Link& link : pool[id].links)
        fmt::format_to(out, "link {} {} {} {} {}\n", id, link.to, link.weight, link.doubt, link.suspended ? 1 : 0);
    fmt::format_to(out, "free");
    for (const int id : pool.free_) fmt::format_to(out, " {}", id);
    fmt::format_to(out, "\n");
  }

  static int alive(const TextLines& lines, const CellPool& pool, std::size_t word) {
    const int id = lines.integer(word, 0, pool.slots() - 1);
    if (!pool.alive(id)) lines.wrong("cell {} is not in the map", id);
    return id;
  }

  static void read_cell(const TextLines& lines, CellPool& pool) {
    lines.count(7 + pool.stride(), "cell NUMBER X Y SERIAL BORN HITS SENSES...");
    const int id = lines.integer(1, 0, pool.slots() - 1);
    Cell& cell = pool[id];
    if (cell.alive()) lines.wrong("cell {} comes twice", id);
    cell.position = {lines.number(2), lines.number(3)};
    cell.serial = lines.integer<std::uint64_t>(4, 1, pool.serials_);
    cell.born = lines.integer<std::int64_t>(5, 0, kMostSamples);
    cell.hits = lines.integer<std::int64_t>(6, 0, kMostSamples);
    for (std::size_t k = 0; k < pool.stride(); ++k) pool.senses(id)[k] = static_cast<float>(lines.number(7 + k));
  }

  static void read_link(const TextLines& lines, CellPool& pool) {
    lines.count(6, "link FROM TO WEIGHT DOUBT SUSPENDED");
    const int from = alive(lines, pool, 1), to = alive(lines, pool, 2);
    if (from == to || pool.find(from, to)) lines.wrong("a link from {} to another cell, once, expected", from);
    const Link link{to, lines.number(3), lines.number(4), lines.integer(5, 0, 1) == 1};
    if (!(link.weight > 0 && link.weight <= 1) || link.doubt < 0)
      lines.wrong("a weight in (0, 1] and a doubt >= 0 expected");
    pool[from].links.push_back(link);
  }

  static void read(TextLines& lines, CellPool& pool) {
    lines.count(3, "cells COUNT SERIALS");
    const int slots = lines.integer(1, 0, kMostCells);
    pool.serials_ = lines.integer<std::uint64_t>(2, 0, std::uint64_t{1} << 62);
    if (static_cast<std::size_t>(slots) * pool.stride_ > kMostSenses) lines.wrong("{} cells are too many", slots);
    pool.cells_.resize(static_cast<std::size_t>(slots));
    pool.senses_.resize(static_cast<std::size_t>(slots) * pool.stride_);
    while (lines.next() && lines.is("cell")) read_cell(lines, pool);
    for (; lines.is("link"); lines.next()) read_link(lines, pool);
    for (int id = 0; id < slots; ++id)
      for (const Link& link : pool[id].links) {
        const Link* half = pool.find(link.to, id);
        if (!half || half->weight != link.weight || half->doubt != link.doubt || half->suspended != link.suspended)
          lines.wrong("the link from {} to {} has no equal other half", id, link.to);
      }
    if (!lines.is("free")) lines.wrong("'free NUMBERS...' expected");
    for (std::size_t word = 1; word < lines.words().size(); ++word)
      pool.free_.push_back(lines.integer(word, 0, slots - 1));
    if (!all_free_once(pool)) lines.wrong("the numbers that no cell has, once each, expected");
  }

  static bool all_free_once(const CellPool& pool) {
    std::vector<char> seen(static_cast<std::size_t>(pool.slots()));
    for (const int id : pool.free_)
      if (pool[id].alive() || std::exchange(seen[static_cast<std::size_t>(id)], 1)) return false;
    std::size_t dead = 0;
    for (int id = 0; id < pool.slots(); ++id) dead += !pool[id].alive();
    return dead == pool.free_.size();
  }
};

struct NetState {
  static void write(Out& out, const GrowingNet& net) {
    fmt::format_to(out, "net {} {} {} {}\n", net.winner_, net.rate_, net.neighbour_rate_, net.misses_);
    PoolState::write(out, net.cells_);
    fmt::format_to(out, "errors");
    for (int id = 0; id < net.cells_.slots(); ++id)
      if (net.cells_[id].alive()) fmt::format_to(out, " {}", net.errors_.error(id));
    fmt::format_to(out, "\n");
  }

  static void read(TextLines& lines, GrowingNet& net) {
    lines.count(5, "net WINNER RATE NEIGHBOUR_RATE MISSES");
    net.winner_ = lines.integer(1, -1, kMostCells);
    net.rate_ = lines.number(2);
    net.neighbour_rate_ = lines.number(3);
    net.misses_ = lines.integer<std::int64_t>(4, 0, kMostSamples);
    const int winner = net.winner_;
    if (!lines.next() || !lines.is("cells")) lines.wrong("'cells COUNT SERIALS' expected");
    PoolState::read(lines, net.cells_);
    if (winner >= 0 && !net.cells_.alive(winner)) lines.wrong("the winner {} is not in the map", winner);
    lines.next();
    lines.count(1 + static_cast<std::size_t>(net.cells_.size()), "errors NUMBER...");
    std::size_t word = 1;
    for (int id = 0; id < net.cells_.slots(); ++id) {
      if (!net.cells_[id].alive()) continue;
      net.errors_.set(id, lines.number(word++));
      if (net.per_position_ > 0) net.index_.add(id, net.cells_[id].position);
    }
  }
};

struct MapState {
  static void write(Out& out, const TopologicMap& map) {
    const auto pose = [&](const char* name, const Pose2& p) {
      fmt::format_to(out, "{} {} {} {}\n", name, p.x, p.y, p.heading);
    };
    const SenseSuite& suite = map.suite_;
    fmt::format_to(out, "suite {} {} {} {}\n", suite.whiskers, suite.lights, suite.whisker_radius, suite.whisker_reach);
    fmt::format_to(out, "samples {} {} {}\n", map.samples_, map.learnt_from_, map.learning_ ? 1 : 0);
    pose("odometry", map.odometry_);
    pose("pose", map.pose_);
    if (map.begins_) fmt::format_to(out, "begins\n");
    NetState::write(out, map.net_);
    write_last(out, map);
    for (std::int64_t s = first_waiting(map); s < map.samples_; ++s) {
      const auto& waiting = const_cast<TopologicMap&>(map).waiting(s);
      fmt::format_to(out, "waiting {} {}", waiting.position.x(), waiting.position.y());
      for (const float value : waiting.senses) fmt::format_to(out, " {}", static_cast<double>(value));
      fmt::format_to(out, "\n");
    }
  }

  /// What is sensed now, and what the net and the correlation said of it last: scripts ask for it between samples.
  static void write_last(Out& out, const TopologicMap& map) {
    fmt::format_to(out, "now");
    for (const float value : map.now_) fmt::format_to(out, " {}", static_cast<double>(value));
    const Recognition& r = map.recognition_;
    const Correction& c = map.correction_;
    fmt::format_to(out, "\nsaid {} {} {} {} {} {} {} {}\n", r.sample, r.cell, r.distance, c.shift.x(), c.shift.y(),
                   c.turn, c.cell, c.distance);
  }

  static void read_last(TextLines& lines, TopologicMap& map) {
    if (!lines.next() || !lines.is("now")) lines.wrong("'now SENSES...' expected");
    lines.count(1 + map.now_.size(), "now SENSES...");
    for (std::size_t k = 0; k < map.now_.size(); ++k) map.now_[k] = static_cast<float>(lines.number(1 + k));
    if (!lines.next() || !lines.is("said")) lines.wrong("'said ...' expected");
    lines.count(9, "said SAMPLE CELL DISTANCE SHIFT_X SHIFT_Y TURN CELL DISTANCE");
    const int last = map.net_.cells().slots() - 1;
    map.recognition_ = {lines.integer<std::int64_t>(1, -1, kMostSamples), lines.integer(2, -1, last), lines.number(3)};
    map.correction_ = {
        {lines.number(4), lines.number(5)}, lines.number(6), lines.integer(7, -1, last), lines.number(8)};
    const int told = map.correction_.cell;
    if (told >= 0 && !map.net_.cells().alive(told)) lines.wrong("cell {} is not in the map", told);
  }

  static std::int64_t first_waiting(const TopologicMap& map) {
    if (!map.learning_) return map.samples_;
    return std::max(map.learnt_from_, map.samples_ - map.options_.delay);
  }

  static void read(TextLines& lines, TopologicMap& map) {
    lines.next();
    lines.count(4, "samples COUNT LEARNT_FROM LEARNING");
    map.samples_ = lines.integer<std::int64_t>(1, 0, kMostSamples);
    map.learnt_from_ = lines.integer<std::int64_t>(2, 0, map.samples_);
    map.learning_ = lines.integer(3, 0, 1) == 1;
    map.odometry_ = pose(lines, "odometry");
    map.pose_ = pose(lines, "pose");
    lines.next();
    map.begins_ = lines.is("begins");
    if (map.begins_) lines.next();
    if (!lines.is("net")) lines.wrong("'net WINNER RATE NEIGHBOUR_RATE MISSES' expected");
    NetState::read(lines, map.net_);
    read_last(lines, map);
    for (std::int64_t s = first_waiting(map); s < map.samples_; ++s) {
      auto& waiting = map.waiting(s);
      if (!lines.next() || !lines.is("waiting")) lines.wrong("{} more situations that wait expected", map.samples_ - s);
      lines.count(3 + waiting.senses.size(), "waiting X Y SENSES...");
      waiting.position = {lines.number(1), lines.number(2)};
      for (std::size_t k = 0; k < waiting.senses.size(); ++k)
        waiting.senses[k] = static_cast<float>(lines.number(3 + k));
    }
    if (lines.next()) lines.wrong("the end expected, got '{}'", lines.shown(0));
  }

  static Pose2 pose(TextLines& lines, const char* name) {
    if (!lines.next() || !lines.is(name)) lines.wrong("'{} X Y HEADING' expected", name);
    lines.count(4, name);
    return {lines.number(1), lines.number(2), lines.number(3)};
  }
};

std::string map_text(const TopologicMap& map) {
  std::string text = fmt::format("{} {}\n", kTitle, kFormat);
  Out out(text);
  write_options(out, map.options(), "");
  MapState::write(out, map);
  fmt::format_to(out, "checksum {}\n", checksum(text));
  return text;
}

TopologicMap read_map_text(std::string_view text, const std::string& path) {
  const std::size_t end = text.rfind("checksum ");
  TextLines lines(text.substr(0, end == std::string_view::npos ? text.size() : end), path);
  const std::string title = fmt::format("{} {}", kTitle, kFormat);
  if (!text.starts_with(title + "\n")) fail<FileError>("{}: '{}' expected in the first line", path, title);
  if (end == std::string_view::npos || text.substr(end) != fmt::format("checksum {}\n", checksum(text.substr(0, end))))
    fail<FileError>("{}: not whole, or changed by hand: the checksum at its end does not fit", path);
  lines.next();
  TopologicMapOptions options;
  while (lines.next() && lines.is("option")) {
    lines.count(3, "option NAME NUMBER");
    if (!read_option(lines, options, lines.words()[1])) lines.wrong("unknown option '{}'", lines.shown(1));
  }
  try {
    validate(options);
  } catch (const ArgumentError& e) {
    fail<FileError>("{}: {}", path, e.what());
  }
  if (!lines.is("suite")) lines.wrong("'suite WHISKERS LIGHTS RADIUS REACH' expected");
  lines.count(5, "suite WHISKERS LIGHTS RADIUS REACH");
  const SenseSuite suite{lines.integer(1, 1, 1024), lines.integer(2, 0, 1024), lines.number(3), lines.number(4)};
  TopologicMap map(options, suite);
  MapState::read(lines, map);
  return map;
}

}  // namespace meander::topology
