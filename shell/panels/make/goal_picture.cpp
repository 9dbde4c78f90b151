// SPDX-License-Identifier: MIT
#include "shell/panels/make/goal_picture.h"

#include <cmath>

#include "shell/stage/figure_thumbnail.h"

namespace gaitsmith::shell {
namespace {

constexpr float kMark = 1.6f;  // thickness of a mark

/// One of several figures side by side. @param place  0 at the left, 1 at the right @param up  above the
/// ground, as a share of the height
struct Copy {
  float place, size, up, turn_rad, ink;
};

}  // namespace

void DrawGoalPicture(Ui& ui, Goal goal, const Figure& figure, const ImRect& rect, const GoalInk& ink) {
  ImDrawList* list = ui.Canvas();
  const float w = rect.GetWidth(), h = rect.GetHeight();
  const auto at = [&](float x, float y) { return ImVec2(rect.Min.x + x * w, rect.Max.y - y * h); };
  const auto draw = [&](const Copy& copy) {
    const float width = copy.size * 0.62f * w, height = copy.size * 0.84f * h;
    const ImVec2 foot = at(copy.place, copy.up);
    DrawFigureThumbnail(ui, figure,
                        {{foot.x - 0.5f * width, foot.y - height}, {foot.x + 0.5f * width, foot.y}},
                        Mix(ink.behind, ink.figure, copy.ink), ink.behind, copy.turn_rad);
  };
  const auto line = [&](ImVec2 from, ImVec2 to) { list->AddLine(from, to, ink.mark, kMark); };
  switch (goal) {
    case Goal::kFar:
      draw({.place = 0.2f, .size = 0.8f, .up = 0.0f, .turn_rad = 0.0f, .ink = 0.25f});
      draw({.place = 0.58f, .size = 0.8f, .up = 0.0f, .turn_rad = 0.0f, .ink = 1.0f});
      line(at(0.92f, 0.0f), at(0.92f, 0.72f));
      list->AddTriangleFilled(at(0.92f, 0.74f), at(1.06f, 0.6f), at(0.92f, 0.46f), ink.mark);
      break;
    case Goal::kHighJump:
      draw({.place = 0.5f, .size = 0.72f, .up = 0.34f, .turn_rad = 0.0f, .ink = 1.0f});
      line(at(0.92f, 0.08f), at(0.92f, 0.86f));
      list->AddTriangleFilled(at(0.92f, 1.0f), at(0.99f, 0.8f), at(0.85f, 0.8f), ink.mark);
      break;
    case Goal::kCartwheel:
      draw({.place = 0.2f, .size = 0.75f, .up = 0.0f, .turn_rad = 0.0f, .ink = 0.25f});
      draw({.place = 0.64f, .size = 0.75f, .up = 0.0f, .turn_rad = -2.1f, .ink = 1.0f});
      list->PathArcTo(at(0.45f, 0.36f), 0.42f * w, -2.5f, -0.75f);
      list->PathStroke(ink.mark, 0, kMark);
      list->AddTriangleFilled(at(0.84f, 0.62f), at(0.68f, 0.76f), at(0.86f, 0.88f), ink.mark);
      break;
    case Goal::kGlide:
      draw({.place = 0.64f, .size = 0.9f, .up = 0.02f, .turn_rad = 0.12f, .ink = 1.0f});
      for (const float y : {0.2f, 0.42f, 0.64f}) line(at(0.02f + 0.2f * y, y), at(0.3f, y));
      list->AddLine(at(0.34f, 0.0f), at(0.98f, 0.0f), ink.mark, 2.0f * kMark);
      break;
    case Goal::kCalm:
      draw({.place = 0.42f, .size = 0.9f, .up = 0.0f, .turn_rad = 0.0f, .ink = 1.0f});
      for (const float y : {0.45f, 0.68f}) {
        constexpr int kPoints = 13;
        for (int i = 0; i < kPoints; ++i) {
          const float t = static_cast<float>(i) / (kPoints - 1);
          list->PathLineTo(at(0.76f + 0.26f * t, y + 0.06f * std::sin(9.4f * t)));
        }
        list->PathStroke(ink.mark, 0, kMark);
      }
      break;
    case Goal::kHeadUp:
      draw({.place = 0.5f, .size = 0.96f, .up = 0.0f, .turn_rad = 0.0f, .ink = 1.0f});
      for (int dash = 0; dash < 5; ++dash) {
        const float x = 0.06f + 0.19f * static_cast<float>(dash);
        line(at(x, 0.94f), at(x + 0.12f, 0.94f));
      }
      break;
  }
  list->AddLine({rect.Min.x, rect.Max.y + 1.0f}, {rect.Max.x, rect.Max.y + 1.0f}, ui.Ink().line, 1.0f);
}

}  // namespace gaitsmith::shell
