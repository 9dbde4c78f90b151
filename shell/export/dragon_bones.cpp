// SPDX-License-Identifier: MIT
// A motion for programs that play DragonBones 5.5: a skeleton with its animation, the figure's parts as an
// atlas of pictures, and where each part is in it, as one ZIP.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/numeric/scalar_math.h"
#include "shell/export/bone_shapes.h"
#include "shell/export/exporters.h"
#include "shell/export/json_parts.h"
#include "shell/export/moving_bones.h"
#include "shell/export/part_atlas.h"
#include "shell/export/zip_archive.h"

namespace gaitsmith::shell {

namespace {

constexpr int kStepRate = 100;  // a frame for each step
constexpr double kDegrees = 180.0 / kPi;
// Players turn the shorter way round, so no two keys may be half a turn apart.
constexpr double kMostTurn = 120.0;

class DragonBonesText {
 public:
  DragonBonesText(const Document& document, const Motion& motion, bool loops)
      : document_(document),
        bones_(motion),
        shapes_(BoneShapesOf(document.figure)),
        atlas_(shapes_),
        scale_(atlas_.Scale()),
        loops_(loops) {}

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
      display.AddJson("transform", Place(atlas_.Regions()[i].middle));
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

  [[nodiscard]] std::string Picture() const { return atlas_.Png(); }
  [[nodiscard]] std::string Places() const {
    JsonParts parts = JsonParts::Lines(), whole = JsonParts::Lines();
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const PartAtlas::Region& region = atlas_.Regions()[i];
      JsonParts part;
      part.Add("name", NameOf(i));
      part.Add("x", region.x);
      part.Add("y", region.y);
      part.Add("width", region.width);
      part.Add("height", region.height);
      parts.Add(part.Object());
    }
    whole.Add("name", "figure");
    whole.Add("imagePath", "figure_tex.png");
    whole.Add("width", atlas_.Width());
    whole.Add("height", atlas_.Height());
    whole.AddJson("SubTexture", parts.ListOfLines());
    return whole.ObjectOfLines() + "\n";
  }

 private:
  static std::string NameOf(std::size_t shape) { return "part " + std::to_string(shape + 1); }
  static std::string Place(const std::array<double, 2>& at) {
    return R"({"x": )" + Decimal(at[0], 2) + R"(, "y": )" + Decimal(at[1], 2) + "}";
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
            std::clamp(static_cast<int>(std::ceil(std::min(1e6, turn / kMostTurn))), 1, to - from);
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
  PartAtlas atlas_;
  double scale_;
  bool loops_;
};

}  // namespace

std::string DragonBonesZip(const Document& document, const Motion& motion, const ExportOptions& options) {
  const DragonBonesText text(document, motion, options.loops);
  return ZipOf(std::array{ArchivedFile{"figure_ske.json", text.Skeleton()},
                          ArchivedFile{"figure_tex.json", text.Places()},
                          ArchivedFile{"figure_tex.png", text.Picture()}});
}

}  // namespace gaitsmith::shell
