// SPDX-License-Identifier: MIT
// Which panels are shown, and which parts of a document can be changed by hand. A lesson shows only the
// panels that it explains and locks the parts that it builds on.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/document/document.h"
#include "shell/workspace/panels.h"

namespace gaitsmith::shell {

/// What can be locked. The lab changes nothing.
enum class LockedPart { kFigure, kController, kStyle, kSearch, kTimeline, kWorld };
inline constexpr std::array<const char*, 6> kLockedPartNames = {"figure", "controller", "style",
                                                                "search", "timeline",   "world"};

struct Arrangement {
  std::array<bool, kPanels.size()> shown;                 // in the order of kPanels
  std::array<bool, kLockedPartNames.size()> locked = {};  // in the order of LockedPart

  std::optional<bool> live = {};  // whether Live is on until a person switches it; nothing: as usual

  Arrangement() { shown.fill(true); }
  /// @param panel its place in kPanels
  [[nodiscard]] bool Shows(int panel) const { return shown[static_cast<std::size_t>(panel)]; }
  [[nodiscard]] bool Locks(LockedPart part) const { return locked[static_cast<std::size_t>(part)]; }
  /// True if nothing can be changed on this panel. On the Search panel only the settings are locked, and a
  /// search can still run. On the timeline clips can still be selected, and the controls that would change
  /// clips report the lock.
  [[nodiscard]] bool LocksPanel(int panel) const;
};

/// Shows only the panels of a list such as "style,search". "all" shows every panel, "none" hides all.
/// @return the first word that names no panel, with nothing changed; nullopt on success
[[nodiscard]] std::optional<std::string_view> ShowPanels(std::string_view list, Arrangement&);
/// Locks only the parts of a list such as "figure,world". "none" locks nothing.
/// @return as ShowPanels
[[nodiscard]] std::optional<std::string_view> LockParts(std::string_view list, Arrangement&);

/// A locked part that differs between the two documents.
[[nodiscard]] std::optional<LockedPart> LockedDifference(const Arrangement&, const Document& before,
                                                         const Document& after);

}  // namespace gaitsmith::shell
