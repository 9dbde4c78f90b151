// SPDX-License-Identifier: MIT
#include "shell/widgets/tooltip.h"

#include <algorithm>

#include "shell/words/hints.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr double kDelayS = 0.5;
constexpr float kMaxWidth = 300.0f;
constexpr float kPad = 12.0f, kLine = 18.0f;
constexpr float kEdge = 8.0f;   // least distance to the control and to the window's edges
constexpr float kSlack = 8.0f;  // of a finger that stays

bool ByFinger() { return ImGui::GetIO().MouseSource == ImGuiMouseSource_TouchScreen; }

// The stage has none: it would cover the motion. A finger that rests on a board is about to draw.
bool HasTooltip(const Widget& widget) {
  return widget.id != "stage" && widget.role != "textbox" && !(ByFinger() && widget.role == "img");
}

ImRect PlaceBeside(const ImRect& control, ImVec2 size) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float x =
      std::clamp(control.GetCenter().x - 0.5f * size.x, kEdge, std::max(kEdge, window.x - kEdge - size.x));
  const float above = control.Min.y - kEdge - size.y, below = control.Max.y + kEdge;
  const float y = above >= kEdge || below + size.y > window.y - kEdge ? std::max(kEdge, above) : below;
  return {{x, y}, {x + size.x, y + size.y}};
}

}  // namespace

const Widget* Tooltip::Chosen(const WidgetRegistry& registry) const {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  ImRect near = rect_;
  near.Expand(kEdge);
  // It stays while the pointer is on it, to be read with a magnifier. A finger's stays when the finger
  // leaves.
  const bool stays = shown_ && (ByFinger() ? !g.IO.MouseDown[0] : near.Contains(g.IO.MousePos));
  if (!g.NavDisableMouseHover && stays) return registry.Find(id_);
  const bool points = ByFinger() ? g.IO.MouseDown[0] : !g.NavDisableMouseHover;
  const Widget* pointed = points ? registry.Pointed() : nullptr;
  return pointed == nullptr && !g.NavDisableHighlight ? registry.Focused() : pointed;
}

void Tooltip::Draw(Ui& ui, WidgetRegistry& registry) {
  const ImGuiIO& io = ImGui::GetIO();
  const Widget* widget = Chosen(registry);
  const bool any = widget != nullptr && HasTooltip(*widget);
  const std::string hint = any ? Fill(HintFor(*widget), {widget->label, widget->value}) : "";
  const std::string id = hint.empty() ? "" : widget->id;
  if (id != id_ || (ByFinger() && io.MouseClicked[0])) {
    id_ = id;
    waited_s_ = 0.0;
    shown_ = hidden_ = false;
  }
  const bool dragged = ByFinger() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, kSlack);
  if (!shown_ && dragged) hidden_ = true;
  if (!ByFinger() && io.MouseDown[0]) {
    hidden_ = true;
    shown_ = false;
  }
  if (!shown_ || id_.empty()) return;
  if (ByFinger() && io.MouseDown[0]) ImGui::ClearActiveID();  // to lift the finger presses nothing

  std::string_view rest = hint;
  std::vector<std::string_view> lines;
  float width = 0.0f;
  const float room = std::min(kMaxWidth, io.DisplaySize.x - 2.0f * (kEdge + kPad));
  while (!rest.empty()) {
    const std::size_t length = std::max<std::size_t>(1, ui.Letters().FitLine(Type::kBody, rest, room));
    lines.push_back(rest.substr(0, length));
    width = std::max(width, ui.Letters().Width(Type::kBody, lines.back()));
    rest.remove_prefix(length);
    while (rest.starts_with(' ')) rest.remove_prefix(1);
  }
  rect_ = PlaceBeside(widget->rect,
                      {width + 2.0f * kPad, kLine * static_cast<float>(lines.size()) + 1.5f * kPad});
  ImDrawList* list = ImGui::GetForegroundDrawList();
  list->_FringeScale = 1.0f / ui.Look().density;
  list->AddRectFilled(rect_.Min, rect_.Max, ui.Ink().ink, kCornerRadius);
  float y = rect_.Min.y + 0.75f * kPad + 0.5f * kLine;
  for (const std::string_view line : lines) {
    ui.Letters().Draw(list, Type::kBody, {rect_.Min.x + kPad, y}, ui.Ink().panel, line);
    y += kLine;
  }
  registry.DescribeText("tooltip", hint, rect_);
}

bool Tooltip::Advance(double seconds) {
  if (id_.empty() || shown_ || hidden_) return false;
  waited_s_ += seconds;
  shown_ = waited_s_ >= kDelayS;
  return shown_;
}

bool Tooltip::Hide() {
  if (!shown_) return false;
  shown_ = false;
  hidden_ = true;
  return true;
}

}  // namespace gaitsmith::shell
