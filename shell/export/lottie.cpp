// SPDX-License-Identifier: MIT
// A motion as a Lottie animation, version 5.7: a layer for each rod, whose parent is the layer of its parent,
// and layers for what is seen. Five colours are slots of the file, which newer players can set.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "shell/export/exporters.h"
#include "shell/export/json_parts.h"
#include "shell/export/moving_picture.h"
#include "shell/export/number_text.h"
#include "shell/export/picture_colours.h"

namespace gaitsmith::shell {

namespace {

constexpr int kFrameRate = 100;  // a frame for each step

std::string Pair(double x, double y) { return "[" + Decimal(x, 2) + "," + Decimal(y, 2) + "]"; }

std::string Still(const std::string& value) { return R"({"a":0,"k":)" + value + "}"; }

/// Keys with straight lines between them. @param value of a key, as JSON
template <class Value>
std::string Moving(const Track& track, Value value) {
  if (track.frames.size() < 2) return Still(value(track.values.front()));
  std::string keys;
  for (std::size_t i = 0; i < track.frames.size(); ++i) {
    keys.append(i > 0 ? "," : "").append(R"({"t":)" + std::to_string(track.frames[i]));
    keys.append(R"(,"s":)" + value(track.values[i]));
    if (i + 1 < track.frames.size()) keys += R"(,"i":{"x":[1],"y":[1]},"o":{"x":[0],"y":[0]})";
    keys += "}";
  }
  return R"({"a":1,"k":[)" + keys + "]}";
}

std::string Colour(unsigned rgb) {
  std::string text;
  for (const int shift : {16, 8, 0})
    text.append(text.empty() ? "[" : ",")
        .append(Decimal(static_cast<double>(rgb >> shift & 255u) / 255.0, 4));
  return text + "]";
}

std::string ColourSlot(const PictureColour& colour) {
  return R"({"sid":")" + std::string(colour.name) + R"(","a":0,"k":)" + Colour(colour.light) + "}";
}

class LottieText {
 public:
  LottieText(const Document& document, const Motion& motion, bool loops)
      : document_(document),
        picture_(document, motion, loops),
        frames_(std::max(1, motion.Frames() - (loops ? 1 : 0))) {}

  std::string Whole() {
    const MovingBones& bones = picture_.Bones();
    // The first layer is in front. Layers have numbers from 1: rods, then what carries them, then what is
    // seen.
    const int carrier = bones.Count() + 1;
    AddShapes(carrier + 1);
    for (int bone = 0; bone < bones.Count(); ++bone) {
      const std::string angle =
          Moving(picture_.AngleKeys(bone), [](const auto& at) { return "[" + Decimal(at[0], 2) + "]"; });
      const int parent = bones.ParentOf(bone) < 0 ? carrier : bones.ParentOf(bone) + 1;
      AddLayer(bone + 1, bones.NameOf(bone), parent, Still(Pair(bones.JointM(bone) * picture_.Scale(), 0.0)),
               angle, "");
    }
    const auto place = [](const auto& at) { return Pair(at[0], at[1]); };
    AddLayer(carrier, "figure", 0, Moving(picture_.PlaceKeys(), place), Still("0"), "");
    const int next = carrier + 1 + static_cast<int>(picture_.Shapes().size());
    AddGround(next, Moving(picture_.GroundKeys(), place));
    AddLayer(next + 1, "paper", 0, Still(Pair(0.5 * MovingPicture::kWidth, 0.5 * MovingPicture::kHeight)),
             Still("0"),
             Group(R"({"ty":"rc","p":{"a":0,"k":[0,0]},"r":{"a":0,"k":0},"s":)" +
                   Still(Pair(MovingPicture::kWidth, MovingPicture::kHeight)) + "}," + Fill(kPaperColour)));
    JsonParts meta;
    meta.Add("g", "Gaitsmith");
    meta.Add("d", std::string_view("1 m = " + Decimal(picture_.Scale(), 3) + " px"));
    JsonParts slots;
    for (const PictureColour& colour : kPictureColours)
      slots.AddJson(colour.name, R"({"p":)" + Still(Colour(colour.light)) + "}");
    JsonParts whole = JsonParts::Lines();
    whole.Add("v", "5.7.0");
    whole.Add("nm", document_.title);
    whole.AddJson("meta", meta.Object());
    whole.Add("fr", kFrameRate);
    whole.Add("ip", 0);
    whole.Add("op", frames_);
    whole.Add("w", MovingPicture::kWidth);
    whole.Add("h", MovingPicture::kHeight);
    whole.Add("ddd", 0);
    whole.AddJson("assets", "[]");
    whole.AddJson("slots", slots.Object());
    whole.AddJson("layers", layers_.ListOfLines());
    return whole.ObjectOfLines() + "\n";
  }

 private:
  static std::string Path(const std::vector<std::array<double, 2>>& points, bool closed) {
    JsonParts vertices, tangents;
    for (const auto& [x, y] : points) {
      vertices.Add(Pair(x, y));
      tangents.Add("[0,0]");
    }
    return R"({"ty":"sh","ks":)" +
           Still(R"({"v":)" + vertices.List() + R"(,"i":)" + tangents.List() + R"(,"o":)" + tangents.List() +
                 R"(,"c":)" + (closed ? "true" : "false") + "}") +
           "}";
  }
  static std::string Stroke(const PictureColour& colour, double width) {
    return R"({"ty":"st","c":)" + ColourSlot(colour) + R"(,"o":{"a":0,"k":100},"w":)" +
           Still(Decimal(width, 2)) + R"(,"lc":2,"lj":2})";
  }
  static std::string Fill(const PictureColour& colour) {
    return R"({"ty":"fl","c":)" + ColourSlot(colour) + R"(,"o":{"a":0,"k":100},"r":1})";
  }
  static std::string Group(const std::string& items) {
    return R"({"ty":"gr","it":[)" + items +
           R"(,{"ty":"tr","p":{"a":0,"k":[0,0]},"a":{"a":0,"k":[0,0]},"s":{"a":0,"k":[100,100]},"r":{"a":0,"k":0},"o":{"a":0,"k":100}}]})";
  }

  /// @param parent 0: none @param groups of shapes, the first one in front; empty: a layer that only carries
  /// others
  void AddLayer(int index, const std::string& name, int parent, const std::string& place,
                const std::string& angle, const std::string& groups) {
    std::string layer = R"({"ty":)" + std::string(groups.empty() ? "3" : "4");
    layer.append(R"(,"ind":)" + std::to_string(index) + R"(,"nm":")" + name + R"(")");
    if (parent > 0) layer += R"(,"parent":)" + std::to_string(parent);
    layer += R"(,"ip":0,"op":)" + std::to_string(frames_) +
             R"(,"st":0,"sr":1,"bm":0,"ks":{"o":{"a":0,"k":100},"r":)";
    layer += angle + R"(,"p":)" + place + R"(,"a":{"a":0,"k":[0,0]},"s":{"a":0,"k":[100,100]}})";
    if (!groups.empty()) layer += R"(,"shapes":[)" + groups + "]";
    layers_.Add(layer + "}");
  }

  void AddShapes(int first) {
    const auto& shapes = picture_.Shapes();
    for (std::size_t i = shapes.size(); i-- > 0;) {
      AddLayer(first + static_cast<int>(i), "shape", shapes[i].bone + 1, Still("[0,0]"), Still("0"),
               Group(Path(shapes[i].outline_m, true) + "," + Fill(*shapes[i].colour)));
    }
  }

  void AddGround(int index, const std::string& place) {
    const auto surface = picture_.Surface();
    auto solid = surface;
    solid.push_back({surface.back()[0], picture_.Bottom()});
    solid.push_back({surface.front()[0], picture_.Bottom()});
    std::string marks;
    for (const MovingPicture::Mark& mark : picture_.Marks())
      marks += Path({{mark.x, mark.y}, {mark.x, mark.y + 8.0}}, false) + ",";
    AddLayer(index, "ground", 0, place, Still("0"),
             Group(marks + Stroke(kLineColour, 1.0)) + "," +
                 Group(Path(surface, false) + "," + Stroke(kLineColour, 1.5)) + "," +
                 Group(Path(solid, true) + "," + Fill(kGroundColour)));
  }

  const Document& document_;
  MovingPicture picture_;
  int frames_;  // shown: the last one of a loop is its first
  JsonParts layers_ = JsonParts::Lines();
};

}  // namespace

std::string LottieJson(const Document& document, const Motion& motion, const ExportOptions& options) {
  return LottieText(document, motion, options.loops).Whole();
}

}  // namespace gaitsmith::shell
