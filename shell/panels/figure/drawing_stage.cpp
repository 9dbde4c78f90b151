// SPDX-License-Identifier: MIT
#include "shell/panels/figure/drawing_stage.h"

#include <algorithm>
#include <array>

#include "core/physics/figure.h"
#include "shell/panels/figure/figure_edit.h"
#include "shell/panels/figure/spring_form.h"
#include "shell/stage/invitation.h"
#include "shell/words/figure_words.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr float kSideRoom = 16.0f;
constexpr float kGapRoom = 8.0f;
constexpr float kWideRow = 620.0f;  // the tools and the large button fit into one row

const char* WhatToDo(const FigurePanelState& state, const Figure& figure) {
  const bool springs = figure.HasSprings();
  const DrawingBoardState& board = state.board;
  if (springs) return SpringToolWords(figure, state.springs);
  if (board.blank) return Tr("Drag across the board: that is the first rod.");
  return Tr(board.tool == DrawingTool::kMove
                ? "Drag a joint or a tip to change a rod. Drag a rod to rotate it and everything attached."
                : "Drag from a joint or a tip to add a rod there.");
}

ImRect Quarter(const ImRect& row, int column) {
  const float width = (row.GetWidth() - 3.0f * kGapRoom) / 4.0f;
  const float left = row.Min.x + static_cast<float>(column) * (width + kGapRoom);
  return {left, row.Min.y, left + width, row.Max.y};
}

// Buttons side by side for what can be done with the chosen rod.
void DrawRodButtons(Ui& ui, Session& session, DrawingBoardState& board, const ImRect& row) {
  const Figure& figure = session.Doc().figure;
  board.rod = std::clamp(board.rod, 0, figure.Rods() - 1);
  const bool limb = !board.blank && figure.rods[static_cast<std::size_t>(board.rod)].parent != kNoParent;
  const bool room = figure.Rods() < kMaxRods;
  int column = 0;
  const auto button = [&](const char* id, const char* label, bool enabled) {
    return ui.Button(id, Quarter(row, column++), label, ButtonLook::kOutlined, enabled);
  };
  const auto replace = [&](Figure next, int selected) {
    next.name = kOwnFigure;
    if (session.ReplaceFigure(next)) board.rod = selected;
  };
  const bool grow = button("draw/grow", Tr("Add a rod"), room);
  const bool copy = button("draw/copy", Tr("Copy limb"), limb && room);
  const bool mirror = button("draw/mirror", Tr("Mirror all"), !board.blank);
  const bool remove = button("draw/delete", Tr("Delete limb"), limb);
  if (grow && !board.blank) replace(WithRodGrown(figure, board.rod), figure.Rods());
  if (grow) board.blank = false;  // the first rod stands upright
  if (copy) replace(WithLimbCopied(figure, board.rod), figure.Rods());
  if (mirror) replace(Mirrored(figure), board.rod);
  if (remove) {
    const int parent = figure.rods[static_cast<std::size_t>(board.rod)].parent;
    replace(WithoutRod(figure, board.rod), parent);
  }
}

// A button that stays down.
Touch DrawSwitchChip(Ui& ui, const char* id, const ImRect& rect, const char* label, bool on) {
  const Touch touch =
      ui.Area(id, rect, Grab::kPress,
              {.label = label, .role = "switch", .value = Tr(on ? "on" : "off"), .state = {.checked = on}});
  const Palette& p = ui.Ink();
  ui.Frame(rect,
           on              ? Mix(p.panel, p.accent, 0.14f)
           : touch.hovered ? Mix(p.panel, p.ink, 0.04f)
                           : p.panel,
           on ? p.accent : p.line);
  ui.Letters().DrawElided(
      ui.Canvas(), Type::kBody,
      {rect.GetCenter().x - 0.5f * std::min(ui.Letters().Width(Type::kBody, label), rect.GetWidth() - 12.0f),
       rect.GetCenter().y},
      rect.GetWidth() - 12.0f, on ? p.accent : p.ink, label);
  ui.DrawFocus(touch, rect);
  return touch;
}

// The same for springs: what is chosen, and the whole figure.
void DrawSpringButtons(Ui& ui, Session& session, SpringBoardState& board, const ImRect& row) {
  const Figure& figure = session.Doc().figure;
  KeepChosen(figure, board);
  int column = 1;
  const auto button = [&](const char* id, const char* label, bool enabled) {
    return ui.Button(id, Quarter(row, column++), label, ButtonLook::kOutlined, enabled);
  };
  const auto replace = [&](Figure next) {
    next.name = kOwnFigure;
    session.ReplaceFigure(next);
  };
  const Figure rest = board.blank ? figure : Without(figure, board.chosen, board.MirrorOf(figure));
  const Touch symmetric =
      DrawSwitchChip(ui, "draw/symmetric", Quarter(row, 0), Tr("Both sides"), board.symmetric);
  const bool softer = button("draw/softer", Tr("Softer"), !board.blank);
  const bool stiffer = button("draw/stiffer", Tr("Stiffer"), !board.blank);
  const bool remove = button("draw/remove", Tr("Delete"), !board.blank && !rest.springs.empty());
  if (symmetric.pressed) board.symmetric = !board.symmetric;
  if (softer) replace(WithStiffness(figure, 0.5f));
  if (stiffer) replace(WithStiffness(figure, 2.0f));
  if (remove) {
    replace(rest);
    board.chosen.index = 0;
  }
}

// A blank board asks of what the figure is to be made; the others have tools.
void DrawTools(Ui& ui, Session& session, FigurePanelState& state, const ImRect& rect) {
  static constexpr std::array<const char*, 2> kMadeOf = {TrLater("Rods"), TrLater("Springs")};
  static constexpr std::array<const char*, 2> kRodTools = {TrLater("Move"), TrLater("Add a rod")};
  static constexpr std::array<const char*, 2> kSpringTools = {TrLater("Draw"), TrLater("Move")};
  const bool springs = session.Doc().figure.HasSprings();
  if (springs ? state.springs.blank : state.board.blank) {
    int made_of = springs ? 1 : 0;
    if (ui.Segmented("draw/made-of", rect, Tr("What the figure is made of"), kMadeOf, made_of))
      DrawOwnFigure(session, state, made_of == 1 ? OwnFigure::kSprings : OwnFigure::kRods, true);
    return;
  }
  int tool = springs ? static_cast<int>(state.springs.tool) : static_cast<int>(state.board.tool);
  if (!ui.Segmented(springs ? "draw/springs-tool" : "draw/tool", rect, Tr("Tool of the drawing board"),
                    springs ? kSpringTools : kRodTools, tool))
    return;
  if (springs) {
    state.springs.tool = static_cast<SpringTool>(tool);
  } else {
    state.board.tool = static_cast<DrawingTool>(tool);
  }
}

}  // namespace

bool DrawsOnStage(const Session& session, const FigurePanelState& state) {
  return state.on_stage && Invites(session) && session.Doc().figure.name == kOwnFigure;
}

void DrawDrawingStage(Ui& ui, Session& session, FigurePanelState& state, const ImRect& stage) {
  const PartScope part = ui.Part("stage", "region", Tr("Stage"));
  const bool wide = stage.GetWidth() >= kWideRow;
  const float high = ui.Look().touch ? 46.0f : 40.0f;
  const ImRect inside({stage.Min.x + kSideRoom, stage.Min.y}, {stage.Max.x - kSideRoom, stage.Max.y});
  ui.Behind().Fill(stage, ui.Ink().panel);

  const float tools_width = std::min(220.0f, inside.GetWidth() - 90.0f);
  const float top = stage.Min.y + 8.0f;
  DrawTools(ui, session, state, {{inside.Min.x, top}, {inside.Min.x + tools_width, top + high}});
  const bool springs = session.Doc().figure.HasSprings();
  if (ui.Button("draw/close", {{inside.Max.x - 82.0f, top}, {inside.Max.x, top + high}}, Tr("Done")))
    state.on_stage = false;

  const char* what = WhatToDo(state, session.Doc().figure);
  const float line = top + high + 16.0f;
  ui.Letters().DrawElided(ui.Canvas(), Type::kBody, {inside.Min.x, line}, inside.GetWidth(),
                          ui.Ink().second_ink, what);
  ui.DescribeText(what, {{inside.Min.x, line - 9.0f}, {inside.Max.x, line + 9.0f}});

  const float large = wide ? high : 54.0f;
  const float teach_top = stage.Max.y - 10.0f - large;
  const float rod_top = wide ? teach_top : teach_top - kGapRoom - high;
  const ImRect board({inside.Min.x, line + 16.0f}, {inside.Max.x, rod_top - 10.0f});
  if (springs) {
    DrawSpringBoard(ui, session, state.springs, board);
  } else {
    DrawDrawingBoard(ui, session, state.board, board);
  }

  const float split = wide ? inside.Max.x - 250.0f : inside.Max.x;
  const ImRect buttons({inside.Min.x, rod_top}, {wide ? split - kGapRoom : split, rod_top + high});
  if (springs) {
    DrawSpringButtons(ui, session, state.springs, buttons);
  } else {
    DrawRodButtons(ui, session, state.board, buttons);
  }
  // A figure without a muscle cannot learn to move.
  const bool unready =
      springs ? state.springs.blank || session.Doc().figure.Muscles() == 0 : state.board.blank;
  const ImRect teach({wide ? split : inside.Min.x, teach_top}, {inside.Max.x, teach_top + large});
  if (ui.Button("draw/teach", teach, TeachWords(session.Doc()), ButtonLook::kPrimary, !unready)) {
    state.on_stage = false;
    session.Synthesize();
  }
}

}  // namespace gaitsmith::shell
