// SPDX-License-Identifier: MIT
// The list of figures, the drawing board, and the selected rod's numbers.
#include "shell/panels/figure/figure_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/numeric/scalar_math.h"
#include "shell/panels/figure/figure_edit.h"
#include "shell/panels/figure/figure_gallery.h"
#include "shell/panels/figure/spring_form.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kDegree = static_cast<float>(kPi) / 180.0f;
constexpr float kLargestAngle = 3.1415925f;  // [rad], just below pi, the end of core's range

std::string Degrees(double degrees) {
  return (degrees < -0.5 ? "−" : "") + Fixed(std::abs(std::round(degrees)), 0) + "°";
}

/// Changes the selected rod.
using RodEdit = std::function<void(Rod&)>;

void EditNumbers(Ui& ui, const Rod& rod, const std::function<void(const RodEdit&)>& change) {
  const bool root = rod.parent == kNoParent;
  double length = static_cast<double>(rod.length_m);
  double mass = static_cast<double>(rod.mass_kg);
  double angle = static_cast<double>(rod.rest_rad / kDegree);
  if (ui.Slider("figure/length", Tr("Length"), length,
                {.low = 0.1, .high = 5.0, .step = 0.01, .logarithmic = true},
                Fixed(rod.length_m, 2) + " m")) {
    change([&](Rod& r) { r.length_m = static_cast<float>(length); });
  }
  if (ui.Slider("figure/mass", Tr("Mass"), mass,
                {.low = 0.05, .high = 50.0, .step = 0.05, .logarithmic = true},
                Fixed(rod.mass_kg, 2) + " kg")) {
    change([&](Rod& r) { r.mass_kg = static_cast<float>(mass); });
  }
  if (ui.Slider("figure/angle", Tr(root ? "Angle to the ground" : "Angle to its parent"), angle,
                {.low = -180.0, .high = 180.0, .step = 1.0}, Degrees(angle))) {
    change([&](Rod& r) {
      r.rest_rad = std::clamp(static_cast<float>(angle) * kDegree, -kLargestAngle, kLargestAngle);
    });
  }
  if (root) return;
  double least = static_cast<double>(rod.min_rad / kDegree);
  double most = static_cast<double>(rod.max_rad / kDegree);
  if (ui.Slider("figure/joint-from", Tr("Joint turns from"), least, {.low = -180.0, .high = 0.0, .step = 1.0},
                Degrees(least)))
    change(
        [&](Rod& r) { r.min_rad = std::clamp(static_cast<float>(least) * kDegree, -kLargestAngle, 0.0f); });
  if (ui.Slider("figure/joint-to", Tr("Joint turns to"), most, {.low = 0.0, .high = 180.0, .step = 1.0},
                Degrees(most)))
    change([&](Rod& r) { r.max_rad = std::clamp(static_cast<float>(most) * kDegree, 0.0f, kLargestAngle); });
}

void EditRod(Ui& ui, Session& session, DrawingBoardState& state) {
  const Figure& figure = session.Doc().figure;
  state.rod = std::clamp(state.rod, 0, figure.Rods() - 1);
  int number = state.rod + 1;
  ui.Number("figure/rod", Tr("Rod {1} of {2}", number, figure.Rods()), number, 1, figure.Rods());
  state.rod = number - 1;
  const auto index = static_cast<std::size_t>(state.rod);
  const Rod rod = figure.rods[index];
  EditNumbers(ui, rod, [&](const RodEdit& edit) {
    Figure changed = session.Doc().figure;
    edit(changed.rods[index]);
    session.ReplaceFigure(changed);
  });
  ui.Gap(8.0f);
  const auto replace = [&](Figure next, int selected) {
    next.name = kOwnFigure;
    if (session.ReplaceFigure(next)) state.rod = selected;
  };
  const ImRect row = ui.ControlRow();
  const float width = (row.GetWidth() - 16.0f) / 3.0f;
  const auto third = [&](int k) {
    const float left = row.Min.x + static_cast<float>(k) * (width + 8.0f);
    return ImRect(left, row.Min.y, left + width, row.Max.y);
  };
  const bool root = rod.parent == kNoParent;
  const bool room = figure.Rods() < kMaxRods;
  if (ui.Button("figure/grow", third(0), Tr("Add a rod"), ButtonLook::kOutlined, room)) {
    replace(WithRodGrown(figure, state.rod), figure.Rods());
  } else if (ui.Button("figure/copy", third(1), Tr("Copy limb"), ButtonLook::kOutlined, room && !root)) {
    replace(WithLimbCopied(figure, state.rod), figure.Rods());
  } else if (ui.Button("figure/delete", third(2), Tr("Delete limb"), ButtonLook::kOutlined, !root)) {
    replace(WithoutRod(figure, state.rod), rod.parent);
  }
  if (root) {
    ui.Gap(4.0f);
    ui.Paragraph(Tr("This is the root rod. It can't be copied or deleted."), Type::kNote);
  } else if (!room) {
    ui.Gap(4.0f);
    ui.Paragraph(Tr("A figure has at most {1} rods.", kMaxRods), Type::kNote);
  }
}

// For another figure: resets all but the tool and snapping.
void Reset(DrawingBoardState& board) { board = {.tool = board.tool, .snap = board.snap}; }

// A problem, in the paper's sense, is a figure with suitable task, senses and joints.
void DrawProblems(Ui& ui, Session& session, FigurePanelState& state) {
  std::vector<std::string> titles;
  int chosen = -1;
  for (const Document& problem : session.Shipped().Problems()) {
    const bool same =
        problem.figure.name == session.Doc().figure.name && problem.task.kind == session.Doc().task.kind;
    if (same) chosen = static_cast<int>(titles.size());
    titles.push_back(TrTitle(problem.title));
  }
  if (!ui.Combo("figure/problem", Tr("Preset"), titles, chosen, Tr("Custom"))) return;
  session.ChooseProblem(chosen);
  Reset(state.board);
}

/// Tools of a board, and Undo beside them. @return whether something was undone
bool DrawTools(Ui& ui, Session& session, const char* id, std::span<const char* const> names, int& tool) {
  const ImRect tools = ui.Row(ui.Look().touch ? 44.0f : 34.0f);
  const char* undo = Tr("Undo");
  const float undo_width = std::max(68.0f, ui.Letters().Width(Type::kBody, undo) + 16.0f);
  static_cast<void>(ui.Segmented(id, {tools.Min, {tools.Max.x - undo_width - 8.0f, tools.Max.y}},
                                 Tr("Tool of the drawing board"), names, tool));
  const bool undone = ui.Button("figure/undo", {{tools.Max.x - undo_width, tools.Min.y}, tools.Max}, undo,
                                ButtonLook::kOutlined, session.CanUndo());
  if (undone) session.Undo();
  ui.Gap(8.0f);
  return undone;
}

void DrawRodsForm(Ui& ui, Session& session, FigurePanelState& state) {
  static constexpr std::array<const char*, 2> kTools = {TrLater("Move"), TrLater("Add a rod")};
  int tool = static_cast<int>(state.board.tool);
  const bool undone = DrawTools(ui, session, "figure/tool", kTools, tool);
  state.board.tool = static_cast<DrawingTool>(tool);
  if (undone) Reset(state.board);
  if (session.Doc().figure.HasSprings()) return;  // so it was before
  if (!state.on_stage) {
    DrawDrawingBoard(ui, session, state.board, ui.Row(kBoardHeight));
    ui.Gap(8.0f);
  }
  ui.Paragraph(
      Tr(state.board.tool == DrawingTool::kMove
             ? "Drag a joint or a tip to change a rod. Drag a rod to rotate it and everything attached."
             : "Drag from a joint or a tip to add a rod there."),
      Type::kNote);
  ui.Switch("figure/snap", Tr("Snap to 15° and 5 cm"), state.board.snap);
  ui.Gap(8.0f);
  EditRod(ui, session, state.board);
}

void DrawSprings(Ui& ui, Session& session, FigurePanelState& state) {
  static constexpr std::array<const char*, 2> kTools = {TrLater("Draw"), TrLater("Move")};
  int tool = static_cast<int>(state.springs.tool);
  const bool undone = DrawTools(ui, session, "figure/springs-tool", kTools, tool);
  state.springs.tool = static_cast<SpringTool>(tool);
  if (undone) state.springs.scale = 0.0f;
  if (!session.Doc().figure.HasSprings()) return;
  if (!state.on_stage) {
    DrawSpringBoard(ui, session, state.springs, ui.Row(kBoardHeight));
    ui.Gap(8.0f);
  }
  ui.Paragraph(SpringToolWords(session.Doc().figure, state.springs), Type::kNote);
  ui.Gap(4.0f);
  DrawSpringForm(ui, session, state.springs);
}

}  // namespace

void DrawOwnFigure(Session& session, FigurePanelState& state, OwnFigure kind, bool on_stage) {
  Figure single = kind == OwnFigure::kRods ? SingleRod() : SpringBetween({0.0f, 0.0f}, {0.0f, 0.5f});
  single.name = kOwnFigure;
  if (!session.ReplaceFigure(single)) return;
  Reset(state.board);
  state.board.tool = DrawingTool::kGrow;
  const bool symmetric = state.springs.symmetric;
  state.springs = {};
  state.springs.symmetric = symmetric;
  state.board.blank = state.springs.blank = state.on_stage = on_stage;
}

void DrawFigurePanel(Ui& ui, Session& session, FigurePanelState& state) {
  int chosen = -1;
  for (std::size_t i = 0; i < session.Shipped().Figures().size(); ++i) {
    if (session.Shipped().Figures()[i].name == session.Doc().figure.name) chosen = static_cast<int>(i);
  }
  if (const auto pressed = DrawFigureGallery(ui, session.Shipped().Figures(), chosen, state.gallery_open)) {
    if (*pressed != chosen) session.ChooseFigure(*pressed);
    Reset(state.board);
    state.springs = {};
  }
  if (state.gallery_open) {
    ui.Gap(4.0f);
    ui.Paragraph(Tr("A new figure starts without motions. Undo brings the old ones back."), Type::kNote);
  }
  ui.Gap(6.0f);
  DrawProblems(ui, session, state);
  ui.Gap(10.0f);
  if (!session.Doc().drawn.empty()) {
    ui.Paragraph(Tr("A search changed this body."), Type::kNote);
    ui.Gap(4.0f);
    if (ui.Button("figure/as-drawn", ui.ControlRow(), Tr("Back to the drawn body")))
      session.ReplaceFigure(AsDrawn(session.Doc()));
    ui.Gap(10.0f);
  }
  if (session.Doc().figure.HasSprings()) {
    DrawSprings(ui, session, state);
  } else {
    DrawRodsForm(ui, session, state);
  }
  ui.Gap(8.0f);
  const bool springs = session.Doc().figure.HasSprings();
  const ImRect row = ui.ControlRow();
  const float middle = row.GetCenter().x;
  if (ui.Button("figure/mirror", {row.Min, {middle - 4.0f, row.Max.y}}, Tr("Mirror all")))
    session.ReplaceFigure(springs ? MirroredSprings(session.Doc().figure) : Mirrored(session.Doc().figure));
  const bool fresh = ui.Button("figure/fresh", {{middle + 4.0f, row.Min.y}, row.Max}, Tr("Draw your own"));
  ui.Gap(8.0f);
  if (ui.Button("figure/fresh-springs", ui.ControlRow(), Tr("Draw your own of springs")))
    DrawOwnFigure(session, state, OwnFigure::kSprings, false);
  if (fresh) DrawOwnFigure(session, state, OwnFigure::kRods, false);
}

}  // namespace gaitsmith::shell
