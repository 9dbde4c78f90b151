// SPDX-License-Identifier: MIT
// A motion as a sheet of sprites for games: a PNG, and a JSON in the array form of Aseprite, as one ZIP.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "shell/export/exporters.h"
#include "shell/export/following_view.h"
#include "shell/export/json_parts.h"
#include "shell/export/moving_outlines.h"
#include "shell/export/painted_picture.h"
#include "shell/export/picture_colours.h"
#include "shell/export/zip_archive.h"

namespace gaitsmith::shell {

namespace {

constexpr double kSpriteMargin =
    1.0;  // around the figure, so that smooth edges of neighbours do not meet [px]

class Sprites {
 public:
  Sprites(const Document& document, const Motion& motion, const ExportOptions& options)
      : outlines_(document.figure, motion),
        last_(motion.Frames() - 1),
        view_(motion, Terrain(document.environment.ground), options.loops),
        sole_m_(SoleM(document.figure)),
        loops_(options.loops),
        frames_(
            std::clamp(options.sprites.frames, 1, std::max(1, motion.Frames() - (options.loops ? 1 : 0)))) {
    for (int sprite = 0; sprite < frames_; ++sprite) {
      for (const auto& filled : FigureM(sprite)) {
        for (const auto& [x, y] : filled.outline_m) {
          if (!std::isfinite(x) || !std::isfinite(y)) continue;  // of a motion that fails
          left_m_ = std::min(left_m_, x);
          right_m_ = std::max(right_m_, x);
          top_m_ = std::max(top_m_, y);
          bottom_m_ = std::min(bottom_m_, y);
        }
      }
    }
    const double wide_m = right_m_ - left_m_, high_m = top_m_ - bottom_m_;
    scale_ = options.sprites.scale > 0.0
                 ? options.sprites.scale
                 : (options.sprites.size - 2.0 * kSpriteMargin) / std::max({wide_m, high_m, 1e-6});
    // Of a motion that fails a number may not fit into a picture; Fits says so.
    width_ = std::ceil(wide_m * scale_ - 1e-6) + 2.0 * kSpriteMargin;
    height_ = std::ceil(high_m * scale_ - 1e-6) + 2.0 * kSpriteMargin;
    // About as wide as it is high.
    columns_ = static_cast<int>(std::lround(std::sqrt(frames_ * std::min(1e6, height_ / width_))));
    columns_ = std::clamp(columns_, 1, frames_);
    rows_ = (frames_ + columns_ - 1) / columns_;
  }

  [[nodiscard]] Result<void> Fits() const {
    constexpr double kMost = SpriteOptions::kMostSheet;
    const double wide = columns_ * width_, high = rows_ * height_;
    if (wide <= kMost && high <= kMost && wide * high <= SpriteOptions::kMostPixels) return {};
    return Fail(ErrorCode::kOutOfRange, "sprites",
                std::to_string(frames_) + " frames of " + Decimal(width_, 0) + " by " + Decimal(height_, 0) +
                    " pixels are too many for a sheet: ask for fewer, or for smaller ones");
  }

  [[nodiscard]] std::string Sheet() const {
    const int width = static_cast<int>(width_), height = static_cast<int>(height_);
    PaintedPicture sheet(columns_ * width, rows_ * height);
    for (int sprite = 0; sprite < frames_; ++sprite) {
      const double x = Column(sprite) * width_ + kSpriteMargin;
      const double y = Row(sprite) * height_ + kSpriteMargin;
      for (auto& [colour, outline] : FigureM(sprite)) {
        for (auto& point : outline)
          point = {x + (point[0] - left_m_) * scale_, y + (top_m_ - point[1]) * scale_};
        sheet.Fill(outline, colour->light);
      }
    }
    return PngOf(sheet);
  }

  [[nodiscard]] std::string Description() const {
    JsonParts frames = JsonParts::Lines(), cels;
    for (int sprite = 0; sprite < frames_; ++sprite) {
      JsonParts frame;
      frame.Add("filename", "motion " + std::to_string(sprite));
      frame.AddJson("frame", Box(Column(sprite) * width_, Row(sprite) * height_, width_, height_));
      frame.AddJson("rotated", "false");
      frame.AddJson("trimmed", "false");
      frame.AddJson("spriteSourceSize", Box(0.0, 0.0, width_, height_));
      frame.AddJson("sourceSize", Size(width_, height_));
      frame.Add("duration", Milliseconds(sprite + 1) - Milliseconds(sprite));
      frames.Add(frame.Object());
      JsonParts cel;
      cel.Add("frame", sprite);
      cel.Add("data", Decimal(view_.MiddleM(StepOf(sprite)) - view_.MiddleM(0), 4) + " m");
      cels.Add(cel.Object());
    }
    JsonParts layer, tag, slice, key;
    layer.Add("name", "figure");
    layer.Add("opacity", 255);
    layer.Add("blendMode", "normal");
    layer.AddJson("cels", cels.List());
    tag.Add("name", "motion");
    tag.Add("from", 0);
    tag.Add("to", frames_ - 1);
    tag.Add("direction", "forward");
    const double ground =
        std::clamp(std::floor((top_m_ + sole_m_) * scale_ + kSpriteMargin), 0.0, height_ - 1.0);
    key.Add("frame", 0);
    key.AddJson("bounds", Box(0.0, ground, width_, 1.0));
    key.AddJson("pivot", Point(std::floor(kSpriteMargin - left_m_ * scale_ + 0.5), 0.0));
    slice.Add("name", "ground");
    slice.AddJson("keys", "[" + key.Object() + "]");
    JsonParts meta = JsonParts::Lines();
    meta.Add("app", "Gaitsmith");
    meta.Add("image", "sprites.png");
    meta.Add("format", "RGBA8888");
    meta.AddJson("size", Size(columns_ * width_, rows_ * height_));
    meta.Add("scale", "1");
    meta.Add("pixelsPerMetre", Decimal(scale_, 3));
    meta.AddJson("frameTags", "[" + tag.Object() + "]");
    meta.AddJson("layers", "[" + layer.Object() + "]");
    meta.AddJson("slices", "[" + slice.Object() + "]");
    JsonParts whole = JsonParts::Lines();
    whole.AddJson("frames", frames.ListOfLines());
    whole.AddJson("meta", meta.ObjectOfLines());
    return whole.ObjectOfLines() + "\n";
  }

 private:
  static std::string Point(double x, double y) {
    return R"({"x": )" + Decimal(x, 0) + R"(, "y": )" + Decimal(y, 0) + "}";
  }
  static std::string Size(double w, double h) {
    return R"({"w": )" + Decimal(w, 0) + R"(, "h": )" + Decimal(h, 0) + "}";
  }
  static std::string Box(double x, double y, double w, double h) {
    return R"({"x": )" + Decimal(x, 0) + R"(, "y": )" + Decimal(y, 0) + R"(, "w": )" + Decimal(w, 0) +
           R"(, "h": )" + Decimal(h, 0) + "}";
  }

  [[nodiscard]] int Column(int sprite) const { return sprite % columns_; }
  [[nodiscard]] int Row(int sprite) const { return sprite / columns_; }

  /// Intervals between sprites: of a loop the last one leads back to the first.
  [[nodiscard]] int Intervals() const { return std::max(1, loops_ ? frames_ : frames_ - 1); }
  [[nodiscard]] int StepOf(int sprite) const {
    return (2 * sprite * last_ + Intervals()) / (2 * Intervals());
  }
  /// From the start to a sprite. The last one of a whole motion is seen as long as the others.
  [[nodiscard]] int Milliseconds(int sprite) const {
    return (20 * sprite * last_ + Intervals()) / (2 * Intervals());
  }

  /// Against the view's middle and the ground there, y upwards.
  [[nodiscard]] std::vector<MovingOutlines::Filled> FigureM(int sprite) const {
    const int step = StepOf(sprite);
    std::vector<MovingOutlines::Filled> figure = outlines_.At(step);
    for (auto& filled : figure) {
      for (auto& [x, y] : filled.outline_m) {
        x -= view_.MiddleM(step);
        y -= view_.GroundM(step);
      }
    }
    return figure;
  }

  MovingOutlines outlines_;
  int last_;  // step of the motion
  FollowingView view_;
  double sole_m_;
  bool loops_;
  int frames_;
  double left_m_ = 0.0, right_m_ = 0.0, top_m_ = 0.0, bottom_m_ = 0.0;
  double scale_ = 1.0, width_ = 0.0, height_ = 0.0;  // of a frame [px/m], [px]
  int columns_ = 1, rows_ = 1;
};

}  // namespace

Result<void> SpritesFit(const Document& document, const Motion& motion, const ExportOptions& options) {
  return Sprites(document, motion, options).Fits();
}

std::string SpriteSheetZip(const Document& document, const Motion& motion, const ExportOptions& options) {
  const Sprites sprites(document, motion, options);
  return ZipOf(std::array{ArchivedFile{"sprites.png", sprites.Sheet()},
                          ArchivedFile{"sprites.json", sprites.Description()}});
}

}  // namespace gaitsmith::shell
