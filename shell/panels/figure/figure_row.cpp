// SPDX-License-Identifier: MIT
#include "shell/panels/figure/figure_row.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "shell/panels/figure/figure_tile.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr float kSpacing = 10.0f;
constexpr float kEdge = 14.0f;
constexpr float kTile = 88.0f, kNarrowTile = 60.0f;  // least width
constexpr float kNarrow = 560.0f;

/// The best known first; the others follow in the order of the gallery.
constexpr std::array<std::string_view, 8> kFirst = {"Ostrich", "Mr. Star-Man", "Acrobat",  "Frog",
                                                    "Horse",   "Kangaroo",     "Inchworm", "Beryl Biped"};

/// Indices of the figures in the row.
std::vector<int> RowOf(const std::vector<Figure>& figures, int chosen, std::size_t room) {
  std::vector<int> row;
  for (const std::string_view name : kFirst) {
    const auto figure = std::ranges::find(figures, name, &Figure::name);
    if (figure != figures.end()) row.push_back(static_cast<int>(figure - figures.begin()));
  }
  for (int i = 0; i < static_cast<int>(figures.size()); ++i) {
    if (std::ranges::find(row, i) == row.end()) row.push_back(i);
  }
  room = std::min(room, row.size());
  const auto at = std::ranges::find(row, chosen);
  if (at != row.end() && at - row.begin() >= static_cast<std::ptrdiff_t>(room))
    std::iter_swap(at, row.begin() + static_cast<std::ptrdiff_t>(room) - 1);
  row.resize(room);
  return row;
}

/// A card without a figure, for a button.
bool DrawCard(Ui& ui, const char* id, const ImRect& rect, Icon icon, std::string_view shown,
              const std::string& name) {
  const Touch touch = ui.Area(id, rect, Grab::kPress, {.label = name, .role = "button"});
  const Palette& p = ui.Ink();
  ui.CardFrame(rect, false, touch.hovered);
  const float above = DrawTileName(ui, shown, rect, p.ink);
  DrawIcon(ui.Canvas(), icon, {rect.GetCenter().x, 0.5f * (rect.Min.y + above)}, 20.0f, p.ink);
  ui.DrawFocus(touch, rect, 9.0f);
  return touch.pressed;
}

}  // namespace

FigureRowChoice DrawFigureRow(Ui& ui, const Session& session, const ImRect& rect) {
  FigureRowChoice choice;
  const PartScope part = ui.Part("figures", "region", Tr("Figures to choose from"));
  ui.HorizontalLine(rect.Min.x, rect.Max.x, rect.Min.y);
  const std::vector<Figure>& figures = session.Shipped().Figures();
  const auto named = std::ranges::find(figures, session.Doc().figure.name, &Figure::name);
  const int chosen = named == figures.end() ? -1 : static_cast<int>(named - figures.begin());
  const float room = rect.GetWidth() - 2.0f * kEdge + kSpacing;
  const auto cards = static_cast<std::size_t>(
      std::max(3.0f, room / ((rect.GetWidth() < kNarrow ? kNarrowTile : kTile) + kSpacing)));
  const auto rows = static_cast<std::size_t>(std::max(1.0f, rect.GetHeight() / kFigureRowHeight));
  const std::vector<int> row = RowOf(figures, chosen, rows * cards - 2);
  const float width = room / static_cast<float>(std::min(cards, row.size() + 2)) - kSpacing;
  std::size_t drawn = 0;
  const auto next = [&] {
    const std::size_t column = drawn % cards;
    const std::size_t above = drawn / cards;
    ++drawn;
    const float x = rect.Min.x + kEdge + static_cast<float>(column) * (width + kSpacing);
    const float y = rect.Min.y + static_cast<float>(above) * (kFigureRowHeight - kSpacing);
    return ImRect({x, y + 12.0f}, {x + width, std::min(rect.Max.y, y + kFigureRowHeight) - 10.0f});
  };
  choice.draw = DrawCard(ui, "figures/draw", next(), Icon::kPencil, Tr("Draw your own"), Tr("Draw your own"));
  {
    const PartScope group = ui.Part("figures/row", "radiogroup", Tr("Figure"));
    for (const int figure : row) {
      const std::string id = "figures/" + std::to_string(figure);
      if (DrawFigureTile(ui, figures[static_cast<std::size_t>(figure)], id, figure == chosen, next()))
        choice.figure = figure;
    }
  }
  const auto rest = static_cast<int>(figures.size() - row.size());
  choice.more = DrawCard(ui, "figures/more", next(), Icon::kPlus, Tr("{1} more", rest),
                         Tr("All {1} figures", static_cast<int>(figures.size())));
  return choice;
}

}  // namespace gaitsmith::shell
