// SPDX-License-Identifier: MIT
// Shapes of the icons, in the square [-1, 1]².
#include "shell/widgets/icons.h"

#include <array>
#include <initializer_list>

namespace gaitsmith::shell {
namespace {

class Pen {
 public:
  Pen(ImDrawList* list, ImVec2 centre, float size, ImU32 colour)
      : list_(list), centre_(centre), half_(0.5f * size), colour_(colour) {}

  void Fill(std::initializer_list<ImVec2> corners) {
    for (const ImVec2 corner : corners) list_->PathLineTo(At(corner));
    list_->PathFillConvex(colour_);
  }
  void Stroke(std::initializer_list<ImVec2> points) {
    for (const ImVec2 point : points) list_->PathLineTo(At(point));
    list_->PathStroke(colour_, 0, 0.23f * half_);
  }
  void Bar(ImVec2 low, ImVec2 high) { list_->AddRectFilled(At(low), At(high), colour_, 0.12f * half_); }
  void Arc(float radius, float from, float to) {
    list_->PathArcTo(centre_, radius * half_, from, to);
    list_->PathStroke(colour_, 0, 0.23f * half_);
  }

 private:
  ImVec2 At(ImVec2 p) const { return {centre_.x + p.x * half_, centre_.y + p.y * half_}; }
  ImDrawList* list_;
  ImVec2 centre_;
  float half_;
  ImU32 colour_;
};

}  // namespace

void DrawIcon(ImDrawList* list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
  Pen pen(list, centre, size, colour);
  switch (icon) {
    case Icon::kPlay:
      pen.Fill({{-0.5f, -0.75f}, {0.8f, 0.0f}, {-0.5f, 0.75f}});
      break;
    case Icon::kPause:
      pen.Bar({-0.6f, -0.7f}, {-0.15f, 0.7f});
      pen.Bar({0.15f, -0.7f}, {0.6f, 0.7f});
      break;
    case Icon::kStepForward:
      pen.Fill({{-0.6f, -0.62f}, {0.35f, 0.0f}, {-0.6f, 0.62f}});
      pen.Bar({0.45f, -0.68f}, {0.68f, 0.68f});
      break;
    case Icon::kStepBack:
      pen.Fill({{0.6f, 0.62f}, {-0.35f, 0.0f}, {0.6f, -0.62f}});
      pen.Bar({-0.68f, -0.68f}, {-0.45f, 0.68f});
      break;
    case Icon::kRestart:
      pen.Arc(0.7f, -0.9f, 4.2f);
      pen.Fill({{0.05f, -1.05f}, {0.72f, -0.62f}, {0.1f, -0.15f}});
      break;
    case Icon::kPlus:
      pen.Bar({-0.7f, -0.11f}, {0.7f, 0.11f});
      pen.Bar({-0.11f, -0.7f}, {0.11f, 0.7f});
      break;
    case Icon::kMinus:
      pen.Bar({-0.7f, -0.11f}, {0.7f, 0.11f});
      break;
    case Icon::kClose:
      pen.Stroke({{-0.5f, -0.5f}, {0.5f, 0.5f}});
      pen.Stroke({{0.5f, -0.5f}, {-0.5f, 0.5f}});
      break;
    case Icon::kChevronDown:
      pen.Stroke({{-0.55f, -0.25f}, {0.0f, 0.3f}, {0.55f, -0.25f}});
      break;
    case Icon::kChevronUp:
      pen.Stroke({{-0.55f, 0.25f}, {0.0f, -0.3f}, {0.55f, 0.25f}});
      break;
    case Icon::kCheck:
      pen.Stroke({{-0.6f, 0.05f}, {-0.15f, 0.5f}, {0.65f, -0.5f}});
      break;
    case Icon::kStop:
      pen.Bar({-0.6f, -0.6f}, {0.6f, 0.6f});
      break;
    case Icon::kBookmark:
      pen.Stroke({{0.0f, 0.25f}, {0.5f, 0.7f}, {0.5f, -0.7f}, {-0.5f, -0.7f}, {-0.5f, 0.7f}, {0.0f, 0.25f}});
      break;
    case Icon::kBookmarkFull:
      pen.Fill({{-0.55f, -0.75f}, {0.0f, -0.75f}, {0.0f, 0.25f}, {-0.55f, 0.75f}});
      pen.Fill({{0.0f, -0.75f}, {0.55f, -0.75f}, {0.55f, 0.75f}, {0.0f, 0.25f}});
      break;
    case Icon::kPencil:
      pen.Stroke(
          {{-0.7f, 0.7f}, {-0.55f, 0.2f}, {0.4f, -0.75f}, {0.75f, -0.4f}, {-0.2f, 0.55f}, {-0.7f, 0.7f}});
      break;
    case Icon::kHeart:
    case Icon::kNoHeart:
      pen.Stroke({{0.0f, 0.75f},
                  {-0.65f, 0.1f},
                  {-0.8f, -0.25f},
                  {-0.65f, -0.6f},
                  {-0.35f, -0.68f},
                  {0.0f, -0.35f},
                  {0.35f, -0.68f},
                  {0.65f, -0.6f},
                  {0.8f, -0.25f},
                  {0.65f, 0.1f},
                  {0.0f, 0.75f}});
      if (icon == Icon::kNoHeart) pen.Stroke({{-0.8f, 0.8f}, {0.8f, -0.8f}});
      break;
    case Icon::kSwap:
      pen.Stroke({{-0.8f, -0.35f}, {0.75f, -0.35f}, {0.4f, -0.75f}});
      pen.Stroke({{0.8f, 0.35f}, {-0.75f, 0.35f}, {-0.4f, 0.75f}});
      break;
  }
}

}  // namespace gaitsmith::shell
