// SPDX-License-Identifier: MIT
#include "shell/timeline_tools.h"

#include <algorithm>
#include <vector>

#include "shell/language.h"

namespace gaitsmith::shell {
namespace {

struct Tool {
  const char* id;
  const char* label;
  const char* heard;  // in full
  bool enabled;
  void (Session::*use)();
  int spare;  // where there is no room for all, those with the greatest number go first
};

std::vector<Tool> ToolsOf(const Session& session) {
  const bool any = !session.Doc().timeline.empty();
  const bool several = session.Doc().timeline.size() > 1;
  return {
      {"timeline/add", TrLater("Add"), TrLater("Add the selected clip once more at the end"), any,
       &Session::AddClip, 0},
      {"timeline/split", TrLater("Split"), TrLater("Split the clip at the moment shown"), any,
       &Session::SplitClip, 0},
      {"timeline/duplicate", TrLater("Duplicate"), TrLater("Duplicate the selected clip"), any,
       &Session::DuplicateClip, 3},
      {"timeline/mirror", TrLater("Mirror"), TrLater("Mirror the selected clip: it goes the other way"), any,
       &Session::MirrorClip, 2},
      {"timeline/loop", TrLater("Repeat"), TrLater("Repeat the whole timeline"), any, &Session::LoopTimeline,
       4},
      {"timeline/repair", TrLater("Repair"),
       TrLater("Repair the selected clip: search from where it takes over"), session.CanRepair(),
       &Session::RepairClip, 1},
      {"timeline/remove", TrLater("Remove"), TrLater("Remove the selected clip"), several,
       &Session::RemoveClip, 0},
  };
}

float WidthOf(const Ui& ui, const Tool& tool) {
  return ui.Letters().Width(Type::kBody, Tr(tool.label)) + (ui.Look().touch ? 28.0f : 18.0f);
}

}  // namespace

float DrawTimelineTools(Ui& ui, Session& session, const ImRect& row, float below) {
  std::vector<Tool> tools = ToolsOf(session);
  const auto whole = [&] {
    float width = 0.0f;
    for (const Tool& tool : tools) width += WidthOf(ui, tool);
    return width;
  };
  const float control = ui.Look().ControlHeight();
  const bool room_below = below + control <= ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
  const bool in_row = whole() <= row.GetWidth() || !room_below;
  // The palette has all of them.
  while (in_row && whole() > row.GetWidth() && tools.size() > 1)
    tools.erase(std::ranges::max_element(tools, {}, &Tool::spare));
  const float first = ImGui::GetWindowPos().x + kPanelPadding;
  const float gap = in_row ? 0.0f : 8.0f;
  const float height = in_row ? row.GetHeight() : control;
  const float left = row.Max.x - (in_row ? whole() : 0.0f);
  ImVec2 at = in_row ? ImVec2(left, row.Min.y) : ImVec2(first, below);
  const Tool* used = nullptr;
  for (const Tool& tool : tools) {
    const float width = WidthOf(ui, tool);
    if (!in_row && at.x + width > row.Max.x) at = {first, at.y + height + gap};
    const ButtonLook look = in_row ? ButtonLook::kPlain : ButtonLook::kOutlined;
    if (ui.Button(tool.id, {at, {at.x + width, at.y + height}}, Tr(tool.label), look, tool.enabled,
                  Tr(tool.heard)))
      used = &tool;
    at.x += width + gap;
  }
  if (used != nullptr) (session.*used->use)();
  return left;
}

}  // namespace gaitsmith::shell
