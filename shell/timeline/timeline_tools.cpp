// SPDX-License-Identifier: MIT
#include "shell/timeline/timeline_tools.h"

#include <algorithm>
#include <vector>

#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

struct Tool {
  const char* id;
  const char* label;
  const char* accessible_name;  // the label in full
  bool enabled;
  void (TimelineEditor::*use)();
  int spare;  // tools with the greatest number are left out first if space is short
};

std::vector<Tool> ToolsOf(const Session& session) {
  const bool any = !session.Doc().timeline.empty();
  const bool several = session.Doc().timeline.size() > 1;
  std::vector<Tool> tools = {
      {"timeline/add", TrLater("Add"), TrLater("Add the selected clip once more at the end"), any,
       &TimelineEditor::AddClip, 0},
      {"timeline/split", TrLater("Split"), TrLater("Split the clip at the moment shown"), any,
       &TimelineEditor::SplitClip, 0},
      {"timeline/duplicate", TrLater("Duplicate"), TrLater("Duplicate the selected clip"), any,
       &TimelineEditor::DuplicateClip, 3},
      {"timeline/mirror", TrLater("Mirror"), TrLater("Mirror the selected clip: it goes the other way"), any,
       &TimelineEditor::MirrorClip, 2},
      {"timeline/loop", TrLater("Repeat"), TrLater("Repeat the whole timeline"), any, &TimelineEditor::Repeat,
       4},
      {"timeline/repair", TrLater("Repair"),
       TrLater("Repair the selected clip: search from where it takes over"), session.Timeline().CanRepair(),
       &TimelineEditor::RepairClip, 1},
      {"timeline/remove", TrLater("Remove"), TrLater("Remove the selected clip"), several,
       &TimelineEditor::RemoveClip, 0},
  };
  if (session.Timeline().Transitions().Scores().Any()) {
    tools.insert(tools.end() - 1, {"timeline/snap-to-best", TrLater("Snap to best"),
                                   TrLater("Snap to best: move the switch to the nearest good moment"),
                                   session.Timeline().MapComplete(), &TimelineEditor::SnapToBest, 1});
  }
  return tools;
}

float WidthOf(const Ui& ui, const Tool& tool) {
  return ui.Letters().Width(Type::kBody, Tr(tool.label)) + (ui.Look().touch ? 28.0f : 18.0f);
}

/// Positions of tools in rows of this width, from (0, 0) downwards.
std::vector<ImRect> RowsOf(const Ui& ui, const std::vector<Tool>& tools, float width) {
  constexpr float kGap = 8.0f;
  const float height = ui.Look().ControlHeight();
  std::vector<ImRect> places;
  ImVec2 at;
  for (const Tool& tool : tools) {
    const float own = WidthOf(ui, tool);
    if (at.x > 0.0f && at.x + own > width) at = {0.0f, at.y + height + kGap};
    places.push_back({at, {at.x + own, at.y + height}});
    at.x += own + kGap;
  }
  return places;
}

/// Positions of tools in one row, from (0, 0).
std::vector<ImRect> RowOf(const Ui& ui, const std::vector<Tool>& tools, float height) {
  std::vector<ImRect> places;
  float x = 0.0f;
  for (const Tool& tool : tools) {
    const float own = WidthOf(ui, tool);
    places.push_back({{x, 0.0f}, {x + own, height}});
    x += own;
  }
  return places;
}

}  // namespace

float DrawTimelineTools(Ui& ui, Session& session, const ImRect& row, const ImRect& below) {
  std::vector<Tool> tools = ToolsOf(session);
  const bool room_below = ui.Look().ControlHeight() <= below.GetHeight();
  const bool in_row = RowOf(ui, tools, row.GetHeight()).back().Max.x <= row.GetWidth() || !room_below;
  const auto places_of = [&] {
    return in_row ? RowOf(ui, tools, row.GetHeight()) : RowsOf(ui, tools, below.GetWidth());
  };
  const ImVec2 room = in_row ? row.GetSize() : below.GetSize();
  std::vector<ImRect> places = places_of();
  // Tools left out here remain in the command palette.
  while (tools.size() > 1 && (places.back().Max.x > room.x || places.back().Max.y > room.y)) {
    tools.erase(std::ranges::max_element(tools, {}, &Tool::spare));
    places = places_of();
  }
  const ImVec2 at = in_row ? ImVec2(row.Max.x - places.back().Max.x, row.Min.y) : below.Min;
  const Tool* used = nullptr;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    ImRect place = places[i];
    place.Translate(at);
    const ButtonLook look = in_row ? ButtonLook::kPlain : ButtonLook::kOutlined;
    if (ui.Button(tools[i].id, place, Tr(tools[i].label), look, tools[i].enabled,
                  Tr(tools[i].accessible_name)))
      used = &tools[i];
  }
  if (used != nullptr) (session.Timeline().*used->use)();
  return in_row ? at.x : row.Max.x;
}

}  // namespace gaitsmith::shell
