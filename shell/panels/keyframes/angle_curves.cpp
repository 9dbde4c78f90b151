// SPDX-License-Identifier: MIT
#include "shell/panels/keyframes/angle_curves.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"
#include "shell/panels/keyframes/stance_bars.h"
#include "shell/words/language.h"
#include "shell/words/rule_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kPlotHeight = 148.0f;

/// Time to the right over the whole plan, a joint's range from bottom to top.
struct CurveField {
  ImRect rect;
  int steps;
  const Motion& motion;

  [[nodiscard]] const Skeleton::Limb& Limb(int joint) const {
    return motion.Bones().limbs[static_cast<std::size_t>(joint) + 1];
  }
  [[nodiscard]] float X(int step) const {
    return rect.Min.x + static_cast<float>(step) / static_cast<float>(steps) * rect.GetWidth();
  }
  [[nodiscard]] float Y(int joint, float angle_rad) const {
    const float range = std::max(1e-3f, Limb(joint).max_rad - Limb(joint).min_rad);
    return rect.Max.y - std::clamp((angle_rad - Limb(joint).min_rad) / range, 0.0f, 1.0f) * rect.GetHeight();
  }
  [[nodiscard]] float AngleAt(int joint, float y) const {
    const float share = std::clamp((rect.Max.y - y) / rect.GetHeight(), 0.0f, 1.0f);
    return Limb(joint).min_rad + share * (Limb(joint).max_rad - Limb(joint).min_rad);
  }
  [[nodiscard]] int Last() const { return std::min(steps, motion.Frames() - 1); }
};

void DrawCurve(const Ui& ui, const CurveField& field, int joint, bool chosen) {
  constexpr int kPoints = 96;
  std::vector<ImVec2> points;
  points.reserve(kPoints + 1);
  for (int i = 0; i <= kPoints; ++i) {
    const int frame = field.Last() * i / kPoints;
    points.emplace_back(field.X(frame), field.Y(joint, field.motion.AngleRad(frame, joint)));
  }
  const ImU32 colour = ui.Look().Rule(joint);
  ui.Canvas()->AddPolyline(points.data(), static_cast<int>(points.size()),
                           chosen ? colour : Fade(colour, 0.45f), ImDrawFlags_None, chosen ? 2.5f : 1.2f);
}

/// The joint whose curve is nearest to the pointer.
int NearestCurve(const CurveField& field, ImVec2 pointer) {
  const float along = (pointer.x - field.rect.Min.x) / field.rect.GetWidth();
  const int frame = std::clamp(static_cast<int>(along * static_cast<float>(field.steps)), 0, field.Last());
  int nearest = 0;
  float away = 1e9f;
  for (int joint = 0; joint < field.motion.Bones().joints; ++joint) {
    const float gap = std::abs(field.Y(joint, field.motion.AngleRad(frame, joint)) - pointer.y);
    if (gap >= away) continue;
    away = gap;
    nearest = joint;
  }
  return nearest;
}

void DrawAsked(Ui& ui, Session& session, const CurveField& field, int joint) {
  constexpr double kDegrees = 180.0 / kPi;
  const auto keyframes = session.Keyframes().Shown().keyframes;  // a copy, since edits replace it
  const Skeleton::Limb limb = field.Limb(joint);
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    if (keyframes[i].pose_rad.empty()) continue;
    const int index = static_cast<int>(i);
    const float angle = keyframes[i].pose_rad[static_cast<std::size_t>(joint)];
    const ImVec2 at(field.X(keyframes[i].step), field.Y(joint, angle));
    const float half = ui.Look().touch ? 18.0f : 11.0f;
    const ImRect rect({at.x - half, at.y - half}, {at.x + half, at.y + half});
    const Touch touch = ui.Area("keyframes/curve/" + std::to_string(i), rect, Grab::kArrows,
                                {.label = Tr("Angle {1} of keyframe {2}", joint + 1, index + 1),
                                 .role = "slider",
                                 .value = QuantityWords(SenseQuantity::kAngle, angle),
                                 .range = WidgetRange{static_cast<double>(limb.min_rad) * kDegrees,
                                                      static_cast<double>(limb.max_rad) * kDegrees, 1.0,
                                                      static_cast<double>(angle) * kDegrees}});
    if (touch.hovered || touch.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    if (touch.began || touch.pressed || touch.steps != 0) session.Keyframes().Choose(index);
    float wanted = angle + static_cast<float>(touch.steps / kDegrees);
    if (touch.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f))
      wanted = field.AngleAt(joint, ImGui::GetIO().MousePos.y);
    if (touch.wanted) wanted = static_cast<float>(*touch.wanted / kDegrees);
    wanted = std::clamp(wanted, limb.min_rad, limb.max_rad);
    if (std::abs(wanted - angle) > 1e-4f) {
      session.Keyframes().Change(
          [&](Plan& plan) { plan.keyframes[i].pose_rad[static_cast<std::size_t>(joint)] = wanted; });
      return;  // the edit may have replaced the motion
    }
    const bool chosen = session.Keyframes().Chosen() == index;
    DrawDiamond(ui, at, chosen ? ui.Ink().accent : ui.Ink().panel,
                chosen || touch.hovered ? ui.Ink().ink : ui.Ink().second_ink);
    ui.DrawFocus(touch, rect, 4.0f);
  }
}

}  // namespace

void DrawAngleCurves(Ui& ui, Session& session, int& joint) {
  const Motion& motion = session.Comparison().PlannedOrShown().Shown();
  const int joints = motion.Bones().joints;
  if (joints == 0) return;
  joint = std::clamp(joint, 0, joints - 1);
  const ImRect row = ui.Row(kPlotHeight);
  const CurveField field{{{row.Min.x + 14.0f, row.Min.y + 12.0f}, {row.Max.x - 14.0f, row.Max.y - 12.0f}},
                         session.Keyframes().Shown().steps,
                         motion};
  ImGui::SetNextItemAllowOverlap();  // the diamonds lie on top of it
  const Touch touch = ui.Area("keyframes/curves", row, Grab::kArrows,
                              {.label = Tr("Curves of all joints: press one to drag its points"),
                               .role = "slider",
                               .value = Tr("angle {1}", joint + 1),
                               .range = WidgetRange{1.0, static_cast<double>(joints), 1.0, joint + 1.0}});
  if (touch.began) joint = NearestCurve(field, ImGui::GetIO().MouseClickedPos[0]);
  if (touch.steps != 0) joint = std::clamp(joint + touch.steps, 0, joints - 1);
  if (touch.wanted) joint = std::clamp(static_cast<int>(std::lround(*touch.wanted)) - 1, 0, joints - 1);
  ui.Frame(row, ui.Ink().paper, ui.Ink().line, 9.0f);
  for (const bool chosen : {false, true}) {
    for (int each = 0; each < joints; ++each)
      if ((each == joint) == chosen) DrawCurve(ui, field, each, chosen);
  }
  const float now = field.X(std::min(session.Player().Frame(), field.steps));
  ui.Canvas()->AddLine({now, field.rect.Min.y}, {now, field.rect.Max.y}, ui.Ink().ink, 1.5f);
  DrawAsked(ui, session, field, joint);
  ui.DrawFocus(touch, row, 9.0f);
}

}  // namespace gaitsmith::shell
