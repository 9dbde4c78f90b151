// SPDX-License-Identifier: MIT
#include "shell/stage/pose_board.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/numeric/scalar_math.h"
#include "shell/stage/figure_drawing.h"
#include "shell/stage/limb_grip.h"
#include "shell/words/language.h"
#include "shell/words/rule_words.h"

namespace gaitsmith::shell {
namespace {

constexpr float kBoardHeight = 184.0f;
/// The pose on the canvas: endpoint 0 stays where it is while limbs turn.
struct Picture {
  const Skeleton& bones;
  float scale;
  ImVec2 origin;

  [[nodiscard]] std::vector<ImVec2> ToCanvas(std::vector<ImVec2> metres) const {
    const ImVec2 first = metres[0];
    for (ImVec2& p : metres) p = {origin.x + (p.x - first.x) * scale, origin.y - (p.y - first.y) * scale};
    return metres;
  }
};

Picture LayOut(const Skeleton& bones, const std::vector<ImVec2>& metres, const LimbDrag& drag,
               const ImRect& rect) {
  if (drag.limb >= 0) return {bones, drag.scale, drag.origin};
  // Include the rest pose, so that the present pose, drawn behind, usually fits too.
  ImRect extent(metres[0], metres[0]);
  for (const ImVec2& point : metres) extent.Add(point);
  const std::vector<ImVec2> rest = PoseOf(bones, {});
  for (const ImVec2& point : rest) {
    extent.Add(ImVec2(point.x - rest[0].x + metres[0].x, point.y - rest[0].y + metres[0].y));
  }
  const float scale = 0.82f * std::min(rect.GetHeight() / std::max(extent.GetHeight(), 0.1f),
                                       rect.GetWidth() / std::max(extent.GetWidth(), 0.1f));
  const ImVec2 middle = rect.GetCenter();
  return {bones,
          scale,
          {middle.x + (metres[0].x - extent.GetCenter().x) * scale,
           middle.y - (metres[0].y - extent.GetCenter().y) * scale}};
}

}  // namespace

std::optional<PoseEdit> DrawPoseBoard(Ui& ui, const std::string& id, const std::string& label, ImU32 colour,
                                      const Skeleton& bones, const std::vector<float>& angles,
                                      const std::vector<float>& present, LimbDrag& drag) {
  const Palette& p = ui.Ink();
  const ImRect rect = ui.Row(kBoardHeight);
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const std::vector<ImVec2> metres = PoseOf(bones, angles);
  const Touch touch = ui.Area(id, rect, Grab::kDrag, {.label = label, .role = "img"});
  if (!touch.held) drag.limb = -1;
  const Picture picture = LayOut(bones, metres, drag, rect);
  const std::vector<ImVec2> points = picture.ToCanvas(metres);
  const float near = ui.Look().touch ? 26.0f : 16.0f;
  if (touch.began) {
    drag.limb = LimbAt(bones, points, ImGui::GetIO().MouseClickedPos[0], near);
    drag.scale = picture.scale;
    drag.origin = picture.origin;
    if (drag.limb > 0)
      drag.grip_rad = GripOf(bones, points, drag.limb, StartOf(bones, points, drag.limb), pointer).grip_rad;
  }

  std::optional<PoseEdit> edit;
  if (touch.held && drag.limb > 0) {
    const auto joint = static_cast<std::size_t>(drag.limb) - 1;
    const Skeleton::Limb& bone = bones.limbs[static_cast<std::size_t>(drag.limb)];
    const float turn =
        TurnToward(bones, points, {drag.limb, drag.grip_rad}, StartOf(bones, points, drag.limb), pointer);
    edit = PoseEdit{static_cast<int>(joint), std::clamp(angles[joint] + turn, bone.min_rad, bone.max_rad)};
    if (std::abs(edit->angle_rad - angles[joint]) < 1e-4f) edit.reset();
  }
  if (!touch.visible) return edit;

  ui.Frame(rect, p.paper, p.line, 9.0f);
  ImDrawList* list = ui.Canvas();
  list->PushClipRect(rect.Min, rect.Max, true);
  const float width = std::clamp(RodWidth(bones, picture.scale), 5.0f, 11.0f);
  const int lit = drag.limb > 0 ? drag.limb : touch.hovered ? LimbAt(bones, points, pointer, near) : -1;
  if (lit > 0) {
    DrawReach(list, bones, points, lit, angles[static_cast<std::size_t>(lit) - 1], Fade(colour, 0.4f));
    if (!ui.Look().touch) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  if (!present.empty()) {
    DrawRods(list, bones, picture.ToCanvas(PoseOf(bones, present)),
             {.rods = Mix(p.paper, p.ink, 0.13f), .width = 0.8f * width});
  }
  DrawRods(list, bones, points, {.rods = colour, .joints = p.panel, .width = width});
  if (lit > 0) {
    DrawCapsule(list, StartOf(bones, points, lit), points[static_cast<std::size_t>(lit) + 1], width,
                Mix(colour, p.ink, 0.45f));
  }
  list->PopClipRect();
  ui.DrawFocus(touch, rect, 9.0f);
  return edit;
}

std::optional<PoseEdit> DrawAngleSliders(Ui& ui, const std::string& id, const Ports& ports,
                                         const std::vector<float>& angles,
                                         const std::vector<ImU32>& colours) {
  const double unit = ports.muscles ? 100.0 : 180.0 / kPi;  // percent, or degrees
  std::optional<PoseEdit> edit;
  for (int joint = 0; joint < ports.Actuators(); ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    const auto [least, most] = ports.actuator_range[j];
    if (most <= least) continue;
    double shown = static_cast<double>(angles[j]) * unit;
    const SliderRange range{
        .low = static_cast<double>(least) * unit, .high = static_cast<double>(most) * unit, .step = 1.0};
    const std::string number = std::to_string(joint + 1);
    std::string name = id;
    name.append("/").append(number);
    const SenseQuantity quantity = ports.muscles ? SenseQuantity::kLength : SenseQuantity::kAngle;
    if (ui.LineSlider(name, ports.muscles ? Tr("Length {1}", number) : Tr("Angle {1}", number), shown, range,
                      QuantityWords(quantity, angles[j]), colours[j]))
      edit = PoseEdit{joint, static_cast<float>(shown / unit)};
  }
  return edit;
}

}  // namespace gaitsmith::shell
