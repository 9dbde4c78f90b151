// SPDX-License-Identifier: MIT
// A motion for programs that play DragonBones 5.5: a skeleton with its animation, the figure's parts as an
// atlas of pictures, and where each part is in it, as one ZIP.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "core/numeric/scalar_math.h"
#include "shell/export/bone_shapes.h"
#include "shell/export/exporters.h"
#include "shell/export/json_parts.h"
#include "shell/export/moving_bones.h"
#include "shell/export/painted_picture.h"
#include "shell/export/picture_colours.h"
#include "shell/export/zip_archive.h"

namespace gaitsmith::shell {

namespace {

constexpr double kUsualScale = 100.0;    // as Godot's scenes have it [px/m]
constexpr double kLongestPart = 1000.0;  // [px]: a figure with longer ones is smaller
constexpr int kMargin = 1;               // around a part [px]
constexpr int kStepRate = 100;           // a frame for each step
constexpr double kDegrees = 180.0 / kPi;
// Players turn the shorter way round, so no two keys may be half a turn apart.
constexpr double kMostTurn = 120.0;

/// A part's picture in the atlas, and where its middle is on its bone [px].
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
  std::array<double, 2> middle{};
  std::vector<std::array<double, 2>> outline;  // within the region [px]
};

class DragonBonesText {
 public:
  DragonBonesText(const Document& document, const Motion& motion, bool loops)
      : document_(document), bones_(motion), shapes_(BoneShapesOf(document.figure)), loops_(loops) {
    double longest_m = 0.0;
    for (const BoneShape& shape : shapes_) {
      const auto [left, right] = std::ranges::minmax_element(shape.outline_m);
      longest_m = std::max(longest_m, (*right)[0] - (*left)[0]);
    }
    scale_ = std::min(kUsualScale, kLongestPart / std::max(longest_m, 1e-6));
    for (const BoneShape& shape : shapes_) regions_.push_back(RegionOf(shape));
    Pack();
  }

  [[nodiscard]] std::string Skeleton() const {
    JsonParts bones = JsonParts::Lines(), slots, displays, tracks = JsonParts::Lines();
    for (int bone = 0; bone < bones_.Count(); ++bone) {
      bones.Add(Bone(bone));
      tracks.Add(Keys(bone));
    }
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      JsonParts slot, display, skin;
      slot.Add("name", NameOf(i));
      slot.Add("parent", bones_.NameOf(shapes_[i].bone));
      slots.Add(slot.Object());
      display.Add("name", NameOf(i));
      display.AddJson("transform", Place(regions_[i].middle));
      skin.Add("name", NameOf(i));
      skin.AddJson("display", "[" + display.Object() + "]");
      displays.Add(skin.Object());
    }
    JsonParts animation, skin, armature = JsonParts::Lines(), whole = JsonParts::Lines();
    animation.Add("duration", bones_.Frames() - 1);
    animation.Add("playTimes", loops_ ? 0 : 1);
    animation.Add("name", "motion");
    animation.AddJson("bone", tracks.ListOfLines());
    skin.Add("name", "");
    skin.AddJson("slot", displays.List());
    armature.Add("type", "Armature");
    armature.Add("name", "figure");
    armature.Add("frameRate", kStepRate);
    armature.AddJson("bone", bones.ListOfLines());
    armature.AddJson("slot", slots.List());
    armature.AddJson("skin", "[" + skin.Object() + "]");
    armature.AddJson("animation", "[" + animation.Object() + "]");
    armature.AddJson("defaultActions", R"([{"gotoAndPlay": "motion"}])");
    whole.Add("name", document_.title.empty() ? document_.figure.name : document_.title);
    whole.Add("version", "5.5");
    whole.Add("compatibleVersion", "5.5");
    whole.Add("frameRate", kStepRate);
    whole.AddJson("armature", "[" + armature.ObjectOfLines() + "]");
    return whole.ObjectOfLines() + "\n";
  }

  [[nodiscard]] std::string Atlas() const {
    JsonParts parts = JsonParts::Lines(), whole = JsonParts::Lines();
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      JsonParts part;
      part.Add("name", NameOf(i));
      part.Add("x", regions_[i].x);
      part.Add("y", regions_[i].y);
      part.Add("width", regions_[i].width);
      part.Add("height", regions_[i].height);
      parts.Add(part.Object());
    }
    whole.Add("name", "figure");
    whole.Add("imagePath", "figure_tex.png");
    whole.Add("width", width_);
    whole.Add("height", height_);
    whole.AddJson("SubTexture", parts.ListOfLines());
    return whole.ObjectOfLines() + "\n";
  }

  [[nodiscard]] std::string Picture() const {
    PaintedPicture picture(width_, height_);
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      auto outline = regions_[i].outline;
      for (auto& [x, y] : outline) {
        x += regions_[i].x;
        y += regions_[i].y;
      }
      picture.Fill(outline, shapes_[i].colour->light);
    }
    return PngOf(picture);
  }

 private:
  static std::string NameOf(std::size_t shape) { return "part " + std::to_string(shape + 1); }
  static std::string Place(const std::array<double, 2>& at) {
    return R"({"x": )" + Decimal(at[0], 2) + R"(, "y": )" + Decimal(at[1], 2) + "}";
  }

  [[nodiscard]] Region RegionOf(const BoneShape& shape) const {
    double left = 1e300, right = -1e300, top = 1e300, bottom = -1e300;
    for (const auto& [x, y] : shape.outline_m) {
      left = std::min(left, x * scale_);
      right = std::max(right, x * scale_);
      top = std::min(top, -y * scale_);
      bottom = std::max(bottom, -y * scale_);
    }
    Region region;
    region.width = static_cast<int>(std::ceil(right - left)) + 2 * kMargin;
    region.height = static_cast<int>(std::ceil(bottom - top)) + 2 * kMargin;
    region.middle = {left - kMargin + 0.5 * region.width, top - kMargin + 0.5 * region.height};
    for (const auto& [x, y] : shape.outline_m)
      region.outline.push_back({x * scale_ - left + kMargin, -y * scale_ - top + kMargin});
    return region;
  }

  /// Puts the parts in rows, the highest first.
  void Pack() {
    std::vector<std::size_t> order(regions_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
      return regions_[a].height != regions_[b].height ? regions_[a].height > regions_[b].height : a < b;
    });
    double area = 0.0;
    int widest = 0;
    for (const Region& region : regions_) {
      area += static_cast<double>(region.width) * region.height;
      widest = std::max(widest, region.width);
    }
    const int row_width = std::max(widest, static_cast<int>(std::ceil(std::sqrt(1.3 * area))));
    int x = 0, y = 0, row = 0;
    for (const std::size_t i : order) {
      Region& region = regions_[i];
      if (x > 0 && x + region.width > row_width) {
        y += row;
        x = row = 0;
      }
      region.x = x;
      region.y = y;
      x += region.width;
      row = std::max(row, region.height);
      width_ = std::max(width_, x);
    }
    height_ = y + row;
  }

  [[nodiscard]] double Degrees(int frame, int bone) const { return -bones_.AngleRad(frame, bone) * kDegrees; }
  [[nodiscard]] std::array<double, 2> StartPx(int frame) const {
    const auto start = bones_.Start(frame);
    return {start[0] * scale_, -start[1] * scale_};
  }

  /// In the pose of the first frame.
  [[nodiscard]] std::string Bone(int bone) const {
    const int parent = bones_.ParentOf(bone);
    const auto at = parent < 0 ? StartPx(0) : std::array{bones_.JointM(bone) * scale_, 0.0};
    const std::string angle = Decimal(Degrees(0, bone), 2);
    JsonParts parts;
    parts.Add("name", bones_.NameOf(bone));
    if (parent >= 0) parts.Add("parent", bones_.NameOf(parent));
    parts.AddJson("length", Decimal(bones_.LengthM(bone) * scale_, 2));
    parts.AddJson("transform", R"({"x": )" + Decimal(at[0], 2) + R"(, "y": )" + Decimal(at[1], 2) +
                                   R"(, "skX": )" + angle + R"(, "skY": )" + angle + "}");
    return parts.Object();
  }

  /// @param text of a key's value, as members of an object
  template <class Text>
  static std::string Timeline(const Track& track, Text text) {
    JsonParts keys;
    for (std::size_t i = 0; i < track.frames.size(); ++i) {
      const int duration = i + 1 < track.frames.size() ? track.frames[i + 1] - track.frames[i] : 0;
      keys.Add(R"({"duration": )" + std::to_string(duration) +
               (duration > 0 ? R"(, "tweenEasing": 0, )" : ", ") + text(track.values[i]) + "}");
    }
    return keys.List();
  }

  /// A bone's keys, against the pose of the first frame.
  [[nodiscard]] std::string Keys(int bone) const {
    std::vector<std::array<double, 2>> angles;
    angles.reserve(static_cast<std::size_t>(bones_.Frames()));
    for (int frame = 0; frame < bones_.Frames(); ++frame)
      angles.push_back({Degrees(frame, bone) - Degrees(0, bone), 0.0});
    JsonParts parts;
    parts.Add("name", bones_.NameOf(bone));
    if (bone == 0) {
      std::vector<std::array<double, 2>> places;
      places.reserve(angles.size());
      const auto first = StartPx(0);
      for (int frame = 0; frame < bones_.Frames(); ++frame) {
        const auto at = StartPx(frame);
        places.push_back({at[0] - first[0], at[1] - first[1]});
      }
      parts.AddJson("translateFrame", Timeline(KeysOf(places, kKeyPlaceM * scale_), [](const auto& at) {
                      return R"("x": )" + Decimal(at[0], 2) + R"(, "y": )" + Decimal(at[1], 2);
                    }));
    }
    parts.AddJson("rotateFrame",
                  Timeline(WithoutHalfTurns(KeysOf(angles, kKeyAngleRad * kDegrees), angles),
                           [](const auto& at) { return R"("rotate": )" + Decimal(at[0], 2); }));
    return parts.Object();
  }

  /// More keys, where two are too far apart.
  static Track WithoutHalfTurns(const Track& track, const std::vector<std::array<double, 2>>& angles) {
    Track closer;
    for (std::size_t i = 0; i < track.frames.size(); ++i) {
      if (i > 0) {
        const int from = track.frames[i - 1], to = track.frames[i];
        const double turn = std::abs(track.values[i][0] - track.values[i - 1][0]);
        const int parts =
            std::clamp(static_cast<int>(std::ceil(std::min(turn / kMostTurn, 1e6))), 1, to - from);
        for (int part = 1; part < parts; ++part) {
          closer.frames.push_back(from + part * (to - from) / parts);
          closer.values.push_back(angles[static_cast<std::size_t>(closer.frames.back())]);
        }
      }
      closer.frames.push_back(track.frames[i]);
      closer.values.push_back(track.values[i]);
    }
    return closer;
  }

  const Document& document_;
  MovingBones bones_;
  std::vector<BoneShape> shapes_;
  bool loops_;
  double scale_ = kUsualScale;
  std::vector<Region> regions_;  // of the shapes, in their order
  int width_ = 0, height_ = 0;   // of the atlas [px]
};

}  // namespace

std::string DragonBonesZip(const Document& document, const Motion& motion, const ExportOptions& options) {
  const DragonBonesText text(document, motion, options.loops);
  return ZipOf(std::array{ArchivedFile{"figure_ske.json", text.Skeleton()},
                          ArchivedFile{"figure_tex.json", text.Atlas()},
                          ArchivedFile{"figure_tex.png", text.Picture()}});
}

}  // namespace gaitsmith::shell
