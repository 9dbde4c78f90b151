// SPDX-License-Identifier: MIT
// One plain sentence for each control, for tooltips and screen readers. The tables are hints/*.json. The page
// loads one after the first motion, the window embeds them.
#pragma once

#include <string>
#include <string_view>

namespace gaitsmith::shell {

/// Replaces the sentences. @param json a table of shell/words/hints: "widget/id", or "widget/*" for a family,
/// with a sentence. The first that fits counts. "widget/id!" says why the widget is disabled.
/// @return false: it is not such a table, and nothing has changed
bool SetHints(std::string_view json);

/// The sentence for a widget; empty: none is known. @param why_not the reason if it is disabled and knows it
[[nodiscard]] std::string HintFor(std::string_view id, bool disabled = false, std::string_view why_not = {});

}  // namespace gaitsmith::shell
