// SPDX-License-Identifier: MIT
// The one table of panels. Arrangements, tabs, commands and the catalogue read it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "shell/words/language.h"

namespace gaitsmith::shell {

/// Stored in documents and links (View::panel), so values never change. A new panel gets the next free
/// number, whatever its position in the table.
enum class Panel {
  kFigure = 0,
  kController = 1,
  kStyle = 2,
  kSearch = 3,
  kLab = 4,
  kTimeline = 5,
  kKeyframes = 6
};
/// The greatest panel number that a document can hold.
inline constexpr int kMaxPanelNumber = 15;

struct PanelRow {
  Panel panel;
  const char* id;         // in addresses and lessons
  const char* label;      // on its tab, to be translated
  bool tab_on_desk;       // false: a tab only on phones
  std::string_view lock;  // the locked part that closes the whole panel, or empty

  [[nodiscard]] constexpr int Number() const { return static_cast<int>(panel); }
};

/// In the order of the tabs. On a desk the timeline is not a tab. A lock of the Search panel covers only its
/// settings, and a lock of the timeline only changes of clips.
inline constexpr auto kPanels = std::to_array<PanelRow>({
    {Panel::kFigure, "figure", TrLater("Figure"), true, "figure"},
    {Panel::kController, "controller", TrLater("Controller"), true, "controller"},
    {Panel::kStyle, "style", TrLater("Style"), true, "style"},
    {Panel::kSearch, "search", TrLater("Search"), true, ""},
    {Panel::kLab, "lab", TrLater("Lab"), true, ""},
    {Panel::kTimeline, "timeline", TrLater("Timeline"), false, ""},
    {Panel::kKeyframes, "keyframes", TrLater("Keyframes"), true, "timeline"},
});

inline constexpr std::array<const char*, kPanels.size()> kPanelIds = [] {
  std::array<const char*, kPanels.size()> ids{};
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = kPanels[i].id;
  return ids;
}();

/// Whether all rows have distinct numbers that a document can hold.
[[nodiscard]] constexpr bool HaveOwnNumbers(std::span<const PanelRow> panels) {
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (panels[i].Number() < 0 || panels[i].Number() > kMaxPanelNumber) return false;
    for (std::size_t k = 0; k < i; ++k) {
      if (panels[k].panel == panels[i].panel) return false;
    }
  }
  return true;
}
static_assert(HaveOwnNumbers(kPanels));

/// A panel's index in the table.
[[nodiscard]] constexpr int IndexOf(Panel panel) {
  return static_cast<int>(std::ranges::find(kPanels, panel, &PanelRow::panel) - kPanels.begin());
}

/// The visible panel that a document selects: the one with the nearest number, the lower of two equally near.
/// @param shown indices in the table, at least one @param number of a document's view @return one of `shown`
[[nodiscard]] constexpr int NearestPanel(std::span<const PanelRow> panels, std::span<const int> shown,
                                         int number) {
  int nearest = shown[0];
  const auto rank = [&](int place) {
    const int own = panels[static_cast<std::size_t>(place)].Number();
    return own <= number ? 2 * (number - own) : 2 * (own - number) + 1;
  };
  for (const int place : shown) {
    if (rank(place) < rank(nearest)) nearest = place;
  }
  return nearest;
}

}  // namespace gaitsmith::shell
