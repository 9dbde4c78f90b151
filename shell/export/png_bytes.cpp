// SPDX-License-Identifier: MIT
// PNG files whose bytes depend on nothing but the pixels.
#include "shell/export/png_bytes.h"

#include <lodepng.h>

#include <cstdlib>

namespace gaitsmith::shell {

namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kAroundChunk = 12;  // its length, type and checksum

const unsigned char* Bytes(std::string_view text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

/// LodePNG fails only without memory: everything else is right by construction.
void OrNoMemory(unsigned error) {
  if (error != 0) std::abort();
}

}  // namespace

std::string PngOf(std::span<const std::uint8_t> pixels, int width, int height,
                  std::span<const std::uint32_t> palette) {
  lodepng::State state;
  state.encoder.auto_convert = 0;            // all frames of a picture that moves are alike
  state.encoder.filter_strategy = LFS_ZERO;  // best for plain colours
  for (LodePNGColorMode* mode : {&state.info_raw, &state.info_png.color}) {
    mode->colortype = palette.empty() ? LCT_RGBA : LCT_PALETTE;
    mode->bitdepth = 8;
    for (std::size_t i = 0; i < palette.size(); ++i) {
      OrNoMemory(lodepng_palette_add(mode, static_cast<unsigned char>(palette[i] >> 16),
                                     static_cast<unsigned char>(palette[i] >> 8 & 255u),
                                     static_cast<unsigned char>(palette[i] & 255u), i == 0 ? 0 : 255));
    }
  }
  std::vector<unsigned char> png;
  OrNoMemory(lodepng::encode(png, pixels.data(), static_cast<unsigned>(width), static_cast<unsigned>(height),
                             state));
  return {png.begin(), png.end()};
}

std::vector<PngChunk> ChunksOf(std::string_view png) {
  std::vector<PngChunk> chunks;
  for (std::size_t at = kSignature.size(); at < png.size();
       at += kAroundChunk + chunks.back().content.size()) {
    const unsigned length = lodepng_chunk_length(Bytes(png) + at);
    chunks.push_back({png.substr(at + 4, 4), std::string(png.substr(at + 8, length))});
  }
  return chunks;
}

std::string PngOf(std::span<const PngChunk> chunks) {
  unsigned char* out = nullptr;
  std::size_t size = 0;
  for (const PngChunk& chunk : chunks) {
    OrNoMemory(lodepng_chunk_create(&out, &size, chunk.content.size(), std::string(chunk.type).c_str(),
                                    Bytes(chunk.content)));
  }
  std::string png(kSignature);
  png.append(reinterpret_cast<const char*>(out), size);
  std::free(out);  // of LodePNG's allocator
  return png;
}

}  // namespace gaitsmith::shell
