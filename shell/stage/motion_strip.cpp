// SPDX-License-Identifier: MIT
#include "shell/stage/motion_strip.h"

#include <algorithm>
#include <cmath>

#include "core/world/ground_view.h"
#include "shell/stage/figure_drawing.h"

namespace gaitsmith::shell {
namespace {

constexpr int kPoses = 61;       // stored for each motion
constexpr int kOfStart = 6;      // poses that may still be the drawn one
constexpr int kDrawn = 6;        // poses drawn side by side
constexpr float kGround = 4.0f;  // height of the ground at the lower edge [points]

MotionStrip StripOf(const Document& document) {
  const Motion motion = Simulate(document);
  const Terrain ground(document.environment.ground);
  const int endpoints = motion.Connections().contacts;
  const int last = motion.Frames() - 1;
  MotionStrip strip{.look = LookOf(document.figure),
                    .poses = {},
                    .extent = {},
                    .leftward = motion.TermsAt(last).travel_m < 0.0f,
                    .highest = 0};
  float highest_m = -1e9f;
  strip.extent = ImRect(1e9f, 0.0f, -1e9f, 0.1f);
  strip.poses.reserve(kPoses);
  for (int i = 0; i < kPoses; ++i) {
    const int frame = last * i / (kPoses - 1);
    // Ends the strip where the motion broke physics.
    if (!std::isfinite(motion.At(frame).y_m) || !std::isfinite(motion.Endpoint(frame, 0).x)) break;
    std::vector<ImVec2> points;
    points.reserve(static_cast<std::size_t>(endpoints));
    // The strip's ground is level: each pose is as high as it is above its own.
    const float height = motion.At(frame).y_m - static_cast<float>(HeightBelow(ground, motion.At(frame).x_m));
    for (int e = 0; e < endpoints; ++e) {
      const Motion::Point point = motion.Endpoint(frame, e);
      const ImVec2 at(point.x, std::clamp(point.y + height, -1.0f, 100.0f));
      strip.extent.Add(at);
      points.push_back(at);
    }
    float sum_m = 0.0f;
    for (const ImVec2& point : points) sum_m += point.y;
    if (i >= kOfStart && sum_m > highest_m) {
      highest_m = sum_m;
      strip.highest = strip.poses.size();
    }
    strip.poses.push_back(std::move(points));
  }
  return strip;
}

}  // namespace

const MotionStrip* MotionStrips::Of(const std::string& name, const std::function<Document()>& document) {
  if (const auto known = strips_.find(name); known != strips_.end()) return &known->second;
  waiting_ = made_;
  if (made_) return nullptr;
  made_ = true;
  if (strips_.size() >= kMax) strips_.clear();
  return &strips_.emplace(name, StripOf(document())).first->second;
}

void DrawMotionStrip(const Ui& ui, const MotionStrip& strip, const ImRect& rect, float share) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  list->AddRectFilled(rect.Min, rect.Max, p.paper, kCornerRadius);
  const float ground = rect.Max.y - kGround;
  list->AddRectFilled({rect.Min.x, ground}, rect.Max, Mix(p.paper, p.ink, 0.12f), kCornerRadius,
                      ImDrawFlags_RoundCornersBottom);
  const float place = rect.GetWidth() / static_cast<float>(kDrawn);
  const float scale = std::min(1.5f * place / std::max(strip.extent.GetWidth(), 0.1f),
                               (ground - rect.Min.y - 5.0f) / std::max(strip.extent.Max.y, 0.1f));
  // Poses are placed in the direction of travel.
  const auto draw = [&](float at, ImU32 colour) {
    const auto pose = static_cast<std::size_t>(std::lround(at * static_cast<float>(strip.poses.size() - 1)));
    const float way = strip.leftward ? 1.0f - at : at;
    const float x = rect.Min.x + place * 0.6f + way * (rect.GetWidth() - 1.2f * place);
    std::vector<ImVec2> points = strip.poses[pose];
    for (ImVec2& point : points)
      point = {x + point.x * scale, ground - (point.y + strip.look.sole_m) * scale};
    DrawBody(list, strip.look, points, scale, {.body = colour, .far = Mix(p.paper, colour, kFarShare)});
  };
  if (strip.poses.empty()) return;
  list->PushClipRect(rect.Min, rect.Max, true);
  const ImU32 past = Mix(p.paper, p.ink, share >= 0.0f ? 0.28f : 0.6f);
  for (int i = 0; i < kDrawn; ++i) draw(static_cast<float>(i) / static_cast<float>(kDrawn - 1), past);
  if (share >= 0.0f) draw(std::min(share, 1.0f), p.accent);
  list->PopClipRect();
}

void DrawMotionPose(const Ui& ui, const MotionStrip& strip, const ImRect& rect, ImU32 behind) {
  if (strip.poses.empty()) return;
  std::vector<ImVec2> points = strip.poses[strip.highest];
  ImRect extent(points[0], points[0]);
  for (const ImVec2& point : points) extent.Add(point);
  extent.Expand(strip.look.middle_m);
  const float scale = std::min(rect.GetWidth() / std::max(extent.GetWidth(), 0.1f),
                               rect.GetHeight() / std::max(extent.GetHeight(), 0.1f));
  const ImVec2 middle = extent.GetCenter();
  for (ImVec2& point : points) {
    point = {rect.GetCenter().x + (point.x - middle.x) * scale,
             rect.GetCenter().y - (point.y - middle.y) * scale};
  }
  const ImU32 ink = Mix(behind, ui.Ink().ink, 0.9f);
  DrawBody(ui.Canvas(), strip.look, points, scale,
           {.body = ink, .far = Mix(behind, ink, kFarShare), .eye = behind});
}

}  // namespace gaitsmith::shell
