// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <locale>
#include <set>
#include <sstream>

#include "base/error.hpp"
#include "base/random.hpp"
#include "render/merge_cells.hpp"

namespace meander {
namespace {

/// What is wrong with the attributes of a tag, or nothing: ' name="value"' each, no name twice.
std::string attribute_fault(std::string_view text) {
  std::set<std::string_view> names;
  while (!text.empty()) {
    const std::size_t equals = text.find("=\""), end = text.find('"', equals + 2);
    if (text[0] != ' ' || equals == text.npos || end == text.npos) return "bad attribute: " + std::string(text);
    if (!names.insert(text.substr(1, equals - 1)).second) return "twice: " + std::string(text);
    if (text.substr(0, end).find('<') != text.npos) return "bad value: " + std::string(text);
    text.remove_prefix(end + 1);
  }
  return {};
}

std::string text_fault(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '>' || (static_cast<unsigned char>(text[i]) < 0x20 && text[i] != '\n')) return "bad character";
    const std::string_view rest = text.substr(i);
    const bool known =
        rest.starts_with("&amp;") || rest.starts_with("&lt;") || rest.starts_with("&gt;") || rest.starts_with("&quot;");
    if (text[i] == '&' && !known) return "bad reference: " + std::string(rest);
  }
  return {};
}

/// What is wrong with the XML, or nothing: elements nest, attributes are quoted and unique, references are known.
std::string xml_fault(std::string_view xml) {
  std::vector<std::string> open;
  while (!xml.empty()) {
    const std::size_t tag = std::min(xml.find('<'), xml.size());
    if (const std::string fault = text_fault(xml.substr(0, tag)); !fault.empty()) return fault;
    xml.remove_prefix(tag);
    if (xml.empty()) break;
    const std::size_t end = xml.find('>');
    if (end == xml.npos) return "tag without end";
    std::string_view inside = xml.substr(1, end - 1);
    xml.remove_prefix(end + 1);
    if (inside.starts_with('/')) {
      if (open.empty() || open.back() != inside.substr(1)) return "unbalanced: " + std::string(inside);
      open.pop_back();
      continue;
    }
    const bool closes_itself = inside.ends_with('/');
    if (closes_itself) inside.remove_suffix(1);
    const std::size_t name = std::min(inside.find(' '), inside.size());
    if (const std::string fault = attribute_fault(inside.substr(name)); !fault.empty()) return fault;
    if (!closes_itself) open.emplace_back(inside.substr(0, name));
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

/// The most digits that follow each other.
int longest_number(const std::string& text) {
  int most = 0, run = 0;
  for (const char c : text) most = std::max(most, run = c >= '0' && c <= '9' ? run + 1 : 0);
  return most;
}

DrawList random_list(Stream& random) {
  const auto point = [&] { return Vec2(random.uniform(-20, 20), random.uniform(-20, 20)); };
  const auto color = [&] {
    return Color{static_cast<std::uint8_t>(random.below(256)), 0, 9, static_cast<std::uint8_t>(random.below(256))};
  };
  DrawList list;
  list.view = {{-10, -10}, {10, 5}};
  for (int i = random.below(20); i > 0; --i) {
    const double size = random.uniform(-1, 8);
    switch (random.below(6)) {
      case 0:
        list.items.emplace_back(DrawPolyline{{point(), point(), point()}, random.chance(0.5), size, color()});
        break;
      case 1:
        list.items.emplace_back(DrawArea{{{point(), point(), point(), point()}, {}}, color()});
        break;
      case 2:
        list.items.emplace_back(DrawDisc{{point(), size * 10}, color(), Mark::wall, random.chance(0.5) ? 0 : 0.2});
        break;
      case 3:
        list.items.emplace_back(DrawText{point(), "a<b>&\"\x01\xff", size, color(), color(), Align::center});
        break;
      case 4:
        list.items.emplace_back(DrawBody{{point(), size}, random.uniform(-9, 9), color(), color()});
        break;
      default:
        list.items.emplace_back(DrawCells{{1, 2, random.uniform(-3, 3)}, 0.5, 2, 1, {color(), color()}, {}});
    }
  }
  return list;
}

TEST(Svg, AnyListIsWellFormedAndRepeatable) {
  Stream random(1, "svg");
  for (int round = 0; round < 200; ++round) {
    const DrawList list = random_list(random);
    const std::string text = svg(list);
    ASSERT_EQ(xml_fault(text), "") << text;
    ASSERT_EQ(text, svg(list));
    ASSERT_EQ(text.find("nan"), std::string::npos);
    ASSERT_EQ(text.find("inf"), std::string::npos);
  }
}

TEST(Svg, ASmallPictureIsThis) {
  DrawList list;
  list.view = {{0, 0}, {10, 5}};
  list.items.emplace_back(DrawPolyline{{{1, 1}, {2, 1}, {2, 3.5}}, false, 0.1, {1, 2, 3}, Mark::path});
  list.items.emplace_back(DrawDisc{{{5, 2.5}, 1}, {255, 0, 0, 128}, Mark::wall});
  list.items.emplace_back(DrawText{{1, 4}, "A & B", 0.36, {0, 0, 0}});
  EXPECT_EQ(svg(list),
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000\" height=\"500\" viewBox=\"0 0 1000 500\" "
            "stroke-linecap=\"round\" stroke-linejoin=\"round\" fill-rule=\"evenodd\" "
            "font-family=\"system-ui,sans-serif\">\n"
            "<rect width=\"1000\" height=\"500\" fill=\"#ffffff\"/>\n"
            "<circle cx=\"500\" cy=\"250\" r=\"100\" fill=\"#ff0000\" fill-opacity=\".5\"/>\n"
            "<path d=\"M100 400l100 0 0-250\" fill=\"none\" stroke=\"#010203\" stroke-width=\"10\"/>\n"
            "<text x=\"100\" y=\"100\" font-size=\"50\" fill=\"#000000\">A &amp; B</text>\n"
            "</svg>\n");
}

TEST(Svg, StepsAddUpWithoutDrift) {
  DrawList list;
  list.view = {{0, 0}, {1, 1}};
  DrawPolyline line{{}, false, 0, {}, Mark::path};
  for (int i = 0; i <= 3000; ++i) line.points.emplace_back(i / 3000.0, 0.5);
  list.items.emplace_back(line);
  const std::string text = svg(list);
  const std::size_t from = text.find("M0 500l");
  ASSERT_NE(from, std::string::npos);
  std::istringstream steps(text.substr(from + 7, text.find('"', from) - from - 7));
  double x = 0, dx = 0, dy = 0;
  while (steps >> dx >> dy) x += dx;
  EXPECT_NEAR(x, 1000, 1e-6);
}

struct CommaLocale : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Svg, TheLocaleHasNoSay) {
  Stream random(5, "locale");
  const DrawList list = random_list(random);
  const std::string plain = svg(list);
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaLocale));
  const std::string german = svg(list);
  std::locale::global(before);
  EXPECT_EQ(plain, german);
}

TEST(Svg, UnusableItemsAreLeftOutAndUnusableViewsRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  DrawList list;
  const std::string empty = svg(list);
  list.items.emplace_back(DrawPolyline{{{0, 0}, {kNan, 1}}, false, 0, {}});
  list.items.emplace_back(DrawPolyline{{{0, 0}}, false, 0, {}});
  list.items.emplace_back(DrawArea{{{{0, 0}, {1, 0}, {1e300, 1}}, {}}, {}});
  list.items.emplace_back(DrawDisc{{{0, 0}, kNan}, {}});
  list.items.emplace_back(DrawText{{0, 0}, "", 1, {}});
  list.items.emplace_back(DrawCells{{}, 1, 3, 3, {Color{}}, {}});
  list.items.emplace_back(DrawBody{{{0, 0}, 1}, kNan, {}, {}});
  EXPECT_EQ(svg(list), empty);
  list.view.high.x() = kNan;
  EXPECT_THROW(svg(list), ArgumentError);
  list.view = {{1, 1}, {0, 0}};
  EXPECT_THROW(svg(list), ArgumentError);
  list.view = {{-1e300, 0}, {1e300, 1}};
  EXPECT_THROW(svg(list), ArgumentError);
}

TEST(Svg, AViewWithoutAreaStillGivesAPicture) {
  DrawList list;
  list.view = {{3, 3}, {3, 3}};
  EXPECT_EQ(xml_fault(svg(list)), "");
  list.view = {{0, 0}, {1000, 0}};
  EXPECT_EQ(xml_fault(svg(list)), "");
}

TEST(Svg, HugeCoordinatesAreCutNearThePicture) {
  DrawList list;
  list.view = {{0, 0}, {1, 1}};
  list.items.emplace_back(DrawPolyline{{{-1e11, 0.5}, {1e11, 0.5}}, false, 0, {255, 0, 0}});
  list.items.emplace_back(DrawArea{{{{-1e11, -1e11}, {1e11, -1e11}, {0, 1e11}}, {}}, {255, 0, 0}});
  list.items.emplace_back(DrawDisc{{{0, -1e11}, 1e11}, {255, 0, 0}});
  const std::string text = svg(list);
  EXPECT_LE(longest_number(text), 4) << text;
}

TEST(MergedCells, CoverEveryVisibleCellOnce) {
  Stream random(3, "cells");
  for (int round = 0; round < 200; ++round) {
    DrawCells cells{{}, 1, 1 + random.below(12), 1 + random.below(12), {}, {}};
    for (int i = 0; i < cells.width * cells.height; ++i)
      cells.colors.push_back(
          {static_cast<std::uint8_t>(random.below(3)), 0, 0, static_cast<std::uint8_t>(random.chance(0.8) ? 255 : 0)});
    std::vector<Color> covered(cells.colors.size(), Color{0, 0, 0, 0});
    for (const CellGroup& group : merged_cells(cells))
      for (const CellBlock& b : group.blocks)
        for (int y = b.y; y < b.y + b.height; ++y)
          for (int x = b.x; x < b.x + b.width; ++x) {
            Color& cell = covered[static_cast<std::size_t>(y * cells.width + x)];
            ASSERT_EQ(cell.a, 0);
            cell = group.color;
          }
    for (std::size_t i = 0; i < covered.size(); ++i)
      ASSERT_TRUE(cells.colors[i].a == 0 ? covered[i].a == 0 : covered[i] == cells.colors[i]);
  }
}

TEST(MergedCells, AnEmptyMapIsOneBlock) {
  const DrawCells cells{{}, 1, 50, 40, std::vector<Color>(2000), {}};
  const auto groups = merged_cells(cells);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].blocks.size(), 1u);
}

}  // namespace
}  // namespace meander
