// SPDX-License-Identifier: MIT
#include "shell/panels/figure/drawing_board.h"

#include <algorithm>
#include <cmath>

#include "shell/panels/figure/figure_edit.h"
#include "shell/stage/figure_drawing.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

struct Board {
  Skeleton skeleton;
  std::vector<ImVec2> metres;  // endpoints
  std::vector<ImVec2> canvas;
  float scale;

  ImVec2 ToMetres(ImVec2 point) const {
    return {metres[0].x + (point.x - canvas[0].x) / scale, metres[0].y - (point.y - canvas[0].y) / scale};
  }
  ImVec2 ToCanvas(ImVec2 point) const {
    return {canvas[0].x + (point.x - metres[0].x) * scale, canvas[0].y - (point.y - metres[0].y) * scale};
  }
};

/// What of the view stays in place.
std::size_t StillOf(const DrawingBoardState& state) {
  return static_cast<std::size_t>(std::max(state.still, 0));
}

// Leaves room to draw around the figure. A blank board is as high as a person.
void Fit(DrawingBoardState& state, const Board& board, ImVec2 size) {
  ImVec2 low = board.metres[0];
  ImVec2 high = low;
  for (const ImVec2& p : board.metres) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  constexpr float kBlankM = 2.0f;
  state.scale = state.blank ? size.y / kBlankM
                            : 0.64f * std::min(size.y / std::max(high.y - low.y, 0.1f),
                                               size.x / std::max(high.x - low.x, 0.1f));
  state.size = size;
  const ImVec2 fixed = board.metres[StillOf(state)];
  state.anchor = {0.5f * size.x + (fixed.x - 0.5f * (low.x + high.x)) * state.scale,
                  0.5f * size.y - (fixed.y - 0.5f * (low.y + high.y)) * state.scale};
}

Board Placed(const Figure& figure, const DrawingBoardState& state, const ImRect& rect) {
  Board board{.skeleton = Skeleton(figure), .metres = {}, .canvas = {}, .scale = state.scale};
  board.metres = PoseOf(board.skeleton, {});
  const ImVec2 fixed = board.metres[StillOf(state)];
  for (const ImVec2& p : board.metres) {
    board.canvas.emplace_back(rect.Min.x + state.anchor.x + (p.x - fixed.x) * board.scale,
                              rect.Min.y + state.anchor.y - (p.y - fixed.y) * board.scale);
  }
  return board;
}

Board LayOut(const Figure& figure, DrawingBoardState& state, const ImRect& rect) {
  constexpr float kEdge = 8.0f;
  Board board = Placed(figure, state, rect);
  const bool resized = state.size.x != rect.GetWidth() || state.size.y != rect.GetHeight();
  const bool outside = std::ranges::any_of(board.canvas, [&](ImVec2 p) {
    return p.x < rect.Min.x + kEdge || p.x > rect.Max.x - kEdge || p.y < rect.Min.y + kEdge ||
           p.y > rect.Max.y - kEdge;
  });
  if (state.scale > 0.0f && !resized && (!outside || state.still >= 0)) return board;
  Fit(state, board, rect.GetSize());
  return Placed(figure, state, rect);
}

/// Makes endpoint 0 the one that stays.
void Settle(DrawingBoardState& state, const Board& board, const ImRect& rect) {
  state.endpoint = state.turning = state.still = DrawingBoardState::kNone;
  state.anchor = {board.canvas[0].x - rect.Min.x, board.canvas[0].y - rect.Min.y};
}

int EndpointAt(const Board& board, ImVec2 pointer, float within) {
  int found = -1;
  for (std::size_t k = 0; k < board.canvas.size(); ++k) {
    const float distance = std::hypot(pointer.x - board.canvas[k].x, pointer.y - board.canvas[k].y);
    if (distance > within) continue;
    within = distance;
    found = static_cast<int>(k);
  }
  return found;
}

int LimbAt(const Board& board, ImVec2 pointer, float within) {
  int found = -1;
  for (int limb = 0; limb < board.skeleton.rods; ++limb) {
    const auto i = static_cast<std::size_t>(limb);
    const ImVec2 a = board.canvas[static_cast<std::size_t>(board.skeleton.limbs[i].start)];
    const ImVec2 b = board.canvas[i + 1];
    const float distance = DistanceToLine(pointer, a, b);
    if (distance > within) continue;
    within = distance;
    found = limb;
  }
  return found;
}

void DrawBoard(Ui& ui, const Board& board, const DrawingBoardState& state, const ImRect& rect) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  // A grid of dots, 0.25 m apart, for scale.
  const float grid = 0.25f * board.scale;
  if (grid > 9.0f) {
    for (float x = board.canvas[0].x - std::floor((board.canvas[0].x - rect.Min.x) / grid) * grid;
         x < rect.Max.x; x += grid) {
      for (float y = board.canvas[0].y - std::floor((board.canvas[0].y - rect.Min.y) / grid) * grid;
           y < rect.Max.y; y += grid) {
        list->AddRectFilled({x - 0.5f, y - 0.5f}, {x + 0.5f, y + 0.5f}, p.line);
      }
    }
  }
  if (state.blank) return;
  const float width = std::clamp(RodWidth(board.skeleton, board.scale), 6.0f, 15.0f);
  DrawRods(list, board.skeleton, board.canvas, {.rods = p.ink, .width = width});
  for (int limb = 0; limb < board.skeleton.rods; ++limb) {
    const auto i = static_cast<std::size_t>(limb);
    if (board.skeleton.limbs[i].drawn != state.rod) continue;
    DrawCapsule(list, board.canvas[static_cast<std::size_t>(board.skeleton.limbs[i].start)],
                board.canvas[i + 1], width, p.accent);
  }
  for (std::size_t k = 0; k < board.canvas.size(); ++k) {
    const bool held = state.endpoint == static_cast<int>(k);
    list->AddCircleFilled(board.canvas[k], held ? 7.0f : 5.5f, p.accent);
    list->AddCircleFilled(board.canvas[k], held ? 5.0f : 3.5f, p.panel);
  }
}

// Begins a drag of the endpoint or, if there is none nearby, of the rod under the pointer.
void Begin(DrawingBoardState& state, const Board& board, ImVec2 pointer, float near, const ImRect& rect) {
  constexpr int kNone = DrawingBoardState::kNone;
  state.endpoint = EndpointAt(board, pointer, near);
  state.turning = kNone;
  if (state.endpoint >= 0) {
    state.rod = board.skeleton.limbs[static_cast<std::size_t>(std::max(0, state.endpoint - 1))].drawn;
    state.still = state.endpoint == 0 ? 1 : 0;
  } else if (const int limb = LimbAt(board, pointer, near); limb >= 0) {
    const auto i = static_cast<std::size_t>(limb);
    const auto start = static_cast<std::size_t>(board.skeleton.limbs[i].start);
    state.turning = limb;
    state.rod = board.skeleton.limbs[i].drawn;
    state.still = static_cast<int>(start);
    state.grip_rad = Direction(board.metres[start], board.ToMetres(pointer)) -
                     Direction(board.metres[start], board.metres[i + 1]);
  } else {
    return;
  }
  const ImVec2 still = board.canvas[static_cast<std::size_t>(state.still)];
  state.anchor = {still.x - rect.Min.x, still.y - rect.Min.y};
}

// The figure after the drag.
Figure Moved(const DrawnFigure& drawn, const DrawingBoardState& state, ImVec2 target) {
  if (state.turning >= 0) {
    const auto start =
        static_cast<std::size_t>(drawn.skeleton.limbs[static_cast<std::size_t>(state.turning)].start);
    const float direction = Direction(drawn.points[start], target) - state.grip_rad;
    return WithLimbTurned(drawn, state.turning, state.snap ? SnappedAngle(direction) : direction);
  }
  const auto still = static_cast<std::size_t>(
      state.endpoint == 0 ? 1 : drawn.skeleton.limbs[static_cast<std::size_t>(state.endpoint) - 1].start);
  return WithEndpointAt(drawn, state.endpoint, state.snap ? Snapped(drawn.points[still], target) : target);
}

}  // namespace

void DrawDrawingBoard(Ui& ui, Session& session, DrawingBoardState& state, const ImRect& rect) {
  const Figure& figure = session.Doc().figure;
  const Touch touch = ui.Area(
      "figure/board", rect, Grab::kDrag,
      {.label = Tr("Drawing board"),
       .role = "img",
       .value = state.blank
                    ? Tr("Nothing is drawn yet.")
                    : Tr("Rod {1} of {2}", std::clamp(state.rod, 0, figure.Rods() - 1) + 1, figure.Rods())});
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const float near = ui.Look().touch ? 26.0f : 15.0f;
  Board board = LayOut(figure, state, rect);
  if (touch.began && state.blank) {
    state.endpoint = state.still = 0;
    state.anchor = {pointer.x - rect.Min.x, pointer.y - rect.Min.y};
    board = LayOut(figure, state, rect);
  } else if (touch.began) {
    Begin(state, board, pointer, near, rect);
  }

  const DrawnFigure drawn{.figure = figure, .skeleton = board.skeleton, .points = board.metres};
  const bool growing = state.endpoint >= 0 && (state.tool == DrawingTool::kGrow || state.blank);
  const bool held = state.endpoint >= 0 || state.turning >= 0;
  // On a phone the board fills the panel: a touch that grabs nothing must still scroll.
  if (touch.held && !held && ui.Look().touch) ImGui::ClearActiveID();
  const auto tip = [&] {
    const ImVec2 target = board.ToMetres(pointer);
    return state.snap ? Snapped(board.metres[static_cast<std::size_t>(state.endpoint)], target) : target;
  };
  if (touch.held && held && !growing && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f)) {
    session.ReplaceFigure(Moved(drawn, state, board.ToMetres(pointer)));
    board = LayOut(session.Doc().figure, state, rect);
  }
  if (!touch.held && held) {
    const ImVec2 from =
        state.endpoint >= 0 ? board.canvas[static_cast<std::size_t>(state.endpoint)] : pointer;
    if (growing && std::hypot(pointer.x - from.x, pointer.y - from.y) > near) {
      Figure grown =
          state.blank ? RodBetween(board.metres[0], tip()) : WithRodFrom(drawn, state.endpoint, tip());
      grown.name = kOwnFigure;
      if (session.ReplaceFigure(grown)) state.rod = session.Doc().figure.Rods() - 1;
      state.blank = false;
      board = Placed(session.Doc().figure, state, rect);
    }
    Settle(state, board, rect);
    board = LayOut(session.Doc().figure, state, rect);
  }
  if (!touch.visible) return;
  ui.Frame(rect, ui.Ink().paper, ui.Ink().line, 9.0f);
  ui.Canvas()->PushClipRect(rect.Min, rect.Max, true);
  DrawBoard(ui, board, state, rect);
  if (touch.held && growing) {
    DrawCapsule(ui.Canvas(), board.canvas[static_cast<std::size_t>(state.endpoint)], board.ToCanvas(tip()),
                7.0f, Fade(ui.Ink().accent, 0.7f));
  }
  ui.Canvas()->PopClipRect();
  ui.DrawFocus(touch, rect, 9.0f);
}

}  // namespace gaitsmith::shell
