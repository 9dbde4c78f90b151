// SPDX-License-Identifier: MIT
// What a person may do without pointing at a control, and the keys for it: one table, which drives the
// keyboard here and in the page, and fills the page's sheet of keys and its list of commands.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "shell/session/session.h"

namespace gaitsmith::shell {

struct Command {
  std::string id;     // stable, e.g. "motion/play"
  std::string group;  // "Motion"
  std::string title;  // "Play or pause"
  /// As browsers name them: "Space", ",", "Home", "s", "Ctrl+Shift+z". Ctrl stands for ⌘, too.
  std::vector<std::string> keys = {};
  std::string why_not = {};  // not possible now, and why; empty: it is
  bool repeats = false;      // while the key is held
  std::function<void()> run = {};
};

/// @param phone  the timeline is one of the panels
[[nodiscard]] std::vector<Command> CommandsOf(Session&, bool phone);
/// Shipped examples, tasks and figures, each with the command that brings it.
[[nodiscard]] std::vector<Command> ShelfOf(Session&);

/// A list of {id, group, title, keys, whyNot}.
[[nodiscard]] std::string CommandsJson(const std::vector<Command>&);

/// A key that a focused control may want for itself: the space bar, arrows, Home, End.
[[nodiscard]] bool BelongsToControls(std::string_view key);

}  // namespace gaitsmith::shell
