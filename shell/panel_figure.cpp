// SPDX-License-Identifier: MIT
// The list of figures, the drawing board, and the selected rod's numbers.
#include "shell/panel_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/numeric/scalar_math.h"
#include "shell/figure_drawing.h"
#include "shell/figure_edit.h"
#include "shell/figure_gallery.h"
#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kBoardHeight = 268.0f;
constexpr const char* kOwnName = "My figure";

struct Board {
  Skeleton skeleton;
  std::vector<ImVec2> metres;  // endpoints
  std::vector<ImVec2> canvas;
  float scale;

  ImVec2 ToMetres(ImVec2 point) const {
    return {metres[0].x + (point.x - canvas[0].x) / scale, metres[0].y - (point.y - canvas[0].y) / scale};
  }
};

Board LayOut(const Figure& figure, const FigurePanelState& state, const ImRect& rect) {
  Board board{.skeleton = Skeleton(figure), .metres = {}, .canvas = {}, .scale = state.scale};
  board.metres = PoseOf(board.skeleton, {});
  ImVec2 low = board.metres[0];
  ImVec2 high = low;
  for (const ImVec2& p : board.metres) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  ImVec2 origin;  // canvas position of endpoint 0
  if (state.endpoint >= 0) {
    const ImVec2 still = board.metres[state.endpoint == 0 ? 1 : 0];
    origin = {state.anchor.x + (board.metres[0].x - still.x) * board.scale,
              state.anchor.y - (board.metres[0].y - still.y) * board.scale};
  } else {
    // Leaves room around the figure to grow into.
    board.scale = 0.64f * std::min(rect.GetHeight() / std::max(high.y - low.y, 0.1f),
                                   rect.GetWidth() / std::max(high.x - low.x, 0.1f));
    const ImVec2 middle = rect.GetCenter();
    origin = {middle.x + (board.metres[0].x - 0.5f * (low.x + high.x)) * board.scale,
              middle.y - (board.metres[0].y - 0.5f * (low.y + high.y)) * board.scale};
  }
  for (const ImVec2& p : board.metres) {
    board.canvas.emplace_back(origin.x + (p.x - board.metres[0].x) * board.scale,
                              origin.y - (p.y - board.metres[0].y) * board.scale);
  }
  return board;
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

int RodAt(const Board& board, ImVec2 pointer, float within) {
  int found = -1;
  for (int limb = 0; limb < board.skeleton.rods; ++limb) {
    const auto i = static_cast<std::size_t>(limb);
    const ImVec2 a = board.canvas[static_cast<std::size_t>(board.skeleton.limbs[i].start)];
    const ImVec2 b = board.canvas[i + 1];
    const ImVec2 along(b.x - a.x, b.y - a.y);
    const float square = std::max(1e-6f, along.x * along.x + along.y * along.y);
    const float share =
        std::clamp(((pointer.x - a.x) * along.x + (pointer.y - a.y) * along.y) / square, 0.0f, 1.0f);
    const float distance = std::hypot(pointer.x - a.x - share * along.x, pointer.y - a.y - share * along.y);
    if (distance > within) continue;
    within = distance;
    found = board.skeleton.limbs[i].drawn;
  }
  return found;
}

void DrawBoard(Ui& ui, const Board& board, const FigurePanelState& state, const ImRect& rect) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  // A dot every quarter metre gives the eye a measure.
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
  const float width = std::clamp(RodWidth(board.skeleton, board.scale), 6.0f, 15.0f);
  DrawFigure(list, board.skeleton, board.canvas, {.rods = p.ink, .width = width});
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

void UseBoard(Ui& ui, Session& session, FigurePanelState& state) {
  const ImRect rect = ui.Row(kBoardHeight);
  const Figure& figure = session.Doc().figure;
  const Touch touch =
      ui.Area("figure/board", rect, Grab::kDrag,
              {.label = "Drawing board", .role = "img", .value = std::to_string(figure.Rods()) + " rods"});
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const float near = ui.Look().touch ? 26.0f : 15.0f;
  Board board = LayOut(figure, state, rect);

  if (touch.began) {
    state.endpoint = EndpointAt(board, pointer, near);
    if (state.endpoint >= 0) {
      state.scale = board.scale;
      state.anchor = board.canvas[state.endpoint == 0 ? 1 : 0];
    } else {
      state.rod = RodAt(board, pointer, near);
    }
  }
  const DrawnFigure drawn{.figure = figure, .skeleton = board.skeleton, .points = board.metres};
  const bool moved = ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f);
  if (touch.held && state.endpoint >= 0 && moved && state.tool == 0) {
    session.ReplaceFigure(WithEndpointAt(drawn, state.endpoint, board.ToMetres(pointer)));
    board = LayOut(session.Doc().figure, state, rect);
  }
  if (!touch.held && state.endpoint >= 0) {
    const ImVec2 from = board.canvas[static_cast<std::size_t>(state.endpoint)];
    const bool far = std::hypot(pointer.x - from.x, pointer.y - from.y) > near;
    if (state.tool == 1 && far) {
      Figure grown = WithRodFrom(drawn, state.endpoint, board.ToMetres(pointer));
      grown.name = kOwnName;
      if (session.ReplaceFigure(grown)) state.rod = session.Doc().figure.Rods() - 1;
    } else {
      state.rod = state.endpoint == 0
                      ? board.skeleton.limbs[0].drawn
                      : board.skeleton.limbs[static_cast<std::size_t>(state.endpoint) - 1].drawn;
    }
    state.endpoint = -1;
    board = LayOut(session.Doc().figure, state, rect);
  }
  if (!touch.visible) return;
  ui.Frame(rect, ui.Ink().paper, ui.Ink().line, 9.0f);
  ui.Canvas()->PushClipRect(rect.Min, rect.Max, true);
  DrawBoard(ui, board, state, rect);
  if (touch.held && state.endpoint >= 0 && state.tool == 1) {
    DrawCapsule(ui.Canvas(), board.canvas[static_cast<std::size_t>(state.endpoint)], pointer, 7.0f,
                Fade(ui.Ink().accent, 0.7f));
  }
  ui.Canvas()->PopClipRect();
  ui.DrawFocus(touch, rect, 9.0f);
}

void EditRod(Ui& ui, Session& session, FigurePanelState& state) {
  const Figure& figure = session.Doc().figure;
  if (state.rod < 0 || state.rod >= figure.Rods()) {
    ui.Paragraph("Select a rod to see its numbers.", Type::kNote);
    return;
  }
  const auto index = static_cast<std::size_t>(state.rod);
  const Rod& rod = figure.rods[index];
  const bool root = rod.parent == kNoParent;
  const auto change = [&](auto edit) {
    Figure changed = figure;
    edit(changed.rods[index]);
    session.ReplaceFigure(changed);
  };
  ui.Heading("Rod " + std::to_string(state.rod + 1) + (root ? " (the root)" : ""));
  double length = static_cast<double>(rod.length_m);
  double mass = static_cast<double>(rod.mass_kg);
  double range = static_cast<double>(rod.max_rad) * 180.0 / kPi;
  if (ui.Slider("figure/length", "Length", length,
                {.low = 0.1, .high = 5.0, .step = 0.01, .logarithmic = true},
                Fixed(rod.length_m, 2) + " m")) {
    change([&](Rod& r) { r.length_m = static_cast<float>(length); });
  } else if (ui.Slider("figure/mass", "Mass", mass,
                       {.low = 0.05, .high = 50.0, .step = 0.05, .logarithmic = true},
                       Fixed(rod.mass_kg, 2) + " kg")) {
    change([&](Rod& r) { r.mass_kg = static_cast<float>(mass); });
  } else if (!root && ui.Slider("figure/range", "Joint turns either way", range,
                                {.low = 0.0, .high = 180.0, .step = 1.0}, Fixed(range, 0) + "°")) {
    change([&](Rod& r) {
      r.max_rad = std::min(static_cast<float>(range * kPi / 180.0), 3.1415925f);
      r.min_rad = -r.max_rad;
    });
  }
  ui.Gap(8.0f);
  if (root) {
    ui.Paragraph("The root carries all others, so it can be neither copied nor deleted.", Type::kNote);
    return;
  }
  const ImRect row = ui.ControlRow();
  const float middle = row.GetCenter().x;
  const auto replace = [&](Figure next, int selected) {
    next.name = kOwnName;
    if (session.ReplaceFigure(next)) state.rod = selected;
  };
  if (ui.Button("figure/copy", {row.Min, {middle - 4.0f, row.Max.y}}, "Copy limb")) {
    replace(WithLimbCopied(figure, state.rod), figure.Rods());
  } else if (ui.Button("figure/delete", {{middle + 4.0f, row.Min.y}, row.Max}, "Delete limb")) {
    replace(WithoutRod(figure, state.rod), -1);
  }
}

}  // namespace

namespace {

// A figure with the task, the senses and the joints that suit it: what the paper calls a problem.
void DrawProblems(Ui& ui, Session& session, FigurePanelState& state) {
  std::vector<std::string> titles;
  int chosen = -1;
  for (const Document& problem : session.Problems()) {
    const bool same =
        problem.figure.name == session.Doc().figure.name && problem.task.kind == session.Doc().task.kind;
    if (same) chosen = static_cast<int>(titles.size());
    titles.push_back(problem.title);
  }
  if (!ui.Combo("figure/problem", "Problem", titles, chosen, "Own")) return;
  session.ChooseProblem(chosen);
  state = {.tool = state.tool, .gallery_open = state.gallery_open};
}

}  // namespace

void DrawFigurePanel(Ui& ui, Session& session, FigurePanelState& state) {
  int chosen = -1;
  for (std::size_t i = 0; i < session.Figures().size(); ++i) {
    if (session.Figures()[i].name == session.Doc().figure.name) chosen = static_cast<int>(i);
  }
  if (const auto pressed = DrawFigureGallery(ui, session.Figures(), chosen, state.gallery_open)) {
    if (*pressed != chosen) session.ChooseFigure(*pressed);
    state = {.tool = state.tool, .gallery_open = state.gallery_open};
  }
  if (state.gallery_open) {
    ui.Gap(4.0f);
    ui.Paragraph("Another figure needs a controller of its own: the present ones go. Undo brings them back.",
                 Type::kNote);
  }
  ui.Gap(6.0f);
  DrawProblems(ui, session, state);
  ui.Gap(10.0f);
  static constexpr std::array<std::string_view, 2> kTools = {"Move", "Grow a rod"};
  const ImRect tools = ui.Row(ui.Look().touch ? 42.0f : 34.0f);
  ui.Segmented("figure/tool", {tools.Min, {tools.Max.x - 76.0f, tools.Max.y}}, "Tool of the drawing board",
               kTools, state.tool);
  if (ui.Button("figure/undo", {{tools.Max.x - 68.0f, tools.Min.y}, tools.Max}, "Undo", ButtonLook::kOutlined,
                session.CanUndo())) {
    session.Undo();
    state = {.tool = state.tool, .gallery_open = state.gallery_open};
  }
  ui.Gap(8.0f);
  UseBoard(ui, session, state);
  ui.Gap(8.0f);
  ui.Paragraph(state.tool == 0 ? "Drag a joint or a tip; the motion follows at once."
                               : "Drag from a joint or a tip to grow a rod there.",
               Type::kNote);
  ui.Gap(8.0f);
  EditRod(ui, session, state);
  ui.Gap(8.0f);
  if (ui.Button("figure/mirror", ui.ControlRow(), "Mirror left and right"))
    session.ReplaceFigure(Mirrored(session.Doc().figure));
}

}  // namespace gaitsmith::shell
