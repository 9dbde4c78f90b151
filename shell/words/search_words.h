// SPDX-License-Identifier: MIT
// Describes searches, for lists, titles and the status line.
#pragma once

#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// "Mr. Star-Man · travel", "Mr. Star-Man · jump, more rotations"
[[nodiscard]] std::string SearchTitle(const Document&);
/// As SearchTitle, but always in English, for documents and scripts.
[[nodiscard]] std::string SearchName(const Document&);
/// "SPHC · seed 3 · 40,000 evaluations"
[[nodiscard]] std::string SearchLine(const Document&);
/// The control mode: "timer 0.80 s", "physical", "network".
[[nodiscard]] std::string ControlModeWords(ControllerKind, const SenseSpec&);
/// "1 search waits", "12 searches wait"
[[nodiscard]] std::string WaitingWords(std::size_t count);
/// The title of a found motion: "Mr. Star-Man · travel, 10 rules with physical senses, seed 3", at most as
/// long as a title may be. Always in English, as stored in documents; TrTitle translates it.
/// @param figure  the figure's name
[[nodiscard]] std::string FoundTitle(const std::string& figure, const Document&);

}  // namespace gaitsmith::shell
