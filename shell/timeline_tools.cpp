// SPDX-License-Identifier: MIT
#include "shell/timeline_tools.h"

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
};

std::vector<Tool> ToolsOf(const Session& session) {
  const bool any = !session.Doc().timeline.empty();
  const bool several = session.Doc().timeline.size() > 1;
  return {
      {"timeline/add", TrLater("Add"), TrLater("Add the selected clip once more at the end"), any,
       &Session::AddClip},
      {"timeline/split", TrLater("Split"), TrLater("Split the clip at the moment shown"), any,
       &Session::SplitClip},
      {"timeline/duplicate", TrLater("Duplicate"), TrLater("Duplicate the selected clip"), any,
       &Session::DuplicateClip},
      {"timeline/mirror", TrLater("Mirror"), TrLater("Mirror the selected clip: it goes the other way"), any,
       &Session::MirrorClip},
      {"timeline/loop", TrLater("Repeat"), TrLater("Repeat the whole timeline"), any, &Session::LoopTimeline},
      {"timeline/repair", TrLater("Repair"),
       TrLater("Repair the selected clip: search from where it takes over"), session.CanRepair(),
       &Session::RepairClip},
      {"timeline/remove", TrLater("Remove"), TrLater("Remove the selected clip"), several,
       &Session::RemoveClip},
  };
}

float WidthOf(const Ui& ui, const Tool& tool) {
  return ui.Letters().Width(Type::kBody, Tr(tool.label)) + (ui.Look().touch ? 28.0f : 18.0f);
}

}  // namespace

float DrawTimelineTools(Ui& ui, Session& session, const ImRect& row, float below) {
  const std::vector<Tool> tools = ToolsOf(session);
  float whole = 0.0f;
  for (const Tool& tool : tools) whole += WidthOf(ui, tool);
  const bool fits = whole <= row.GetWidth();
  const float left = row.Max.x - (fits ? whole : 0.0f);
  const float edge = kPanelPadding;
  ImVec2 at(left, row.Min.y);
  const float height = fits ? row.GetHeight() : ui.Look().ControlHeight();
  const float first = ImGui::GetWindowPos().x + edge;
  if (!fits) at = {first, below};
  const Tool* used = nullptr;
  for (const Tool& tool : tools) {
    const float width = WidthOf(ui, tool) + (fits ? 0.0f : 8.0f);
    if (!fits && at.x + width > row.Max.x) at = {first, at.y + height + 8.0f};
    const ImRect place(at, {at.x + width - (fits ? 0.0f : 8.0f), at.y + height});
    const ButtonLook look = fits ? ButtonLook::kPlain : ButtonLook::kOutlined;
    if (ui.Button(tool.id, place, Tr(tool.label), look, tool.enabled, Tr(tool.heard))) used = &tool;
    at.x += width;
  }
  if (used != nullptr) (session.*used->use)();
  return left;
}

}  // namespace gaitsmith::shell
