// SPDX-License-Identifier: MIT
#include "shell/panels/figure/drawing_stage.h"

#include <algorithm>
#include <array>

#include "core/physics/figure.h"
#include "shell/panels/figure/figure_edit.h"
#include "shell/stage/invitation.h"
#include "shell/words/figure_words.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr float kSideRoom = 16.0f;
constexpr float kGapRoom = 8.0f;
constexpr float kWideRow = 620.0f;  // the tools and the large button fit into one row

const char* WhatToDo(const DrawingBoardState& board) {
  if (board.blank) return Tr("Drag across the board: that is the first rod.");
  return Tr(board.tool == DrawingTool::kMove
                ? "Drag a joint or a tip to change a rod. Drag a rod to rotate it and everything attached."
                : "Drag from a joint or a tip to add a rod there.");
}

// Buttons side by side for what can be done with the chosen rod.
void DrawRodButtons(Ui& ui, Session& session, DrawingBoardState& board, const ImRect& row) {
  const Figure& figure = session.Doc().figure;
  board.rod = std::clamp(board.rod, 0, figure.Rods() - 1);
  const bool limb = !board.blank && figure.rods[static_cast<std::size_t>(board.rod)].parent != kNoParent;
  const bool room = figure.Rods() < kMaxRods;
  const float width = (row.GetWidth() - 3.0f * kGapRoom) / 4.0f;
  int column = 0;
  const auto button = [&](const char* id, const char* label, bool enabled) {
    const float left = row.Min.x + static_cast<float>(column++) * (width + kGapRoom);
    return ui.Button(id, {{left, row.Min.y}, {left + width, row.Max.y}}, label, ButtonLook::kOutlined,
                     enabled);
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

  static constexpr std::array<const char*, 2> kTools = {TrLater("Move"), TrLater("Add a rod")};
  int tool = static_cast<int>(state.board.tool);
  const float tools_width = std::min(220.0f, inside.GetWidth() - 90.0f);
  const float top = stage.Min.y + 8.0f;
  if (ui.Segmented("draw/tool", {{inside.Min.x, top}, {inside.Min.x + tools_width, top + high}},
                   Tr("Tool of the drawing board"), kTools, tool))
    state.board.tool = static_cast<DrawingTool>(tool);
  if (ui.Button("draw/close", {{inside.Max.x - 82.0f, top}, {inside.Max.x, top + high}}, Tr("Done")))
    state.on_stage = false;

  const char* what = WhatToDo(state.board);
  const float line = top + high + 16.0f;
  ui.Letters().DrawElided(ui.Canvas(), Type::kBody, {inside.Min.x, line}, inside.GetWidth(),
                          ui.Ink().second_ink, what);
  ui.DescribeText(what, {{inside.Min.x, line - 9.0f}, {inside.Max.x, line + 9.0f}});

  const float large = wide ? high : 54.0f;
  const float teach_top = stage.Max.y - 10.0f - large;
  const float rod_top = wide ? teach_top : teach_top - kGapRoom - high;
  const ImRect board({inside.Min.x, line + 16.0f}, {inside.Max.x, rod_top - 10.0f});
  DrawDrawingBoard(ui, session, state.board, board);

  const float split = wide ? inside.Max.x - 250.0f : inside.Max.x;
  DrawRodButtons(ui, session, state.board,
                 {{inside.Min.x, rod_top}, {wide ? split - kGapRoom : split, rod_top + high}});
  const ImRect teach({wide ? split : inside.Min.x, teach_top}, {inside.Max.x, teach_top + large});
  if (ui.Button("draw/teach", teach, TeachWords(session.Doc()), ButtonLook::kPrimary, !state.board.blank)) {
    state.on_stage = false;
    session.Synthesize();
  }
}

}  // namespace gaitsmith::shell
