// SPDX-License-Identifier: MIT
// A picture of pixels, painted with filled outlines whose edges are smooth.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gaitsmith::shell {

class PaintedPicture {
 public:
  static constexpr int kChannels = 4;  // red, green, blue, opacity

  /// Transparent.
  PaintedPicture(int width, int height);

  [[nodiscard]] int Width() const { return width_; }
  [[nodiscard]] int Height() const { return height_; }
  /// Bytes of the pixels, row by row from the top; kChannels each, colours not multiplied by opacity.
  [[nodiscard]] std::span<const std::uint8_t> Pixels() const { return pixels_; }
  /// 0xrrggbb, for pictures without transparent parts.
  [[nodiscard]] std::uint32_t ColourAt(std::size_t pixel) const;

  void Clear(unsigned rgb);
  /// Paints over what is there. @param outline closed, at least 3 points [px], y downwards; parts outside of
  /// the picture are left out @param rgb 0xrrggbb
  void Fill(std::span<const std::array<double, 2>> outline, unsigned rgb);

 private:
  void Blend(std::size_t pixel, std::uint32_t opacity, unsigned rgb);

  int width_, height_;
  std::vector<std::uint8_t> pixels_;
  std::vector<std::uint8_t> cover_;  // of one outline
};

/// A PNG file with the picture's opacity.
[[nodiscard]] std::string PngOf(const PaintedPicture&);

}  // namespace gaitsmith::shell
