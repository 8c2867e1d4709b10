// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/quantised_map.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <span>

#include "base/error.hpp"

namespace meander::topology {
namespace {

constexpr int kNone = 255;

std::uint8_t byte_of(double share) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

/// The rows of a net of senses as bytes; numbers[cell] becomes the row's number.
std::vector<std::uint8_t> rows_of(const GrowingNet& net, int ring, double& most, std::vector<int>& numbers,
                                  const char* what) {
  const CellPool& cells = net.cells();
  if (cells.size() >= kNone) fail("a quantised map has room for {} {}, got {}", kNone - 1, what, cells.size());
  numbers.assign(static_cast<std::size_t>(cells.slots()), kNone);
  most = 0;
  for (int cell = 0; cell < cells.slots(); ++cell)
    for (int k = 0; k < ring && cells[cell].alive(); ++k)
      most = std::max(most, static_cast<double>(cells.senses(cell)[k]));
  std::vector<std::uint8_t> rows;
  int number = 0;
  for (int cell = 0; cell < cells.slots(); ++cell) {
    if (!cells[cell].alive()) continue;
    numbers[static_cast<std::size_t>(cell)] = number++;
    for (int k = 0; k < ring; ++k)
      rows.push_back(byte_of(most > 0 ? static_cast<double>(cells.senses(cell)[k]) / most : 0));
  }
  return rows;
}

double ring_squared(const std::uint8_t* row, double most, std::span<const float> ring, double scale) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double gap = row[k] / 255.0 * most - static_cast<double>(ring[k]);
    sum += gap * gap;
  }
  return ring.empty() ? 0 : sum / (static_cast<double>(ring.size()) * scale * scale);
}

double ring_squared(const float* row, std::span<const float> ring, double scale) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double gap = static_cast<double>(row[k]) - static_cast<double>(ring[k]);
    sum += gap * gap;
  }
  return ring.empty() ? 0 : sum / (static_cast<double>(ring.size()) * scale * scale);
}

/// What a place without a link to senses is charged: as different as can be told apart.
constexpr double kUnknown = 1;

std::string array_text(const char* type, const std::string& name, const auto& values) {
  std::string text = fmt::format("static const {} {}[{}] = {{", type, name, std::max<std::size_t>(values.size(), 1));
  for (std::size_t i = 0; i < values.size(); ++i) text += fmt::format("{}{},", i % 24 == 0 ? "\n  " : "", values[i]);
  return text + (values.empty() ? "0};\n" : "\n};\n");
}

}  // namespace

QuantisedMap quantised(const MinimalMap& map) {
  QuantisedMap small;
  small.touch = map.touch().metric().touch();
  small.light = map.light().metric().light();
  std::vector<int> light_number, touch_number, place_number;
  small.lights = rows_of(map.light(), small.light, small.light_most, light_number, "lights");
  small.touches = rows_of(map.touch(), small.touch, small.touch_most, touch_number, "touches");
  const CellPool& places = map.geometry().cells();
  if (places.size() > 65536) fail("a quantised map has room for 65536 places, got {}", places.size());
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (int cell = 0; cell < places.slots(); ++cell) {
    if (!places[cell].alive()) continue;
    low = low.cwiseMin(places[cell].position);
    high = high.cwiseMax(places[cell].position);
  }
  if (places.size() == 0) return small;
  small.low = low;
  small.step = std::max((high - low).maxCoeff(), 1e-9) / 255;
  place_number.assign(static_cast<std::size_t>(places.slots()), 0);
  const auto number = [](const std::vector<int>& numbers, const SenseLink& link) {
    return static_cast<std::uint8_t>(link.cell < 0 ? kNone : numbers[static_cast<std::size_t>(link.cell)]);
  };
  for (int cell = 0; cell < places.slots(); ++cell) {
    if (!places[cell].alive()) continue;
    place_number[static_cast<std::size_t>(cell)] = static_cast<int>(small.place_count());
    const Vec2 at = (places[cell].position - low) / (255 * small.step);
    small.places.insert(small.places.end(), {byte_of(at.x()), byte_of(at.y()), number(light_number, map.light_of(cell)),
                                             number(touch_number, map.touch_of(cell))});
  }
  for (int cell = 0; cell < places.slots(); ++cell)
    for (const Link& link : places[cell].links) {
      if (link.to < cell) continue;  // each once
      small.links.push_back(static_cast<std::uint16_t>(place_number[static_cast<std::size_t>(cell)]));
      small.links.push_back(static_cast<std::uint16_t>(place_number[static_cast<std::size_t>(link.to)]));
      small.weights.push_back(byte_of(link.weight));
    }
  return small;
}

std::string c_source(const QuantisedMap& map, const std::string& name) {
  const bool letters =
      std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (name.empty() || !letters || std::isdigit(static_cast<unsigned char>(name[0])))
    fail("a C identifier expected as name, got '{}'", name);
  std::string text = fmt::format(
      "/* A minimal topologic map: {} places, {} links, {} lights, {} touches; {} bytes.\n"
      "   place i: x = {} + {} * places[4 i], y = {} + {} * places[4 i + 1] [m], its light and its touch (255: none).\n"
      "   A light value is byte * {} / 255, a touch value byte * {} / 255. Rings: {} lights, {} whiskers.\n"
      "   Link j joins places links[2 j] and links[2 j + 1] with confidence weights[j] / 255. */\n",
      map.place_count(), map.weights.size(),
      map.light > 0 ? map.lights.size() / static_cast<std::size_t>(map.light) : 0,
      map.touch > 0 ? map.touches.size() / static_cast<std::size_t>(map.touch) : 0, map.bytes(), map.low.x(), map.step,
      map.low.y(), map.step, map.light_most, map.touch_most, map.light, map.touch);
  text += fmt::format("#ifndef {0}_included\n#define {0}_included\n#include <stdint.h>\n", name);
  const auto constant = [&](const char* what, auto value) {
    text += fmt::format("#define {}_{} {}\n", name, what, value);
  };
  constant("place_count", map.place_count());
  constant("link_count", map.weights.size());
  constant("whiskers", map.touch);
  constant("light_sensors", map.light);
  constant("low_x", map.low.x());
  constant("low_y", map.low.y());
  constant("step", map.step);
  constant("light_most", map.light_most);
  constant("touch_most", map.touch_most);
  return text + array_text("uint8_t", name + "_places", map.places) +
         array_text("uint16_t", name + "_links", map.links) + array_text("uint8_t", name + "_weights", map.weights) +
         array_text("uint8_t", name + "_lights", map.lights) + array_text("uint8_t", name + "_touches", map.touches) +
         "#endif\n";
}

int recognise(const MinimalMap& map, const Situation& situation, const Scales& scales) {
  const auto touch = static_cast<std::size_t>(map.touch().metric().touch()),
             light = static_cast<std::size_t>(map.light().metric().light());
  const std::span<const float> touches(situation.senses, touch), lights(situation.senses + touch, light);
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int place = 0; place < map.geometry().cells().slots(); ++place) {
    const Cell& cell = map.geometry().cells()[place];
    if (!cell.alive()) continue;
    const SenseLink l = map.light_of(place), t = map.touch_of(place);
    const double d = (cell.position - situation.position).squaredNorm() / (scales.position * scales.position) +
                     (l.cell < 0 ? kUnknown : ring_squared(map.light().cells().senses(l.cell), lights, scales.light)) +
                     (t.cell < 0 ? kUnknown : ring_squared(map.touch().cells().senses(t.cell), touches, scales.touch));
    if (d >= least) continue;
    least = d;
    best = place;
  }
  return best;
}

Vec2 position_of(const QuantisedMap& map, int place) {
  const std::uint8_t* bytes = map.places.data() + 4 * place;
  return map.low + map.step * Vec2(bytes[0], bytes[1]);
}

int recognise(const QuantisedMap& map, const Situation& situation, const Scales& scales) {
  const auto touch = static_cast<std::size_t>(map.touch), light = static_cast<std::size_t>(map.light);
  const std::span<const float> touches(situation.senses, touch), lights(situation.senses + touch, light);
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int place = 0; place < static_cast<int>(map.place_count()); ++place) {
    const std::uint8_t l = map.places[static_cast<std::size_t>(4 * place + 2)],
                       t = map.places[static_cast<std::size_t>(4 * place + 3)];
    const double d =
        (position_of(map, place) - situation.position).squaredNorm() / (scales.position * scales.position) +
        (l == kNone ? kUnknown : ring_squared(map.lights.data() + l * light, map.light_most, lights, scales.light)) +
        (t == kNone ? kUnknown : ring_squared(map.touches.data() + t * touch, map.touch_most, touches, scales.touch));
    if (d >= least) continue;
    least = d;
    best = place;
  }
  return best;
}

}  // namespace meander::topology
