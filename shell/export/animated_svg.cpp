// SPDX-License-Identifier: MIT
// A motion as an SVG picture that moves by CSS: each shape within groups for its rod and all that carry it.
// Without CSS, or where a reader wants less motion, it shows the first frame.
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "shell/export/exporters.h"
#include "shell/export/moving_picture.h"
#include "shell/export/number_text.h"
#include "shell/export/picture_colours.h"
#include "shell/export/xml_text.h"

namespace gaitsmith::shell {

namespace {

constexpr std::string_view kIdPlace = "\x01";  // no text has it
constexpr double kRestS = 1.0;                 // at the end, before a whole motion begins again

class AnimatedSvgText {
 public:
  AnimatedSvgText(const Document& document, const Motion& motion, bool loops)
      : document_(document), picture_(document, motion, loops), steps_(motion.Frames() - 1) {
    seconds_ = picture_.Seconds() + (loops ? 0.0 : kRestS);
  }

  std::string Whole() {
    std::string text = WithPlaces();
    // Names of animations hold for a whole page, which may contain other pictures.
    std::uint32_t hash = 2166136261u;  // FNV-1a [Fowler 1991]
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    char id[16];
    std::snprintf(id, sizeof id, "g%08x", static_cast<unsigned>(hash));
    for (std::size_t at = text.find(kIdPlace); at != std::string::npos; at = text.find(kIdPlace, at))
      text.replace(at, kIdPlace.size(), id);
    return text;
  }

 private:
  /// The picture, with places for what tells it from others.
  std::string WithPlaces() {
    std::string body = Ground();  // both add keyframes, in this order
    body += Figure();
    const std::string title = EscapedXml(document_.title.empty() ? document_.figure.name : document_.title);
    const std::string width = std::to_string(MovingPicture::kWidth);
    const std::string height = std::to_string(MovingPicture::kHeight);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"" + id_ + "\" viewBox=\"0 0 " + width + " " +
           height + "\" width=\"" + width + "\" height=\"" + height + "\" role=\"img\" aria-labelledby=\"" +
           id_ +
           "-title\" font-family=\"Inter, 'Helvetica Neue', Helvetica, Arial, sans-serif\">\n<title id=\"" +
           id_ + "-title\">" + title + "</title>\n<!-- 1 m = " + Decimal(picture_.Scale(), 3) +
           " px -->\n<style>\n" + Style() + "</style>\n" +
           "<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n" + body + "</svg>\n";
  }

  [[nodiscard]] std::string Colours(bool dark) const {
    std::string rules;
    for (const PictureColour& colour : kPictureColours) {
      const std::string hex = HexColour(dark ? colour.dark : colour.light);
      const std::string name = "." + id_ + " ." + std::string(colour.name);
      rules.append(name).append("{fill:").append(hex).append("}");
      rules.append(name).append("-stroke{stroke:").append(hex).append("}\n");
    }
    return rules;
  }

  [[nodiscard]] std::string Style() const {
    char duration[40];
    std::snprintf(duration, sizeof duration, "%.2fs", seconds_);
    return Colours(false) + "@media (prefers-color-scheme:dark){\n" + Colours(true) + "}\n." + id_ +
           " .moves{animation:" + duration + " linear infinite}\n" + keyframes_ +
           "@media (prefers-reduced-motion:reduce){." + id_ + " .moves{animation:none}}\n";
  }

  /// A group that moves. @param value of a key, in CSS @param start the same for the first frame, as an
  /// attribute
  template <class Value>
  std::string Moving(const std::string& name, const Track& track, const std::string& start, Value value) {
    if (track.frames.empty() || steps_ == 0) return "<g transform=\"" + start + "\">";
    const std::string animation = id_ + "-" + name;
    keyframes_.append("." + id_ + " ." + name + "{animation-name:" + animation + "}\n@keyframes " +
                      animation + "{");
    for (std::size_t i = 0; i < track.frames.size(); ++i) {
      const double share = 0.01 * track.frames[i] / seconds_;
      const bool last = i + 1 == track.frames.size();
      keyframes_.append(Decimal(100.0 * share, 3)).append(last && share < 1.0 ? "%,100%" : "%");
      keyframes_.append("{transform:").append(value(track.values[i])).append("}");
    }
    keyframes_ += "}\n";
    return "<g class=\"moves " + name + "\" transform=\"" + start + "\">";
  }
  std::string MovingPlace(const std::string& name, const Track& track) {
    const auto& first = track.values.front();
    return Moving(name, track, "translate(" + Decimal(first[0], 1) + " " + Decimal(first[1], 1) + ")",
                  [](const std::array<double, 2>& at) {
                    return "translate(" + Decimal(at[0], 1) + "px," + Decimal(at[1], 1) + "px)";
                  });
  }
  std::string MovingAngle(const std::string& name, const Track& track) {
    return Moving(name, track, "rotate(" + Decimal(track.values.front()[0], 2) + ")",
                  [](const std::array<double, 2>& at) { return "rotate(" + Decimal(at[0], 2) + "deg)"; });
  }

  std::string Ground() {
    const auto surface = picture_.Surface();
    std::string line;
    for (const auto& [x, y] : surface)
      line.append(line.empty() ? "M" : "L").append(Decimal(x, 1)).append(" ").append(Decimal(y, 1));
    std::string marks, texts;
    for (const MovingPicture::Mark& mark : picture_.Marks()) {
      marks.append("M" + Decimal(mark.x, 1) + " " + Decimal(mark.y, 1) + "v8");
      if (mark.text.empty()) continue;
      texts.append("<text x=\"" + Decimal(mark.x, 1) + "\" y=\"" + Decimal(mark.y + 24.0, 1) + "\">" +
                   mark.text + "</text>\n");
    }
    return MovingPlace("way", picture_.GroundKeys()) + "\n<path class=\"ground\" d=\"" + line + "V" +
           Decimal(picture_.Bottom(), 0) + "H" + Decimal(surface.front()[0], 1) +
           "Z\"/>\n<path class=\"line-stroke\" fill=\"none\" "
           "stroke-width=\"1.5\" d=\"" +
           line + "\"/>\n<path class=\"line-stroke\" fill=\"none\" d=\"" + marks + "\"/>\n" +
           (texts.empty()
                ? ""
                : "<g class=\"line\" font-size=\"12\" text-anchor=\"middle\">\n" + texts + "</g>\n") +
           "</g>\n";
  }

  /// Opens the groups that move with a bone, from the root on.
  void Open(int bone, std::string& text, int& depth) const {
    const int parent = picture_.Bones().ParentOf(bone);
    if (parent >= 0) Open(parent, text, depth);
    const double joint = picture_.Bones().JointM(bone) * picture_.Scale();
    if (joint != 0.0) {
      text.append("<g transform=\"translate(").append(Decimal(joint, 1)).append(" 0)\">");
      ++depth;
    }
    text += groups_[static_cast<std::size_t>(bone)];
    ++depth;
  }

  /// Shapes in the order of drawing, each within groups of its own: far limbs lie behind those that carry
  /// them.
  std::string Figure() {
    std::string text = MovingPlace("figure", picture_.PlaceKeys()) + "\n";
    for (int bone = 0; bone < picture_.Bones().Count(); ++bone)
      groups_.push_back(MovingAngle("b" + std::to_string(bone), picture_.AngleKeys(bone)));
    int last = -1, depth = 0;
    const auto close = [&] {
      for (; depth > 0; --depth) text += "</g>";
      if (last >= 0) text += "\n";
    };
    for (const BoneShape& shape : picture_.Shapes()) {
      if (shape.bone != last) {
        close();
        Open(shape.bone, text, depth);
        last = shape.bone;
      }
      std::string line;
      for (const auto& [x, y] : shape.outline_m)
        line.append(line.empty() ? "M" : "L").append(Decimal(x, 1)).append(" ").append(Decimal(y, 1));
      text.append("<path class=\"").append(shape.colour->name).append("\" d=\"").append(line).append("Z\"/>");
    }
    close();
    return text + "</g>\n";
  }

  const Document& document_;
  MovingPicture picture_;
  int steps_;
  double seconds_ = 0.0;
  const std::string id_{kIdPlace};
  std::string keyframes_;
  std::vector<std::string> groups_;  // that open the group of a bone
};

}  // namespace

std::string AnimatedSvg(const Document& document, const Motion& motion, const ExportOptions& options) {
  return AnimatedSvgText(document, motion, options.loops).Whole();
}

}  // namespace gaitsmith::shell
