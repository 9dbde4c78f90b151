// SPDX-License-Identifier: MIT
// Fills outlines with the rasteriser for fonts that comes with Dear ImGui, which knows how much of each pixel
// is covered.
#include "shell/export/painted_picture.h"

#include <algorithm>
#include <cmath>

#include "shell/export/png_bytes.h"

// Its outlines are in whole units, unless a vertex is defined before.
// NOLINTBEGIN(readability-identifier-naming): its names
#define stbtt_vertex gaitsmith_stb_vertex
struct gaitsmith_stb_vertex {
  float x, y, cx, cy, cx1, cy1;
  unsigned char type, padding;
};
#define stbtt_vertex_type float
#define STBTT_assert(condition) ((void)0)
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <imstb_truetype.h>
#undef stbtt_vertex
// NOLINTEND(readability-identifier-naming)

namespace gaitsmith::shell {

namespace {

/// A point that the rasteriser has numbers for, which wild motions may exceed.
std::array<double, 2> Within(const std::array<double, 2>& point) {
  constexpr double kFar = 30000.0;  // [px]
  return {std::clamp(point[0], -kFar, kFar), std::clamp(point[1], -kFar, kFar)};
}

/// The part of an outline below the picture's top, above which the rasteriser may not look
/// [Sutherland Hodgman 1974].
std::vector<std::array<double, 2>> BelowTop(std::span<const std::array<double, 2>> outline) {
  std::vector<std::array<double, 2>> below;
  below.reserve(2 * outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto from = Within(outline[i]), to = Within(outline[(i + 1) % outline.size()]);
    if (from[1] >= 0.0) below.push_back(from);
    if ((from[1] < 0.0) != (to[1] < 0.0))
      below.push_back({from[0] + (to[0] - from[0]) * (from[1] / (from[1] - to[1])), 0.0});
  }
  return below;
}

}  // namespace

PaintedPicture::PaintedPicture(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * kChannels, 0) {}

std::uint32_t PaintedPicture::ColourAt(std::size_t pixel) const {
  const std::uint8_t* at = &pixels_[kChannels * pixel];
  return static_cast<std::uint32_t>(at[0]) << 16 | static_cast<std::uint32_t>(at[1]) << 8 | at[2];
}

void PaintedPicture::Clear(unsigned rgb) {
  for (std::size_t i = 0; i < pixels_.size(); i += kChannels) {
    pixels_[i] = static_cast<std::uint8_t>(rgb >> 16);
    pixels_[i + 1] = static_cast<std::uint8_t>(rgb >> 8);
    pixels_[i + 2] = static_cast<std::uint8_t>(rgb);
    pixels_[i + 3] = 255;
  }
}

void PaintedPicture::Fill(std::span<const std::array<double, 2>> outline, unsigned rgb) {
  // The bounds are cut at the picture's, with a pixel around it, so that a wild motion has no numbers that do
  // not fit.
  const auto cut = [](double value, int most) { return std::clamp(value, -1.0, most + 1.0); };
  double left = 1e300, right = -1e300, top = 1e300, bottom = -1e300;
  for (const auto& [x, y] : outline) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
  const int x0 = std::max(0, static_cast<int>(std::floor(cut(left, width_))));
  const int x1 = std::min(width_, static_cast<int>(std::ceil(cut(right, width_))));
  const int y0 = std::max(0, static_cast<int>(std::floor(cut(top, height_))));
  const int y1 = std::min(height_, static_cast<int>(std::ceil(cut(bottom, height_))));
  if (x1 <= x0 || y1 <= y0) return;
  const auto below = BelowTop(outline);
  if (below.size() < 3) return;
  std::vector<gaitsmith_stb_vertex> vertices;
  vertices.reserve(below.size() + 1);
  for (std::size_t i = 0; i <= below.size(); ++i) {
    const auto& [x, y] = below[i % below.size()];
    vertices.push_back(
        {.x = static_cast<float>(x - x0),
         .y = static_cast<float>(y - y0),
         .cx = 0.0f,
         .cy = 0.0f,
         .cx1 = 0.0f,
         .cy1 = 0.0f,
         .type = i == 0 ? static_cast<unsigned char>(STBTT_vmove) : static_cast<unsigned char>(STBTT_vline),
         .padding = 0});
  }
  const int width = x1 - x0, height = y1 - y0;
  cover_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  stbtt__bitmap bitmap{width, height, width, cover_.data()};
  stbtt_Rasterize(&bitmap, 0.35f, vertices.data(), static_cast<int>(vertices.size()), 1.0f, 1.0f, 0.0f, 0.0f,
                  0, 0, 0, nullptr);
  std::size_t from = 0;
  for (int y = y0; y < y1; ++y) {
    std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x0);
    for (int x = x0; x < x1; ++x, ++pixel, ++from)
      if (cover_[from] > 0) Blend(pixel, cover_[from], rgb);
  }
}

// Porter and Duff's "over" in whole numbers [Porter Duff 1984].
void PaintedPicture::Blend(std::size_t pixel, std::uint32_t opacity, unsigned rgb) {
  std::uint8_t* at = &pixels_[kChannels * pixel];
  const std::uint32_t below = at[3] * (255u - opacity);  // in 255ths
  const std::uint32_t whole = 255u * opacity + below;
  for (int channel = 0; channel < 3; ++channel) {
    const std::uint32_t colour = rgb >> (16 - 8 * channel) & 255u;
    at[channel] =
        static_cast<std::uint8_t>((colour * 255u * opacity + at[channel] * below + whole / 2) / whole);
  }
  at[3] = static_cast<std::uint8_t>((whole + 127u) / 255u);
}

std::string PngOf(const PaintedPicture& picture) {
  return PngOf(picture.Pixels(), picture.Width(), picture.Height(), {});
}

}  // namespace gaitsmith::shell
