// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "base/error.hpp"
#include "base/random.hpp"
#include "grid/image_file.hpp"
#include "own_folder.hpp"

namespace meander {
namespace {

namespace fs = std::filesystem;

/// A file of the fuzzing corpus: they are all small.
std::string sample(const std::string& name) {
  return std::string(MEANDER_SOURCE_DIR) + "/tests/fuzz/corpus/grid_image_fuzz/" + name;
}

std::string scratch(const std::string& name) { return (own_folder() / name).string(); }

std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Image random_image(int seed, int channels) {
  Stream stream(static_cast<std::uint64_t>(seed), "image");
  Image image{1 + stream.below(40), 1 + stream.below(40), channels, {}};
  image.pixels.resize(static_cast<std::size_t>(image.width * image.height * channels));
  for (auto& value : image.pixels) value = static_cast<std::uint8_t>(stream.below(256));
  return image;
}

std::string message(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ImageFile, ComesBackAsItWasWritten) {
  for (int seed = 0; seed < 30; ++seed)
    for (const int channels : {1, 3, 4}) {
      const Image image = random_image(seed, channels);
      write_image(scratch("a.png"), image);
      EXPECT_EQ(read_image(scratch("a.png")), image);
      if (channels > 1) continue;
      write_image(scratch("a.pgm"), image);
      EXPECT_EQ(read_image(scratch("a.pgm")), image);
    }
}

TEST(ImageFile, WritesTheSameBytesForTheSameImage) {
  const Image image = random_image(7, 3);
  write_image(scratch("one.png"), image);
  write_image(scratch("two.png"), image);
  EXPECT_EQ(bytes_of(scratch("one.png")), bytes_of(scratch("two.png")));
}

TEST(ImageFile, ReadsEveryKindOfFile) {
  for (const char* name : {"grey.png", "grey.tiff", "deep.png", "grey.jpg"}) {
    const Image image = read_image(sample(name));
    EXPECT_EQ(image.width, 8) << name;
    EXPECT_EQ(image.height, 6) << name;
    EXPECT_EQ(image.channels, 1) << name;
    EXPECT_LT(grey(image, 0, 0), 60) << name;  // the dark top row
    EXPECT_GT(grey(image, 0, 5), 195) << name;
  }
  for (const char* name : {"colour.png", "colour.bmp"}) {
    const Image image = read_image(sample(name));
    ASSERT_EQ(image.channels, 3) << name;
    const std::size_t last = image.pixels.size() - 3;
    EXPECT_EQ(image.pixels[last], 200) << name;  // red comes first
    EXPECT_EQ(image.pixels[last + 2], 0) << name;
    EXPECT_EQ(grey(image, 7, 5), 67) << name;
  }
  EXPECT_EQ(read_image(sample("alpha.png")).pixels[3], 0);
  EXPECT_EQ(read_image(sample("progressive.jpg")).channels, 3);
}

TEST(ImageFile, ScalesPgmToEightBits) {
  EXPECT_EQ(read_image(sample("text.pgm")), (Image{3, 2, 1, {0, 17, 34, 221, 238, 255}}));
  EXPECT_EQ(read_image(sample("binary.pgm")), (Image{3, 2, 1, {0, 1, 2, 253, 254, 255}}));
  EXPECT_EQ(read_image(sample("deep.pgm")), (Image{2, 1, 1, {0, 255}}));
}

TEST(ImageFile, RefusesWhatItCannotReadWithAReason) {
  const std::pair<const char*, const char*> cases[] = {
      {"claims_a_gigapixel.pgm", "31623 x 31623 pixels, at most 100000000 are read"},
      {"claims_too_much.pgm", "100000 x 100000 pixels, at most"},
      {"claims_too_much.png", "100000 x 100000 pixels, at most"},
      {"claims_too_much.jpg", "60000 x 60000 pixels, at most"},
      {"cut_short.pgm", "cut short: 4 x 4 pixels need 16 bytes, 7 are there"},
      {"cut_short_text.pgm", "cut short"},
      {"cut_short.png", "cut short: the end of the PNG is missing"},
      {"cut_short.jpg", "cut short: the end of the JPEG is missing"},
      {"damaged.png", "cannot be read as PNG"},
      {"too_bright.pgm", "grey value up to 7 expected"},
      {"negative.pgm", "byte 4: width expected"},
      {"overflow.pgm", "width up to"},
      {"empty", "a PGM, PNG, JPEG, BMP or TIFF image expected"},
      {"missing.png", "no such file"},
      {"", "is a folder"}};
  for (const auto& [name, expected] : cases) {
    const std::string text = message([&] { read_image(sample(name)); });
    EXPECT_NE(text.find(expected), std::string::npos) << name << ": " << text;
    EXPECT_EQ(text.rfind(sample(name), 0), 0u) << name << ": " << text;
  }
}

TEST(ImageFile, RefusesEveryTruncationOfAPng) {
  const std::string whole = bytes_of(sample("colour.png"));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string part = whole.substr(0, size);
    EXPECT_THROW(image_from_bytes({reinterpret_cast<const std::uint8_t*>(part.data()), size}, "part"), FileError);
  }
}

TEST(ImageFile, SurvivesDamageAnywhere) {
  for (const char* name : {"colour.png", "grey.jpg", "colour.bmp", "grey.tiff", "text.pgm", "deep.pgm"}) {
    const std::string whole = bytes_of(sample(name));
    Stream stream(1, name);
    for (int i = 0; i < 200; ++i) {
      std::string damaged = whole;
      for (int n = 1 + stream.below(3); n > 0; --n)
        damaged[static_cast<std::size_t>(stream.below(static_cast<int>(whole.size())))] =
            static_cast<char>(stream.below(256));
      try {
        const Image image =
            image_from_bytes({reinterpret_cast<const std::uint8_t*>(damaged.data()), damaged.size()}, name);
        EXPECT_LE(std::int64_t{image.width} * image.height, kMaxPixels);
      } catch (const FileError&) {
      }
    }
  }
}

TEST(ImageFile, RefusesToWriteWhatHasNoForm) {
  EXPECT_NE(message([] {
              write_image(scratch("a.gif"), Image{1, 1, 1, {0}});
            }).find(".png or .pgm"),
            std::string::npos);
  EXPECT_NE(message([] { write_image(scratch("a.pgm"), Image{1, 1, 3, {0, 0, 0}}); }).find("grey"), std::string::npos);
  EXPECT_NE(message([] { write_image(scratch("a.png"), Image{2, 1, 1, {0}}); }).find("values"), std::string::npos);
  EXPECT_THROW(write_image(scratch("no/such/a.png"), Image{1, 1, 1, {0}}), FileError);
}

}  // namespace
}  // namespace meander
