// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/attributes.hpp"

#include <fmt/format.h>

namespace meander {
namespace {

void list(Attributes& to, const Chain& chain) {
  to.push_back({"points", chain.points});
  to.push_back({"closed", chain.closed, !chain.closed});
}
void list(Attributes& to, const Polygon& polygon) {
  to.push_back({"outer", polygon.outer});
  to.push_back({"holes", polygon.holes, polygon.holes.empty()});
}
void list(Attributes& to, const Rectangle& rectangle) {
  to.push_back({"center", rectangle.center});
  to.push_back({"size", rectangle.size});
  to.push_back({"heading", rectangle.heading, rectangle.heading == 0});
}
void list(Attributes& to, const Disc& disc) {
  to.push_back({"center", disc.center});
  to.push_back({"radius", disc.radius});
}
void list(Attributes& to, const Shape& shape) {
  std::visit([&](const auto& s) { list(to, s); }, shape);
}
void list(Attributes& to, const Surface& surface) {
  to.push_back({"echo", surface.echo, surface.echo == 1});
  if (surface.specular_limit) to.push_back({"specular_limit", *surface.specular_limit});
}

void list(Attributes& to, const Obstacle& obstacle) {
  list(to, obstacle.shape);
  list(to, obstacle.surface);
}
void list(Attributes& to, const Door& door) {
  const auto* chain = std::get_if<Chain>(&door.shape);
  if (chain && chain->points.size() == 2 && !chain->closed) {
    to.push_back({"from", chain->points[0]});
    to.push_back({"to", chain->points[1]});
  } else {
    list(to, door.shape);
  }
  to.push_back({"open", door.open});
  list(to, door.surface);
}
void list(Attributes& to, const Mover& mover) {
  list(to, mover.disc);
  to.push_back({"motion", std::string(to_string(mover.motion))});
  to.push_back({"waypoints", mover.waypoints, mover.waypoints.empty()});
  to.push_back({"speed", mover.speed});
  to.push_back({"yields", mover.yields});
}
void list(Attributes& to, const Light& light) {
  to.push_back({"position", light.position});
  to.push_back({"strength", light.strength});
}
void list(Attributes& to, const Place& place) {
  to.push_back({"position", place.position});
  if (place.heading) to.push_back({"heading", *place.heading});
  to.push_back({"tolerance", place.tolerance});
}

void add(Hash& hash, bool value) { hash.add(std::uint64_t{value}); }
void add(Hash& hash, double value) { hash.add(value); }
void add(Hash& hash, const std::string& value) { hash.add(std::string_view(value)); }
void add(Hash& hash, const Vec2& p) { hash.add(p.x()).add(p.y()); }
void add(Hash& hash, const Pose2& pose) { hash.add(pose.x).add(pose.y).add(pose.heading); }
template <class T>
void add(Hash& hash, const std::vector<T>& values) {
  hash.add(std::uint64_t{values.size()});
  for (const T& value : values) add(hash, value);
}

std::string escaped(const std::string& text, const char* control_format) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += {'\\', c};
    else if (c == '\n')
      result += "\\n";
    else if (c == '\t')
      result += "\\t";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format(fmt::runtime(control_format), static_cast<int>(c));
    else
      result += c;
  }
  return result + '"';
}

std::string text(bool value, const Dialect&) { return value ? "true" : "false"; }
std::string text(double value, const Dialect&) { return fmt::format("{}", value); }
std::string text(const std::string& value, const Dialect& dialect) { return dialect.quoted(value); }
std::string text(const Vec2& p, const Dialect& d) { return fmt::format("{}{}, {}{}", d.open, p.x(), p.y(), d.close); }
std::string text(const Pose2& p, const Dialect& d) {
  return fmt::format("{}{}, {}, {}{}", d.open, p.x, p.y, p.heading, d.close);
}
std::string text(const Points& points, const Dialect& dialect) {
  constexpr std::size_t kPerLine = 6;
  const bool broken = points.size() > kPerLine;
  std::string result(1, dialect.open);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (broken && i % kPerLine == 0) result += "\n  ";
    result += text(points[i], dialect);
    if (i + 1 < points.size()) result += (broken && (i + 1) % kPerLine == 0) ? "," : ", ";
  }
  return result + (broken ? "\n" : "") + dialect.close;
}
std::string text(const std::vector<Points>& lists, const Dialect& dialect) {
  std::string result(1, dialect.open);
  for (std::size_t i = 0; i < lists.size(); ++i) result += (i ? ", " : "") + text(lists[i], dialect);
  return result + dialect.close;
}

}  // namespace

const Dialect kToml{'[', ']', [](const std::string& t) { return escaped(t, "\\u{:04x}"); }};
const Dialect kLua{'{', '}', [](const std::string& t) { return escaped(t, "\\{:03}"); }};

Attributes attributes(const Item& item) {
  Attributes result{{"name", name_of(item)}};
  std::visit([&](const auto& thing) { list(result, thing); }, item);
  return result;
}

Attributes attributes(const Header& header) {
  Attributes result{{"title", header.title},
                    {"note", header.note, header.note.empty()},
                    {"bounds", Points{header.bounds.low, header.bounds.high}}};
  if (header.start) result.push_back({"start", *header.start});
  return result;
}

void add_to(Hash& hash, const Attributes& attributes) {
  hash.add(std::uint64_t{attributes.size()});
  for (const Attribute& attribute : attributes) {
    hash.add(std::string_view(attribute.key));
    std::visit([&](const auto& value) { add(hash, value); }, attribute.value);
  }
}

std::string value_text(const Attribute::Value& value, const Dialect& dialect) {
  return std::visit([&](const auto& v) { return text(v, dialect); }, value);
}

}  // namespace meander
