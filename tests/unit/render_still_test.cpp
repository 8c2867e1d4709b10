// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The encoders of still pictures, read back by decoders of the test's own.
#include "render/still.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <map>

#include "base/random.hpp"
#include "render/draw_world.hpp"
#include "render/kitty.hpp"
#include "render/raster.hpp"
#include "render/sixel.hpp"

namespace meander {
namespace {

using Rgb = std::array<int, 3>;

/// What a terminal makes of a sixel picture; pixels never painted are -1.
struct Decoded {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;
};

class SixelReader {
 public:
  explicit SixelReader(const std::string& text) : text_(text) {}

  Decoded read() {
    take("\x1bP0;1;0q\"1;1;");
    picture_.width = number();
    take(";");
    picture_.height = number();
    picture_.pixels.assign(static_cast<std::size_t>(picture_.width * picture_.height), {-1, -1, -1});
    while (text_[at_] != '\x1b') step();
    take("\x1b\\\n");
    EXPECT_EQ(at_, text_.size());
    return picture_;
  }

 private:
  void step() {
    const char c = text_[at_];
    if (c == '#') return ++at_, color();
    if (c == '$') return ++at_, void(x_ = 0);
    if (c == '-') return ++at_, x_ = 0, void(y_ += 6);
    int count = 1;
    if (c == '!') ++at_, count = number();
    const int bits = text_[at_++] - '?';
    ASSERT_TRUE(bits >= 0 && bits < 64);
    for (; count > 0; --count, ++x_)
      for (int k = 0; k < 6; ++k)
        if (bits >> k & 1) paint(x_, y_ + k);
  }
  void color() {
    color_ = number();
    if (text_[at_] != ';') return;
    take(";2;");
    Rgb rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (i) take(";");
      rgb[i] = (number() * 255 + 50) / 100;
    }
    palette_[color_] = rgb;
  }
  void paint(int x, int y) {
    ASSERT_TRUE(x < picture_.width && y < picture_.height);
    picture_.pixels[static_cast<std::size_t>(y * picture_.width + x)] = palette_.at(color_);
  }
  int number() {
    int value = 0;
    while (std::isdigit(static_cast<unsigned char>(text_[at_]))) value = 10 * value + text_[at_++] - '0';
    return value;
  }
  void take(const std::string& expected) {
    ASSERT_EQ(text_.substr(at_, expected.size()), expected);
    at_ += expected.size();
  }

  std::string text_;
  std::size_t at_ = 0;
  int x_ = 0, y_ = 0, color_ = 0;
  std::map<int, Rgb> palette_;
  Decoded picture_;
};

/// The largest difference of a channel.
int worst(const Image& image, const Decoded& decoded) {
  int most = 0;
  for (std::size_t i = 0; i < decoded.pixels.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(decoded.pixels[i][k] - image.pixels[3 * i + k]));
  return most;
}

Image random_image(int width, int height, int colors) {
  Stream random(7, "image");
  std::vector<std::array<std::uint8_t, 3>> palette;
  for (int i = 0; i < colors; ++i)  // apart by more than a bin
    palette.push_back({static_cast<std::uint8_t>(i % 8 * 32 + 4), static_cast<std::uint8_t>(i / 8 % 8 * 32 + 4),
                       static_cast<std::uint8_t>(i / 64 * 32 + 4)});
  Image image{width, height, 3, {}};
  for (int i = 0; i < width * height; ++i) {
    const auto& rgb = palette[static_cast<std::size_t>(random.below(colors))];
    image.pixels.insert(image.pixels.end(), rgb.begin(), rgb.end());
  }
  return image;
}

TEST(Sixel, EveryPixelArrives) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {6, 6}, {300, 13}, {64, 48}}) {
    const Image image = random_image(width, height, 256);
    const Decoded decoded = SixelReader(sixel_picture(image)).read();
    ASSERT_EQ(decoded.width, width);
    ASSERT_EQ(decoded.height, height);
    EXPECT_LE(worst(image, decoded), 2) << "percent instead of bytes";
  }
}

TEST(Sixel, APictureOfAWorldKeepsItsColours) {
  Header header;
  header.bounds = {{0, 0}, {8, 5}};
  World world(header);
  world.add(Obstacle{.name = {}, .shape = Disc{{3, 2}, 0.7}, .surface = {}});
  const Image image = raster(draw_world(world), {640, 400});
  const std::string text = sixel_picture(image);
  EXPECT_LE(worst(image, SixelReader(text).read()), 8);
  EXPECT_LT(text.size(), 40'000u) << "runs are short where much is alike";
}

TEST(Sixel, MoreColoursThanFitTakeTheNearest) {
  Image image{512, 64, 3, {}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 512; ++x)
      for (const int value : {x / 2, 4 * y, 255 - x / 2}) image.pixels.push_back(static_cast<std::uint8_t>(value));
  EXPECT_LE(worst(image, SixelReader(sixel_picture(image)).read()), 40);
}

std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
  }
  return bytes;
}

TEST(Kitty, Base64IsThatOfTheStandard) {
  const std::pair<const char*, const char*> kPairs[] = {{"", ""},
                                                        {"f", "Zg=="},
                                                        {"fo", "Zm8="},
                                                        {"foo", "Zm9v"},
                                                        {"foob", "Zm9vYg=="},
                                                        {"fooba", "Zm9vYmE="},
                                                        {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : kPairs) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Kitty, ThePngArrivesInChunks) {
  const Image image = random_image(200, 150, 200);
  const std::string picture = kitty_picture(png_bytes(image, "test"));
  std::string payload;
  std::size_t at = 0;
  bool more = true;
  for (int chunk = 0; more; ++chunk) {
    const std::size_t end = picture.find("\x1b\\", at);
    ASSERT_NE(end, std::string::npos);
    const std::string command = picture.substr(at, end - at);
    const std::size_t semicolon = command.find(';');
    EXPECT_EQ(command.substr(0, semicolon - 1), chunk == 0 ? "\x1b_Ga=T,f=100,q=2,m=" : "\x1b_Gm=");
    more = command[semicolon - 1] == '1';
    EXPECT_LE(command.size() - semicolon - 1, 4096u);
    payload += command.substr(semicolon + 1);
    at = end + 2;
  }
  EXPECT_EQ(picture.substr(at), "\n");
  EXPECT_GT(payload.size(), 4096u);
  const std::string png = from_base64(payload);
  EXPECT_EQ(image_from_bytes({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()}, "test"), image);
}

TEST(Still, NoneIsNothingAndCharactersAreAFrame) {
  DrawList list;
  list.items.emplace_back(DrawDisc{{{0.5, 0.5}, 0.4}, {0, 0, 0}, Mark::wall});
  EXPECT_EQ(still_picture(list, {}, StillMode::none, TerminalMode::ascii), "");
  EXPECT_EQ(still_picture(list, {{4, 2}, 0, 0}, StillMode::characters, TerminalMode::ascii), " ##\n ##\n# wall\n");
}

}  // namespace
}  // namespace meander
