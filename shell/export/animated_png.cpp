// SPDX-License-Identifier: MIT
// A motion as a PNG that moves (APNG), in the colours of the light theme: every frame has only the pixels
// that changed.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "shell/export/exporters.h"
#include "shell/export/moving_outlines.h"
#include "shell/export/moving_picture.h"
#include "shell/export/painted_picture.h"
#include "shell/export/picture_colours.h"
#include "shell/export/png_bytes.h"

namespace gaitsmith::shell {

namespace {

constexpr int kWidth = MovingPicture::kWidth, kHeight = MovingPicture::kHeight;
constexpr int kStepsPerFrame = 4;                              // 25 frames a second
constexpr int kRest = 100;                                     // of a whole motion's last frame [1/100 s]
constexpr double kLine = 1.5, kMark = 1.0, kMarkLength = 8.0;  // [px]

using Outline = std::vector<std::array<double, 2>>;

/// A line as an outline. @param width [px]
Outline Stroke(const std::array<double, 2>& from, const std::array<double, 2>& to, double width) {
  const double x = to[0] - from[0], y = to[1] - from[1];
  const double half = 0.5 * width / std::max(std::sqrt(x * x + y * y), 1e-9);
  const double side_x = -half * y, side_y = half * x;
  return {{from[0] + side_x, from[1] + side_y},
          {to[0] + side_x, to[1] + side_y},
          {to[0] - side_x, to[1] - side_y},
          {from[0] - side_x, from[1] - side_y}};
}

/// Paints the frames of a picture that moves.
class FramePainter {
 public:
  FramePainter(const MovingPicture& moving, const MovingOutlines& outlines)
      : moving_(moving), outlines_(outlines), surface_(moving.Surface()), marks_(moving.Marks()) {}

  void Paint(int frame, PaintedPicture& picture) const {
    picture.Clear(kPaperColour.light);
    PaintGround(moving_.GroundAt(frame), picture);
    for (auto& [colour, outline] : outlines_.At(frame)) {
      for (auto& point : outline) point = moving_.PlaceAt(frame, point);
      picture.Fill(outline, colour->light);
    }
  }

 private:
  void PaintGround(const std::array<double, 2>& at, PaintedPicture& picture) const {
    const auto moved = [&](const std::array<double, 2>& point) {
      return std::array{at[0] + point[0], at[1] + point[1]};
    };
    Outline seen;  // of the surface
    for (std::size_t i = 0; i + 1 < surface_.size(); ++i) {
      const auto from = moved(surface_[i]), to = moved(surface_[i + 1]);
      if (to[0] < 0.0 || from[0] > kWidth) continue;
      if (seen.empty()) seen.push_back(from);
      seen.push_back(to);
    }
    if (seen.empty()) return;
    Outline solid = seen;
    solid.push_back({seen.back()[0], kHeight});
    solid.push_back({seen.front()[0], kHeight});
    picture.Fill(solid, kGroundColour.light);
    for (std::size_t i = 0; i + 1 < seen.size(); ++i)
      picture.Fill(Stroke(seen[i], seen[i + 1], kLine), kLineColour.light);
    for (const MovingPicture::Mark& mark : marks_) {
      const auto top = moved({mark.x, mark.y});
      picture.Fill(Stroke(top, {top[0], top[1] + kMarkLength}, kMark), kLineColour.light);
    }
  }

  const MovingPicture& moving_;
  const MovingOutlines& outlines_;
  Outline surface_;
  std::vector<MovingPicture::Mark> marks_;
};

/// The five colours and the steps between any two of them, since edges are smooth. Entry 0 is "unchanged".
class Palette {
 public:
  Palette() : colours_{0u} {
    for (const PictureColour& colour : kPictureColours) colours_.push_back(colour.light);
    for (std::size_t a = 0; a < kPictureColours.size(); ++a) {
      for (std::size_t b = a + 1; b < kPictureColours.size(); ++b) {
        for (unsigned step = 1; step < kSteps; ++step)
          colours_.push_back(Between(kPictureColours[a].light, kPictureColours[b].light, step));
      }
    }
  }
  [[nodiscard]] const std::vector<std::uint32_t>& Colours() const { return colours_; }

  /// The entry nearest to a colour; of several the first.
  std::uint8_t IndexOf(std::uint32_t colour) {
    if (colour == last_) return last_index_;  // as most neighbours have
    last_ = colour;
    const auto [known, is_new] = known_.try_emplace(colour, std::uint8_t{0});
    if (is_new) {
      const auto nearer = [&](std::uint32_t a, std::uint32_t b) {
        return Distance(a, colour) < Distance(b, colour);
      };
      known->second = static_cast<std::uint8_t>(
          std::min_element(colours_.begin() + 1, colours_.end(), nearer) - colours_.begin());
    }
    return last_index_ = known->second;
  }

 private:
  static constexpr unsigned kSteps = 20;  // 1 + 5 + 10 · 19 colours

  static std::uint32_t Between(std::uint32_t a, std::uint32_t b, unsigned step) {
    std::uint32_t mixed = 0;
    for (const int shift : {16, 8, 0})
      mixed |= ((a >> shift & 255u) * (kSteps - step) + (b >> shift & 255u) * step + kSteps / 2) / kSteps
               << shift;
    return mixed;
  }
  static int Distance(std::uint32_t a, std::uint32_t b) {
    int sum = 0;
    for (const int shift : {16, 8, 0}) {
      const int off = static_cast<int>(a >> shift & 255u) - static_cast<int>(b >> shift & 255u);
      sum += off * off;
    }
    return sum;
  }

  std::vector<std::uint32_t> colours_;
  std::map<std::uint32_t, std::uint8_t> known_;
  std::uint32_t last_ = ~0u;
  std::uint8_t last_index_ = 0;
};

/// A number with its highest byte first.
std::string Big(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 255u);
  return text;
}

/// The pixels of a frame that are new, as indices.
class ChangedPixels {
 public:
  /// @param shown indices of what is there, which this brings up to date
  ChangedPixels(std::vector<std::uint8_t>& shown, const std::vector<std::uint8_t>& next) {
    int x0 = kWidth, x1 = 0, y0 = kHeight, y1 = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (shown[At(x, y)] == next[At(x, y)]) continue;
        x0 = std::min(x0, x);
        x1 = std::max(x1, x + 1);
        y0 = std::min(y0, y);
        y1 = std::max(y1, y + 1);
      }
    }
    if (x1 == 0) x0 = y0 = 0, x1 = y1 = 1;  // a frame must have a pixel
    left = x0, top = y0, width = x1 - x0, height = y1 - y0;
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x)
        indices.push_back(shown[At(x, y)] == next[At(x, y)] ? std::uint8_t{0} : next[At(x, y)]);
    }
    shown = next;
  }

  int left = 0, top = 0, width = 0, height = 0;
  std::vector<std::uint8_t> indices;

 private:
  static std::size_t At(int x, int y) {
    return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
  }
};

}  // namespace

std::string AnimatedPng(const Document& document, const Motion& motion, const ExportOptions& options) {
  const MovingPicture moving(document, motion, options.loops);
  const MovingOutlines outlines(document.figure, motion);
  const FramePainter painter(moving, outlines);
  const int steps = std::max(1, motion.Frames() - 1);
  const int frames = (options.loops ? steps - 1 : motion.Frames() - 1) / kStepsPerFrame + 1;
  Palette palette;
  PaintedPicture picture(kWidth, kHeight);
  std::vector<std::uint8_t> shown(static_cast<std::size_t>(kWidth) * kHeight, 0), next(shown);
  std::vector<PngChunk> chunks;
  std::vector<std::string> files;  // which the chunks' types are views of
  files.reserve(static_cast<std::size_t>(frames));
  std::uint32_t number = 0;
  for (int frame = 0; frame < frames; ++frame) {
    painter.Paint(frame * kStepsPerFrame, picture);
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = palette.IndexOf(picture.ColourAt(i));
    const ChangedPixels changed(shown, next);
    files.push_back(PngOf(changed.indices, changed.width, changed.height, palette.Colours()));
    const bool last = frame + 1 == frames;
    const int rest = options.loops ? steps - frame * kStepsPerFrame : kRest;
    std::string control = Big(number++, 4);
    for (const int value : {changed.width, changed.height, changed.left, changed.top})
      control += Big(static_cast<std::uint32_t>(value), 4);
    control += Big(static_cast<std::uint32_t>(last ? rest : kStepsPerFrame), 2) + Big(100, 2);
    control += Big(0, 1) + Big(frame == 0 ? 0 : 1, 1);  // keep what is shown, and lay the frame over it
    for (PngChunk& chunk : ChunksOf(files.back())) {
      if (chunk.type == "IDAT") {
        if (!control.empty()) chunks.push_back({"fcTL", std::exchange(control, "")});
        if (frame > 0) chunk = {"fdAT", Big(number++, 4) + chunk.content};
        chunks.push_back(std::move(chunk));
      } else if (frame == 0 && chunk.type != "IEND") {
        chunks.push_back(std::move(chunk));
        if (chunks.size() == 1)
          chunks.push_back(
              {"acTL", Big(static_cast<std::uint32_t>(frames), 4) + Big(0, 4)});  // without an end
      }
    }
  }
  chunks.push_back({"IEND", ""});
  return PngOf(chunks);
}

}  // namespace gaitsmith::shell
