// SPDX-License-Identifier: MIT
#include "shell/panels/figure/figure_gallery.h"

#include <algorithm>

#include "shell/panels/figure/figure_tile.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr int kColumns = 3;
constexpr float kTileHeight = 84.0f;
constexpr float kGap = 8.0f;

}  // namespace

std::optional<int> DrawFigureGallery(Ui& ui, const std::vector<Figure>& figures, int chosen, bool& open) {
  const int count = static_cast<int>(figures.size());
  std::optional<int> pressed;
  // When folded, show only the row with the present figure.
  const int start = open ? 0 : std::max(0, chosen) / kColumns * kColumns;
  const int end = open ? count : std::min(count, start + kColumns);
  {
    const PartScope part = ui.Part("figure/tiles", "radiogroup", Tr("Figure"));
    for (int first = start; first < end; first += kColumns) {
      const ImRect row = ui.Row(kTileHeight);
      const float width = (row.GetWidth() - kGap * (kColumns - 1)) / kColumns;
      for (int i = first; i < std::min(first + kColumns, end); ++i) {
        const float x = row.Min.x + static_cast<float>(i - first) * (width + kGap);
        const std::string id = "figure/gallery/" + std::to_string(i);
        if (DrawFigureTile(ui, figures[static_cast<std::size_t>(i)], id, i == chosen,
                           {{x, row.Min.y}, {x + width, row.Max.y}})) {
          pressed = i;
        }
      }
      ui.Gap(kGap);
    }
  }
  const ImRect row = ui.ControlRow();
  const std::string words = open ? Tr("Fewer figures") : Tr("All {1} figures", count);
  if (ui.Button("figure/gallery", row, words)) open = !open;
  return pressed;
}

}  // namespace gaitsmith::shell
