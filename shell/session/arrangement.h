// SPDX-License-Identifier: MIT
// How much of the application is there: which panels are shown, and which parts of a document can be changed
// by hand. A lesson shows what it speaks of and locks what it builds on.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/document/document.h"
#include "shell/session/panels.h"

namespace gaitsmith::shell {

/// What can be locked. The lab changes nothing.
enum class LockedPart { kFigure, kController, kStyle, kSearch, kTimeline, kWorld };
inline constexpr std::array<const char*, 6> kLockedPartNames = {"figure", "controller", "style",
                                                                "search", "timeline",   "world"};

struct Arrangement {
  std::array<bool, kPanels.size()> shown;                 // in the order of kPanels
  std::array<bool, kLockedPartNames.size()> locked = {};  // in the order of LockedPart

  Arrangement() { shown.fill(true); }
  /// @param panel its place in kPanels
  [[nodiscard]] bool Shows(int panel) const { return shown[static_cast<std::size_t>(panel)]; }
  [[nodiscard]] bool Locks(LockedPart part) const { return locked[static_cast<std::size_t>(part)]; }
  /// Nothing can be changed on this panel. Of the Search panel only the settings are locked: it searches. The
  /// timeline's clips can be pressed to be looked at; what would change them says that they are locked.
  [[nodiscard]] bool LocksPanel(int panel) const;
};

/// The panels of a list such as "style,search": only these are shown. "all" is each of them, "none" none.
/// @return the word that names no panel, or nothing when all is well; then the arrangement has changed
[[nodiscard]] std::optional<std::string_view> ShowPanels(std::string_view list, Arrangement&);
/// The parts of a list such as "figure,world": only these are locked. "none" is none of them.
/// @return as ShowPanels
[[nodiscard]] std::optional<std::string_view> LockParts(std::string_view list, Arrangement&);

/// A locked part that differs between the two.
[[nodiscard]] std::optional<LockedPart> LockedDifference(const Arrangement&, const Document& before,
                                                         const Document& after);

}  // namespace gaitsmith::shell
