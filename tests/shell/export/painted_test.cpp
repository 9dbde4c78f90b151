// SPDX-License-Identifier: MIT
// Pictures of pixels, and the files that hold them. tests/web reads the exported files as other programs do.
#include <array>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/document/json.h"
#include "core/gait/document_loop.h"
#include "core/numeric/random.h"
#include "shell/export/exporters.h"
#include "shell/export/painted_picture.h"
#include "shell/export/png_bytes.h"
#include "shell/export/zip_archive.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {
namespace {

using Outline = std::vector<std::array<double, 2>>;

constexpr unsigned kBlue = 0x204060, kCream = 0xf0e0d0;

/// Opacity of all pixels, in pixels: the area that is covered.
double Covered(const PaintedPicture& picture) {
  double sum = 0.0;
  for (std::size_t i = 3; i < picture.Pixels().size(); i += PaintedPicture::kChannels)
    sum += picture.Pixels()[i] / 255.0;
  return sum;
}

double AreaOf(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return 0.5 * std::abs(twice);
}

TEST_CASE("painted: what is covered is the outline's area, wherever it is and whichever way round") {
  RandomStream random(11, 0, 1);
  const auto number = [&](double most) { return most * static_cast<double>(random.Below(10001)) / 10000.0; };
  for (int trial = 0; trial < 300; ++trial) {
    Outline triangle;
    for (int corner = 0; corner < 3; ++corner) triangle.push_back({1.0 + number(60.0), 1.0 + number(40.0)});
    PaintedPicture picture(62, 42), turned(62, 42), moved(62, 42);
    picture.Fill(triangle, kBlue);
    CHECK(Covered(picture) == Catch::Approx(AreaOf(triangle)).margin(1.2));  // 255 steps for each pixel
    Outline back(triangle.rbegin(), triangle.rend());
    turned.Fill(back, kBlue);
    CHECK(std::ranges::equal(turned.Pixels(), picture.Pixels()));
    for (auto& point : back) point[0] += 500.0;  // outside
    moved.Fill(back, kBlue);
    CHECK(Covered(moved) == 0.0);
  }
}

TEST_CASE("painted: of what is partly outside, the part inside is covered") {
  // A wedge over the top of the picture, and over its bottom: its area inside is known.
  const Outline up{{10.0, -20.0}, {30.0, 20.0}, {-10.0, 20.0}};  // as wide as its height below the tip
  PaintedPicture top(40, 40), bottom(40, 40);
  top.Fill(up, kBlue);
  double inside = 0.0;  // rows from y = 0 to 20, cut at x = 0
  for (int i = 0; i < 2000; ++i) {
    const double y = 0.01 * (i + 0.5), half = 0.5 * (y + 20.0);
    inside += 0.01 * (std::min(40.0, 10.0 + half) - std::max(0.0, 10.0 - half));
  }
  CHECK(Covered(top) == Catch::Approx(inside).margin(1.5));
  Outline turned;
  for (const auto& [x, y] : up) turned.push_back({40.0 - x, 40.0 - y});
  bottom.Fill(turned, kBlue);
  CHECK(Covered(bottom) == Catch::Approx(inside).margin(1.5));
}

TEST_CASE("painted: a pixel that is half covered is half of each colour, and opaque stays opaque") {
  const auto half = std::to_array<std::array<double, 2>>({{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {0.0, 1.0}});
  PaintedPicture picture(1, 1);
  picture.Fill(half, kBlue);
  CHECK(picture.ColourAt(0) == kBlue);  // not darkened by what is not there
  CHECK(std::abs(picture.Pixels()[3] - 128) <= 1);
  picture.Clear(kCream);
  CHECK(picture.ColourAt(0) == kCream);
  picture.Fill(half, kBlue);
  CHECK(picture.Pixels()[3] == 255);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const unsigned shift = 16 - 8 * static_cast<unsigned>(channel);
    const double mean = 0.5 * ((kBlue >> shift & 255u) + (kCream >> shift & 255u));
    CHECK(std::abs(picture.Pixels()[channel] - mean) <= 1.0);
  }
}

TEST_CASE("painted: places that are not numbers, or far away, paint nothing wrong") {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  PaintedPicture picture(8, 8);
  for (const double wild : {kNone, std::numeric_limits<double>::infinity(), 1e300, -1e300}) {
    picture.Fill(Outline{{wild, 0.0}, {4.0, 4.0}, {4.0, wild}}, kBlue);
    picture.Fill(Outline{{wild, wild}, {wild, wild}, {wild, wild}}, kBlue);
  }
  PaintedPicture whole(8, 8);
  whole.Fill(Outline{{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}, {-1e9, 1e9}}, kBlue);
  CHECK(Covered(whole) == Catch::Approx(64.0));
}

TEST_CASE("png: a file is taken apart and put together again without a change") {
  const std::array<std::uint8_t, 6> indices{0, 1, 2, 2, 1, 0};
  const std::array<std::uint32_t, 3> palette{0, kBlue, kCream};
  const std::string png = PngOf(indices, 3, 2, palette);
  const auto chunks = ChunksOf(png);
  std::string types;
  for (const PngChunk& chunk : chunks) types.append(types.empty() ? "" : " ").append(chunk.type);
  CHECK(types == "IHDR PLTE tRNS IDAT IEND");
  CHECK(PngOf(chunks) == png);
}

int Little(std::string_view text, std::size_t at, int bytes) {
  int value = 0;
  for (int i = bytes - 1; i >= 0; --i)
    value = value * 256 + static_cast<unsigned char>(text[at + static_cast<std::size_t>(i)]);
  return value;
}

TEST_CASE("zip: its directory leads to every file") {
  const std::string archive = ZipOf(std::array{ArchivedFile{"a.txt", "one"}, ArchivedFile{"b.txt", ""}});
  const std::size_t end = archive.size() - 22;
  REQUIRE(archive.substr(end, 4) == "PK\x05\x06");
  CHECK(Little(archive, end + 10, 2) == 2);
  auto at = static_cast<std::size_t>(Little(archive, end + 16, 4));
  CHECK(at + static_cast<std::size_t>(Little(archive, end + 12, 4)) == end);
  for (const std::string_view expected : {"a.txt:one", "b.txt:"}) {
    const auto file = static_cast<std::size_t>(Little(archive, at + 42, 4));
    const int name = Little(archive, file + 26, 2);
    CHECK(archive.substr(file + 30, static_cast<std::size_t>(name)) + ":" +
              archive.substr(file + 30 + static_cast<std::size_t>(name),
                             static_cast<std::size_t>(Little(archive, file + 22, 4))) ==
          expected);
    at += 46 + static_cast<std::size_t>(Little(archive, at + 28, 2));
  }
}

Document OfSprings() {
  return DecodeJson(gaitsmith::test::ReadFile("examples/gallery/table-trip.json")).value();
}
Document Shuffle() { return DecodeJson(gaitsmith::test::ReadFile("examples/star-man-shuffle.json")).value(); }

TEST_CASE("sprites: a sheet that is too large says how large, and others fit") {
  const Document document = Shuffle();
  const Motion motion = Simulate(document);
  CHECK(SpritesFit(document, motion, {.sprites = {.frames = 256, .size = 240}}).has_value());
  const auto refused = SpritesFit(document, motion, {.sprites = {.frames = 256, .size = 1024}});
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().what, Catch::Matchers::ContainsSubstring("256 frames of ") &&
                                       Catch::Matchers::ContainsSubstring("are too many for a sheet"));
  const auto large = SpritesFit(document, motion, {.sprites = {.frames = 2, .scale = 1e6}});
  CHECK_FALSE(large);
}

TEST_CASE("files of bytes: a motion that fails makes them too") {
  for (Document document : {Shuffle(), OfSprings()}) {
    // As far away as a state can be, and not a number.
    for (const float wild : {3e38f, std::numeric_limits<float>::quiet_NaN()}) {
      document.start.velocity_x_mps = wild;
      const Motion wrong = Simulate(document);
      for (const ExporterRow& row : kExporters) {
        const auto file = MakeFile(row, document, wrong, {});
        if (file) CHECK_FALSE(file->empty());
      }
    }
  }
}

}  // namespace
}  // namespace gaitsmith::shell::test
