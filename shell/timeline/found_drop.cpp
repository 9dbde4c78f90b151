// SPDX-License-Identifier: MIT
#include "shell/timeline/found_drop.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith::shell {
namespace {

constexpr const char* kPayload = "found motion";
constexpr float kNearPixels = 9.0f;

/// The step at which to insert: the nearby shown moment, border or half second if any, else the pointer's
/// step.
int StepMeant(const Session& session, const ImRect& band, float x) {
  const Document& d = session.Doc();
  const auto steps = static_cast<float>(std::max(1, d.duration_steps));
  const float share = std::clamp((x - band.Min.x) / std::max(band.GetWidth(), 1.0f), 0.0f, 1.0f);
  const auto step = static_cast<int>(std::lround(share * steps));
  const float reach = kNearPixels * steps / std::max(band.GetWidth(), 1.0f);
  int meant = static_cast<int>(std::lround(static_cast<float>(step) / 50.0f)) * 50;
  if (std::abs(static_cast<float>(meant - step)) > 0.5f * reach) meant = step;
  for (std::size_t i = 0; i <= d.timeline.size(); ++i) {
    const int border = i < d.timeline.size() ? d.timeline[i].start_step : d.duration_steps;
    if (std::abs(static_cast<float>(border - step)) < reach) meant = border;
  }
  const int now = session.Player().Frame();
  if (std::abs(static_cast<float>(now - step)) < reach) meant = now;
  return std::clamp(meant, 0, d.duration_steps);
}

}  // namespace

void OfferFound(const Ui& ui, const std::string& id, const std::string& name) {
  // A finger scrolls the list instead of dragging. The + button on the card inserts the motion.
  if (ui.Look().touch || ImGui::GetIO().MouseSource == ImGuiMouseSource_TouchScreen) return;
  if (!ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoPreviewTooltip)) return;
  ImGui::SetDragDropPayload(kPayload, id.c_str(), id.size() + 1);
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const ImVec2 at = ImGui::GetIO().MousePos;
  const float width = std::min(220.0f, ui.Letters().Width(Type::kStrong, name) + 18.0f);
  ImDrawList* over = ImGui::GetForegroundDrawList();
  over->AddRectFilled({at.x + 12.0f, at.y + 8.0f}, {at.x + 12.0f + width, at.y + 34.0f}, ui.Ink().accent,
                      kCornerRadius);
  ui.Letters().DrawElided(over, Type::kStrong, {at.x + 21.0f, at.y + 21.0f}, width - 18.0f,
                          ui.Ink().accent_ink, name);
  ImGui::EndDragDropSource();
}

void TakeFound(const Ui& ui, Session& session, const ImRect& band) {
  ImRect reach = band;
  reach.Expand(ImVec2(kPanelPadding, 16.0f));
  if (!ImGui::BeginDragDropTargetCustom(reach, ImGui::GetID("timeline/drop"))) return;
  const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(
      kPayload, ImGuiDragDropFlags_AcceptBeforeDelivery | ImGuiDragDropFlags_AcceptNoDrawDefaultRect);
  if (payload != nullptr) {
    const Document& d = session.Doc();
    const int step = d.timeline.empty() ? 0 : StepMeant(session, band, ImGui::GetIO().MousePos.x);
    const float x = band.Min.x + static_cast<float>(step) /
                                     static_cast<float>(std::max(1, d.duration_steps)) * band.GetWidth();
    ui.Canvas()->AddRectFilled({x - 2.0f, band.Min.y - 5.0f}, {x + 2.0f, band.Max.y + 5.0f}, ui.Ink().accent,
                               2.0f);
    if (payload->IsDelivery()) session.Timeline().InsertFound(static_cast<const char*>(payload->Data), step);
  }
  ImGui::EndDragDropTarget();
}

}  // namespace gaitsmith::shell
