// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// A live picture of a 60 x 60 map with robot, way and sonar cones. Goal: < 2 ms of CPU per frame in the worst case, and
// < 2000 bytes when little moves. `bytes` go to the terminal, `ratio` is the wall time of a frame over that of encoding
// one whole frame as text. watch_* is a frame as watch() makes it: draw list, picture, difference, status line.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>

#include "base/random.hpp"
#include "render/draw_cells.hpp"
#include "render/draw_run.hpp"
#include "render/live_picture.hpp"
#include "render/screen.hpp"
#include "render/terminal.hpp"

namespace {

using namespace meander;

constexpr int kSide = 60;
constexpr double kCell = 0.1;  // [m]
constexpr TerminalSize kSize{kSide, kSide / 2};

Grid<std::uint8_t> map(int seed) {
  Grid<std::uint8_t> grid(kSide, kSide, 0, {kCell, {}});
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const bool rim = x == 0 || y == 0 || x == kSide - 1 || y == kSide - 1;
      const bool wall = (x == 20 && y < 40) || (x == 40 && y > 20);
      grid[{x, y}] = rim || wall ? 255 : static_cast<std::uint8_t>((x * 7 + y * 13 + seed * 29) % 97);
    }
  return grid;
}

/// The picture `step` control cycles into a drive. `busy`: every cell of the map changes too.
DrawList picture(int step, bool busy) {
  const Theme& colors = theme(Background::dark);
  DrawList list;
  list.view = {{0, 0}, {kSide * kCell, kSide * kCell}};
  list.background = colors.background;
  draw_grid(list, map(busy ? step : 0), colors);
  std::vector<Pose2> poses, transducers;
  for (int i = 0; i <= step + 60; ++i) {
    const double t = 0.02 * i;
    poses.push_back({3 + 1.5 * std::cos(t), 3 + 1.5 * std::sin(t), t + kPi / 2});
  }
  std::vector<double> ranges;
  for (int i = 0; i < 16; ++i) {
    const double bearing = i * kPi / 8;
    transducers.push_back(poses.back() * Pose2{0.23 * std::cos(bearing), 0.23 * std::sin(bearing), bearing});
    ranges.push_back(0.5 + 0.05 * ((i * 5) % 9));
  }
  if (busy) draw_readings(list, {transducers, ranges, 0.218, 6.477}, colors);
  draw_track(list, {poses, 0.2667, {}, {}}, colors);
  return list;
}

/// Seconds that encoding one whole frame takes: the baseline of this run.
double seconds_of_text(const Frame& frame) {
  constexpr int kRounds = 200;
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kRounds; ++i) benchmark::DoNotOptimize(text(frame));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / kRounds;
}

void live_frames(benchmark::State& state, bool busy, TerminalMode mode) {
  std::vector<DrawList> lists;
  for (int step = 0; step < 32; ++step) lists.push_back(picture(step, busy));
  Frame shown = terminal_frame(lists.back(), kSize, mode);
  const double baseline = seconds_of_text(shown);
  std::size_t bytes = 0, most = 0, next = 0, frames = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (auto _ : state) {
    Frame frame = terminal_frame(lists[next], kSize, mode);
    const std::string change = frame_difference(shown, frame);
    shown = std::move(frame);
    // Jumping back from the last picture to the first is no frame of a live view.
    if (next != 0) most = std::max(most, change.size()), bytes += change.size(), ++frames;
    next = (next + 1) % lists.size();
  }
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(std::max<std::size_t>(1, frames));
  state.counters["bytes_most"] = static_cast<double>(most);
  state.counters["ratio"] = spent / static_cast<double>(state.iterations()) / baseline;
}

BENCHMARK_CAPTURE(live_frames, little_moves, false, TerminalMode::truecolor)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(live_frames, all_changes, true, TerminalMode::truecolor)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(live_frames, little_moves_256, false, TerminalMode::color256)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(live_frames, all_changes_256, true, TerminalMode::color256)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(live_frames, all_changes_ascii, true, TerminalMode::ascii)->Unit(benchmark::kMicrosecond);

void whole_frame_as_text(benchmark::State& state) {
  const Frame frame = terminal_frame(picture(0, true), kSize, TerminalMode::truecolor);
  for (auto _ : state) benchmark::DoNotOptimize(text(frame));
  state.counters["bytes"] = static_cast<double>(text(frame).size());
}
BENCHMARK(whole_frame_as_text)->Unit(benchmark::kMicrosecond);

/// A world of 6 x 6 m with `boxes` boxes in it.
World world_of(int boxes) {
  Header header;
  header.bounds = {{0, 0}, {6, 6}};
  World world(header);
  Stream random(1, "bench");
  for (int i = 0; i < boxes; ++i) {
    const Vec2 at(random.uniform(0.2, 5.8), random.uniform(0.2, 5.8));
    world.add(Obstacle{.name = {}, .shape = Disc{at, 0.05}, .surface = {}});
  }
  return world;
}

/// Frames of a drive that has come `cycles` far, each a twentieth of a second after the one before.
void watch_frames(benchmark::State& state, int boxes, int cycles, TerminalSize terminal) {
  const RobotLook look{0.2667, {}, 0.218, 6.477};
  LivePicture picture(world_of(boxes), {look});
  picture.set_goals(0, {{{5, 5}, 0.25, false}, {{1, 5}, 0.25, true}});
  const auto pose = [](int cycle) {
    const double t = 0.02 * cycle;
    return Pose2{3 + 2 * std::cos(t), 3 + 1.5 * std::sin(3 * t), t};
  };
  for (int i = 0; i < cycles; ++i) picture.pass(0, pose(i), false);
  std::vector<double> ranges;
  for (int i = 0; i < 16; ++i) ranges.push_back(0.5 + 0.1 * ((i * 5) % 9));
  std::size_t bytes = 0, most = 0, frames = 0;
  Screen screen([&](std::string_view text) { bytes += text.size(), most = std::max(most, text.size()); });
  const auto frame = [&](int i) {
    // At a speed of 1 a cycle of 0.33 s is six or seven frames: the robot glides, the scan stays.
    const Pose2 before = pose(cycles + i / 6), after = pose(cycles + i / 6 + 1);
    const Moment from{0, {before}, {before}, {ranges}, {}}, to{0.33, {after}, {after}, {ranges}, {}};
    const Moment moment = between(from, to, (i % 6) / 6.0);
    screen.show(terminal_frame(picture.at(moment), Screen::room(terminal), TerminalMode::truecolor),
                fmt::format("{:.1f} s  1x  1/2 subgoals  0.45 m/s  clearance 0.31 m", 0.05 * i), terminal);
  };
  frame(0);
  bytes = most = 0;
  for (auto _ : state) frame(static_cast<int>(++frames));
  state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(frames);
  state.counters["bytes_most"] = static_cast<double>(most);
}
BENCHMARK_CAPTURE(watch_frames, watch_60x60, 40, 300, TerminalSize{60, 31})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(watch_frames, watch_60x60_ten_minutes, 40, 1800, TerminalSize{60, 31})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(watch_frames, watch_60x60_three_hours, 40, 30000, TerminalSize{60, 31})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(watch_frames, watch_60x60_1000_boxes, 1000, 300, TerminalSize{60, 31})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(watch_frames, watch_200x60, 40, 300, TerminalSize{200, 60})->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
