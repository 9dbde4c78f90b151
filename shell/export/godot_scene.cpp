// SPDX-License-Identifier: MIT
// A motion as a Godot scene: a Skeleton2D of bones with polygons, and an AnimationPlayer. Format 2 is that of
// Godot 3, format 3 that of Godot 4. A metre is 100 pixels; y points down, and angles turn clockwise.
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/json_value.h"
#include "core/numeric/scalar_math.h"
#include "shell/export/bone_shapes.h"
#include "shell/export/exporters.h"
#include "shell/export/moving_bones.h"
#include "shell/export/number_text.h"

namespace gaitsmith::shell {

namespace {

constexpr double kPxPerM = 100.0;

struct Dialect {
  int format;
  std::string_view reals, vectors;  // types of arrays
  std::string_view id;              // of the animation
  std::string_view loop;            // property of an animation that repeats
};
constexpr Dialect kGodot3{2, "PoolRealArray", "PoolVector2Array", "1", "loop = true"};
constexpr Dialect kGodot4{3, "PackedFloat32Array", "PackedVector2Array", "\"Animation_1\"", "loop_mode = 1"};

std::string Seven(double value) { return Digits(value, 7); }
std::string GodotColour(const PictureColour& colour) {
  std::string text = "Color(";
  for (const int shift : {16, 8, 0})
    text += Seven(static_cast<double>(colour.light >> shift & 255u) / 255.0) + ", ";
  return text + "1)";
}
std::string Vector(double x, double y) { return "Vector2(" + Seven(x) + ", " + Seven(y) + ")"; }

class GodotText {
 public:
  GodotText(const Document& document, const Motion& motion, bool loops, const Dialect& dialect)
      : document_(document), bones_(motion), loops_(loops), dialect_(dialect) {}

  std::string Whole() {
    const bool old = dialect_.format == 2;
    std::string text = "[gd_scene load_steps=" + std::string(old ? "2" : "3") +
                       " format=" + std::to_string(dialect_.format) + "]\n\n";
    text += "[sub_resource type=\"Animation\" id=" + std::string(dialect_.id) +
            "]\nresource_name = " + QuoteJson(document_.title) +
            "\nlength = " + Seven(0.01 * (bones_.Frames() - 1)) + "\n" +
            (loops_ ? std::string(dialect_.loop) + "\n" : "");
    text += Tracks() + "\n";
    if (!old)
      text +=
          "[sub_resource type=\"AnimationLibrary\" id=\"AnimationLibrary_1\"]\n_data = {\n\"motion\": "
          "SubResource(\"Animation_1\")\n}\n\n";
    text += "[node name=\"Figure\" type=\"Node2D\"]\n\n";
    text += "[node name=\"Skeleton\" type=\"Skeleton2D\" parent=\".\"]\n\n";
    for (int bone = 0; bone < bones_.Count(); ++bone) text += Bone(bone);
    text += Shapes();
    text += "[node name=\"AnimationPlayer\" type=\"AnimationPlayer\" parent=\".\"]\nautoplay = \"motion\"\n";
    return text + (old ? "anims/motion = SubResource( 1 )\n"
                       : "libraries = {\n\"\": SubResource(\"AnimationLibrary_1\")\n}\n");
  }

 private:
  static std::string NodeName(int bone) { return "rod_" + std::to_string(bone + 1); }
  /// From the skeleton on.
  [[nodiscard]] std::string PathTo(int bone) const {
    if (bone < 0) return "Skeleton";
    return PathTo(bones_.ParentOf(bone)) + "/" + NodeName(bone);
  }
  [[nodiscard]] std::array<double, 2> PlaceOf(int frame, int bone) const {
    if (bone > 0) return {bones_.JointM(bone) * kPxPerM, 0.0};
    const auto start = bones_.Start(frame);
    return {start[0] * kPxPerM, -start[1] * kPxPerM};
  }
  [[nodiscard]] double TurnOf(int frame, int bone) const { return -bones_.AngleRad(frame, bone); }

  /// @param value of a key
  template <class Value>
  std::string TrackText(int number, const std::string& path, const Track& track, Value value) const {
    std::string times, transitions, values;
    for (std::size_t i = 0; i < track.frames.size(); ++i) {
      const std::string_view comma = i > 0 ? ", " : "";
      times.append(comma).append(Seven(0.01 * track.frames[i]));
      transitions.append(comma).append("1");
      values.append(comma).append(value(track.values[i]));
    }
    const std::string name = "tracks/" + std::to_string(number) + "/", reals(dialect_.reals);
    return name + "type = \"value\"\n" + name + "path = NodePath(\"" + path + "\")\n" + name +
           "interp = 1\n" + name + "loop_wrap = " + (loops_ ? "true" : "false") + "\n" + name +
           "imported = false\n" + name + "enabled = true\n" + name + "keys = {\n\"times\": " + reals + "(" +
           times + "),\n\"transitions\": " + reals + "(" + transitions + "),\n\"update\": 0,\n\"values\": [" +
           values + "]\n}\n";
  }

  [[nodiscard]] std::string Tracks() const {
    std::vector<std::array<double, 2>> values;
    values.reserve(static_cast<std::size_t>(bones_.Frames()));
    for (int frame = 0; frame < bones_.Frames(); ++frame) values.push_back(PlaceOf(frame, 0));
    std::string text = TrackText(0, PathTo(0) + ":position", KeysOf(values, kKeyPlaceM * kPxPerM),
                                 [](const auto& at) { return Vector(at[0], at[1]); });
    for (int bone = 0; bone < bones_.Count(); ++bone) {
      for (int frame = 0; frame < bones_.Frames(); ++frame)
        values[static_cast<std::size_t>(frame)] = {TurnOf(frame, bone), 0.0};
      text += TrackText(bone + 1, PathTo(bone) + ":rotation", KeysOf(values, kKeyAngleRad),
                        [](const auto& at) { return Seven(at[0]); });
    }
    return text;
  }

  [[nodiscard]] std::string Bone(int bone) const {
    const auto place = PlaceOf(0, bone);
    const double turn = TurnOf(0, bone);
    const double whole = 2.0 * kPi * std::floor(turn / (2.0 * kPi) + 0.5);
    const SineCosine at = SinCos(static_cast<float>(turn - whole));
    const auto cosine = static_cast<double>(at.cosine), sine = static_cast<double>(at.sine);
    const std::string length = Seven(bones_.LengthM(bone) * kPxPerM);
    const std::string parent = PathTo(bones_.ParentOf(bone));
    std::string text = "[node name=\"" + NodeName(bone) + "\" type=\"Bone2D\" parent=\"" + parent +
                       "\"]\nposition = " + Vector(place[0], place[1]) + "\nrotation = " + Seven(turn) +
                       "\nrest = Transform2D(" + Seven(cosine) + ", " + Seven(sine) + ", " + Seven(-sine) +
                       ", " + Seven(cosine) + ", " + Seven(place[0]) + ", " + Seven(place[1]) + ")\n";
    text += dialect_.format == 2
                ? "default_length = " + length + "\n\n"
                : "auto_calculate_length_and_angle = false\nlength = " + length + "\nbone_angle = 0.0\n\n";
    return text;
  }

  /// Shapes are drawn in their order, far limbs behind those that carry them.
  [[nodiscard]] std::string Shapes() const {
    std::string text;
    int order = 1;
    for (const BoneShape& shape : BoneShapesOf(document_.figure)) {
      std::string points;
      for (const auto& [x, y] : shape.outline_m)
        points.append(points.empty() ? "" : ", ")
            .append(Seven(x * kPxPerM))
            .append(", ")
            .append(Seven(-y * kPxPerM));
      text += "[node name=\"shape_" + std::to_string(order) + "\" type=\"Polygon2D\" parent=\"" +
              PathTo(shape.bone) + "\"]\nz_index = " + std::to_string(order) +
              "\ncolor = " + GodotColour(*shape.colour) + "\npolygon = " + std::string(dialect_.vectors) +
              "(" + points + ")\n\n";
      ++order;
    }
    return text;
  }

  const Document& document_;
  MovingBones bones_;
  bool loops_;
  const Dialect& dialect_;
};

}  // namespace

std::string GodotScene(const Document& document, const Motion& motion, const ExportOptions& options) {
  return GodotText(document, motion, options.loops, kGodot4).Whole();
}

std::string Godot3Scene(const Document& document, const Motion& motion, const ExportOptions& options) {
  return GodotText(document, motion, options.loops, kGodot3).Whole();
}

}  // namespace gaitsmith::shell
