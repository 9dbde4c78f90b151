// SPDX-License-Identifier: MIT
// PNG files, by LodePNG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaitsmith::shell {

/// @param pixels row by row from the top: bytes of red, green, blue and opacity, or indices of the palette
/// @param palette colours 0xrrggbb, at most 256, the first one transparent; empty: pixels are colours
[[nodiscard]] std::string PngOf(std::span<const std::uint8_t> pixels, int width, int height,
                                std::span<const std::uint32_t> palette);

struct PngChunk {
  std::string_view type;  // of 4 letters
  std::string content;
};
/// The chunks of a file that PngOf made. Their types are views of the file.
[[nodiscard]] std::vector<PngChunk> ChunksOf(std::string_view png);
[[nodiscard]] std::string PngOf(std::span<const PngChunk> chunks);

}  // namespace gaitsmith::shell
