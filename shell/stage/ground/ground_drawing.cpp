// SPDX-License-Identifier: MIT
#include "shell/stage/ground/ground_drawing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/world/ground_view.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

namespace {

constexpr int kTicksInReach = 120;  // on three stage widths: a tilted stage may show ground on either side

// The surface from left to right.
std::vector<ImVec2> SurfaceOf(const Camera& camera, const Terrain& terrain, double left_m, double right_m) {
  const auto height = [&](double x_m) { return static_cast<float>(HeightBelow(terrain, x_m)); };
  std::vector<ImVec2> surface = {camera.ToScreen(left_m, height(left_m))};
  for (const Terrain::Face& face : terrain.FacesBetween(left_m, right_m)) {
    if (face.x > left_m) surface.push_back(camera.ToScreen(face.x, static_cast<float>(face.y)));
  }
  surface.push_back(camera.ToScreen(right_m, height(right_m)));
  return surface;
}

// Piece by piece, because the whole is not convex. Without soft edges, which would show between the pieces;
// the line on top covers the outer ones.
void FillBelow(ImDrawList* list, const Camera& camera, const std::vector<ImVec2>& surface, float depth,
               ImU32 colour) {
  const ImVec2 down(depth * camera.sine, depth * camera.cosine);
  const ImDrawListFlags flags = list->Flags;
  list->Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (std::size_t i = 0; i + 1 < surface.size(); ++i) {
    const ImVec2 &a = surface[i], &b = surface[i + 1];
    const ImVec2 piece[] = {a, b, {b.x + down.x, b.y + down.y}, {a.x + down.x, a.y + down.y}};
    list->AddConvexPolyFilled(piece, 4, colour);
  }
  list->Flags = flags;
}

}  // namespace

ImVec2 BelowGround(const Camera& camera, const Terrain& terrain, double x_m, float half_width, float depth) {
  const double half_m = static_cast<double>(half_width / camera.scale);
  const double low_m = LowestBetween(terrain, x_m - half_m, x_m + half_m);
  const ImVec2 at = camera.ToScreen(x_m, static_cast<float>(low_m));
  return {at.x + depth * camera.sine, at.y + depth * camera.cosine};
}

ImU32 GroundColour(const Palette& p) {
  return Mix(p.paper, p.ground, ImGui::ColorConvertU32ToFloat4(p.ground).w);
}

void DrawGround(Ui& ui, const ImRect& rect, const Camera& camera, const Terrain& terrain, float texts_until) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  const double width_m = static_cast<double>(rect.GetWidth() / camera.scale);
  const double first = camera.left_m - width_m;
  const double last = camera.left_m + 2.0 * width_m;
  const std::vector<ImVec2> surface = SurfaceOf(camera, terrain, first, last);
  if (terrain.Level() && camera.sine == 0.0f) {
    if (camera.origin.y < rect.Max.y)
      ui.Behind().Fill({{rect.Min.x, camera.origin.y}, rect.Max}, GroundColour(p));
  } else {
    FillBelow(list, camera, surface, 4.0f * (rect.GetWidth() + rect.GetHeight()), GroundColour(p));
  }

  // A tick every metre, or every 2, 5, 10 … metres if ticks would be crowded. The loop counts ticks, since
  // far away one metre may be less than the floating-point precision.
  const auto label_of = [](double metres) { return Fixed(metres, 0) + " m"; };
  const float label_width = ui.Letters().Width(Type::kSmall, label_of(std::min(first, -last)));
  const double crowded_m = static_cast<double>(std::max(44.0f, label_width + 8.0f) / camera.scale);
  const double least_m = std::max(crowded_m, (last - first) / kTicksInReach);
  double spacing = 1.0;
  for (int grow = 0; spacing < least_m; ++grow) spacing *= grow % 3 == 1 ? 2.5 : 2.0;
  const double first_tick = std::ceil(first / spacing) * spacing;
  for (int tick = 0; tick <= kTicksInReach; ++tick) {
    const double metres = first_tick + tick * spacing;
    const ImVec2 at = camera.ToScreen(metres, static_cast<float>(HeightBelow(terrain, metres)));
    if (at.x < rect.Min.x - 30.0f || at.x > rect.Max.x + 30.0f) continue;
    const ImVec2 foot(at.x + 7.0f * camera.sine, at.y + 7.0f * camera.cosine);
    list->AddLine(at, foot, p.second_ink);
    const std::string label = label_of(metres);
    // A label that is cut off could be misread: "−1 m" as "1 m".
    const float half = 0.5f * ui.Letters().Width(Type::kSmall, label) + 2.0f;
    const ImVec2 text = BelowGround(camera, terrain, metres, half, 19.0f);
    if (text.x - half < rect.Min.x || text.x + half > rect.Max.x) continue;
    if (text.y + 8.0f > texts_until && !terrain.Level()) continue;
    ui.Letters().Draw(list, Type::kSmall, text, p.second_ink, label, Align::kCentre);
  }
  list->AddPolyline(surface.data(), static_cast<int>(surface.size()), p.second_ink, 0, 1.5f);
}

}  // namespace gaitsmith::shell
