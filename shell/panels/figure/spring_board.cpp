// SPDX-License-Identifier: MIT
#include "shell/panels/figure/spring_board.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "shell/panels/figure/drawing_board.h"
#include "shell/stage/figure_drawing.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr int kNone = SpringBoardState::kNone;
constexpr float kBlankM = 2.0f;  // height of a blank board

struct View {
  const SpringBoardState& state;
  const ImRect& rect;

  [[nodiscard]] ImVec2 ToCanvas(float x_m, float y_m) const {
    return {rect.GetCenter().x + (x_m - state.middle.x) * state.scale,
            rect.GetCenter().y - (y_m - state.middle.y) * state.scale};
  }
  [[nodiscard]] ImVec2 ToMetres(ImVec2 point) const {
    return {state.middle.x + (point.x - rect.GetCenter().x) / state.scale,
            state.middle.y - (point.y - rect.GetCenter().y) / state.scale};
  }
  [[nodiscard]] std::vector<ImVec2> NodesOf(const Figure& figure) const {
    std::vector<ImVec2> points;
    points.reserve(figure.nodes.size());
    for (const Node& node : figure.nodes) points.push_back(ToCanvas(node.x_m, node.y_m));
    return points;
  }
};

/// Leaves room to draw around the figure. Nothing moves under the pen while all of it is inside.
void Fit(const Figure& figure, SpringBoardState& state, const ImRect& rect) {
  constexpr float kInside = 8.0f;
  const bool resized = state.size.x != rect.GetWidth() || state.size.y != rect.GetHeight();
  const auto nodes = View{state, rect}.NodesOf(figure);
  const bool outside = std::ranges::any_of(nodes, [&](ImVec2 p) {
    return p.x < rect.Min.x + kInside || p.x > rect.Max.x - kInside || p.y < rect.Min.y + kInside ||
           p.y > rect.Max.y - kInside;
  });
  if (state.scale > 0.0f && !resized && (!outside || state.pressed || state.blank)) return;
  state.size = rect.GetSize();
  if (state.blank) {
    state.middle = {0.0f, 0.5f * kBlankM};
    state.scale = rect.GetHeight() / kBlankM;
    return;
  }
  const auto [left, right] = std::ranges::minmax(figure.nodes, {}, &Node::x_m);
  const auto [low, high] = std::ranges::minmax(figure.nodes, {}, &Node::y_m);
  state.middle = {0.5f * (left.x_m + right.x_m), 0.5f * (low.y_m + high.y_m)};
  state.scale = 0.64f * std::min(rect.GetHeight() / std::max(high.y_m - low.y_m, 0.1f),
                                 rect.GetWidth() / std::max(right.x_m - left.x_m, 0.1f));
}

int NodeAt(const std::vector<ImVec2>& nodes, ImVec2 pointer, float within) {
  int found = kNone;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const float distance = std::hypot(pointer.x - nodes[k].x, pointer.y - nodes[k].y);
    if (distance > within) continue;
    within = distance;
    found = static_cast<int>(k);
  }
  return found;
}

int SpringAt(const Figure& figure, const std::vector<ImVec2>& nodes, ImVec2 pointer, float within) {
  int found = kNone;
  for (std::size_t i = 0; i < figure.springs.size(); ++i) {
    const ImVec2 a = nodes[static_cast<std::size_t>(figure.springs[i].from)];
    const ImVec2 b = nodes[static_cast<std::size_t>(figure.springs[i].to)];
    const float distance = DistanceToLine(pointer, a, b);
    if (distance > within) continue;
    within = distance;
    found = static_cast<int>(i);
  }
  return found;
}

void DrawGrid(Ui& ui, const View& view) {
  // Dots, 0.25 m apart, for scale.
  const float grid = 0.25f * view.state.scale;
  if (grid <= 9.0f) return;
  const ImVec2 origin = view.ToCanvas(0.0f, 0.0f);
  const ImRect& rect = view.rect;
  for (float x = origin.x - std::floor((origin.x - rect.Min.x) / grid) * grid; x < rect.Max.x; x += grid) {
    for (float y = origin.y - std::floor((origin.y - rect.Min.y) / grid) * grid; y < rect.Max.y; y += grid)
      ui.Canvas()->AddRectFilled({x - 0.5f, y - 0.5f}, {x + 0.5f, y + 0.5f}, ui.Ink().line);
  }
}

void DrawMirror(Ui& ui, const View& view) {
  const float x = view.ToCanvas(view.state.mirror_m, 0.0f).x;
  for (float y = view.rect.Min.y; y < view.rect.Max.y; y += 9.0f)
    ui.Canvas()->AddLine({x, y}, {x, y + 4.5f}, Fade(ui.Ink().accent, 0.6f), 1.5f);
}

void DrawFigure(Ui& ui, const Figure& figure, const View& view, const std::vector<ImVec2>& nodes) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  DrawBody(list, LookOf(figure), nodes, view.state.scale, {.body = p.ink, .far = Mix(p.paper, p.ink, 0.45f)});
  const SpringPart& chosen = view.state.chosen;
  if (chosen.kind == SpringPart::Kind::kSpring) {
    const Spring& spring = figure.springs[static_cast<std::size_t>(chosen.index)];
    DrawCapsule(list, nodes[static_cast<std::size_t>(spring.from)],
                nodes[static_cast<std::size_t>(spring.to)], 5.0f, p.accent);
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const bool marked = view.state.held == static_cast<int>(k) ||
                        chosen == SpringPart{SpringPart::Kind::kNode, static_cast<int>(k)};
    list->AddCircleFilled(nodes[k], marked ? 8.0f : 5.5f, p.accent);
    list->AddCircleFilled(nodes[k], marked ? 4.0f : 3.5f, marked ? p.accent : p.panel);
  }
}

std::string ValueOf(const Figure& figure, const SpringBoardState& state) {
  if (state.blank) return Tr("Nothing is drawn yet.");
  if (state.chosen.kind == SpringPart::Kind::kNode)
    return Tr("Node {1} of {2}", state.chosen.index + 1, static_cast<int>(figure.nodes.size()));
  const bool muscle = figure.springs[static_cast<std::size_t>(state.chosen.index)].IsMuscle();
  return Tr(muscle ? "Spring {1} of {2}, a muscle" : "Spring {1} of {2}", state.chosen.index + 1,
            static_cast<int>(figure.springs.size()));
}

struct Stroke {
  Session& session;
  SpringBoardState& state;
  const View& view;
  const std::vector<ImVec2>& nodes;
  float near;

  [[nodiscard]] const Figure& Now() const { return session.Doc().figure; }
  bool Replace(Figure figure) const {
    figure.name = kOwnFigure;
    return session.ReplaceFigure(figure);
  }
  void Choose(SpringPart::Kind kind, int index) const { state.chosen = {kind, index}; }

  void Tap(ImVec2 pointer) const {
    if (state.held >= 0) return Choose(SpringPart::Kind::kNode, state.held);
    if (const int spring = SpringAt(Now(), nodes, pointer, 0.7f * near); spring >= 0) {
      Choose(SpringPart::Kind::kSpring, spring);
      if (state.tool == SpringTool::kDraw) Replace(WithMuscleToggled(Now(), spring, state.MirrorNow()));
    } else if (state.tool == SpringTool::kDraw) {
      const auto before = static_cast<int>(Now().nodes.size());
      if (Replace(WithNodeAt(Now(), view.ToMetres(pointer), state.MirrorNow())))
        Choose(SpringPart::Kind::kNode, before);
    }
  }
  void Drag(ImVec2 pointer) const {
    if (state.tool == SpringTool::kMove || state.held < 0) return;
    const int to = NodeAt(nodes, pointer, near);
    const auto nodes_before = static_cast<int>(Now().nodes.size());
    const auto springs_before = static_cast<int>(Now().springs.size());
    if (to == state.held) return;
    if (to >= 0) {
      if (Replace(WithSpring(Now(), state.held, to, state.MirrorNow())) &&
          static_cast<int>(Now().springs.size()) > springs_before)
        Choose(SpringPart::Kind::kSpring, springs_before);
    } else if (Replace(WithNodeFrom(Now(), state.held, view.ToMetres(pointer), state.MirrorNow()))) {
      Choose(SpringPart::Kind::kNode, nodes_before);
    }
  }
  void First(ImVec2 from, ImVec2 to) const {
    if (std::hypot(to.x - from.x, to.y - from.y) <= near) return;
    if (Replace(SpringBetween(view.ToMetres(from), view.ToMetres(to)))) state.blank = false;
    Choose(SpringPart::Kind::kNode, 1);
  }
};

}  // namespace

void KeepChosen(const Figure& figure, SpringBoardState& state) {
  const bool node = state.chosen.kind == SpringPart::Kind::kNode;
  const auto count = static_cast<int>(node ? figure.nodes.size() : figure.springs.size());
  state.chosen.index = std::clamp(state.chosen.index, 0, count - 1);
}

void DrawSpringBoard(Ui& ui, Session& session, SpringBoardState& state, const ImRect& rect) {
  KeepChosen(session.Doc().figure, state);
  const Touch touch =
      ui.Area("figure/springs", rect, Grab::kDrag,
              {.label = Tr("Drawing board"), .role = "img", .value = ValueOf(session.Doc().figure, state)});
  const ImVec2 pointer = ImGui::GetIO().MousePos, began = ImGui::GetIO().MouseClickedPos[0];
  const float near = ui.Look().touch ? 26.0f : 15.0f;
  Fit(session.Doc().figure, state, rect);
  const View view{state, rect};
  std::vector<ImVec2> nodes = view.NodesOf(session.Doc().figure);
  if (!state.pressed) state.mirror_m = MiddleOf(session.Doc().figure);
  if (touch.began) {
    state.pressed = true;
    state.held = state.blank ? kNone : NodeAt(nodes, began, near);
  }
  const bool dragged = ImGui::IsMouseDragPastThreshold(ImGuiMouseButton_Left, ui.Look().touch ? 8.0f : 4.0f);
  const Stroke stroke{session, state, view, nodes, near};
  if (touch.held && state.held >= 0 && state.tool == SpringTool::kMove && dragged) {
    stroke.Replace(
        WithNodeMoved(session.Doc().figure, state.held, view.ToMetres(pointer), state.MirrorNow()));
    state.chosen = {SpringPart::Kind::kNode, state.held};
    nodes = view.NodesOf(session.Doc().figure);
  }
  // On a phone the board fills the panel: a touch that grabs nothing must still scroll.
  if (touch.held && dragged && state.held < 0 && !state.blank && ui.Look().touch) {
    ImGui::ClearActiveID();
    state.pressed = false;
  }
  if (state.pressed && !touch.held) {
    const bool inside = rect.Contains(pointer);
    const bool far = std::hypot(pointer.x - began.x, pointer.y - began.y) > (ui.Look().touch ? 12.0f : 6.0f);
    if (inside && state.blank) {
      stroke.First(began, pointer);
    } else if (inside && far) {
      stroke.Drag(pointer);
    } else if (inside) {
      stroke.Tap(began);
    }
    state.pressed = false;
    state.held = kNone;
    KeepChosen(session.Doc().figure, state);
    Fit(session.Doc().figure, state, rect);
    nodes = view.NodesOf(session.Doc().figure);
  }
  if (!touch.visible) return;
  ui.Frame(rect, ui.Ink().paper, ui.Ink().line, 9.0f);
  ui.Canvas()->PushClipRect(rect.Min, rect.Max, true);
  DrawGrid(ui, view);
  if (state.symmetric && !state.blank) DrawMirror(ui, view);
  if (!state.blank) DrawFigure(ui, session.Doc().figure, view, nodes);
  const bool draws = state.pressed && dragged && state.tool == SpringTool::kDraw;
  if (draws && (state.held >= 0 || state.blank)) {
    const ImVec2 from = state.blank ? began : nodes[static_cast<std::size_t>(state.held)];
    DrawCapsule(ui.Canvas(), from, pointer, 5.0f, Fade(ui.Ink().accent, 0.7f));
  }
  ui.Canvas()->PopClipRect();
  ui.DrawFocus(touch, rect, 9.0f);
}

}  // namespace gaitsmith::shell
