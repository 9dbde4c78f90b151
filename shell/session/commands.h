// SPDX-License-Identifier: MIT
// Commands that need no pointer, and their keys. One table drives the keyboard in the shell and in the page,
// and fills the page's sheet of keys and its command palette.
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
  /// Keys by their names in browsers: "Space", ",", "Home", "s", "Ctrl+Shift+z". Ctrl also means ⌘.
  std::vector<std::string> keys = {};
  std::string why_not = {};  // why it is unavailable; empty: available
  bool repeats = false;      // repeats while the key is held
  std::function<void()> run = {};
};

/// @param phone  whether the timeline is one of the panels
[[nodiscard]] std::vector<Command> CommandsOf(Session&, bool phone);
/// Shipped examples, tasks and figures, each with the command that opens it.
[[nodiscard]] std::vector<Command> ShelfOf(Session&);

/// A list of {id, group, title, keys, whyNot}.
[[nodiscard]] std::string CommandsJson(const std::vector<Command>&);

/// Whether a focused control may need the key: space bar, Enter, arrows, Home, End.
[[nodiscard]] bool BelongsToControls(std::string_view key);

}  // namespace gaitsmith::shell
