// SPDX-License-Identifier: MIT
// A found motion as a card: it moves, says its name, its terms and where it came from, and what can be done
// with it.
#pragma once

#include <string>

#include "shell/session/session.h"
#include "shell/stage/motion_strip.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

enum class FoundWish { kNothing, kShow, kInsert, kKeep, kRename, kAgain, kDelete };

/// The name a person gave it, else what it was searched for.
[[nodiscard]] std::string CardName(const FoundMotion&);
/// The same and what decides, in a sentence.
[[nodiscard]] std::string SceneText(const FoundMotion&);

/// A press shows the motion; dragged to the timeline it is inserted there.
FoundWish DrawFoundCard(Ui&, const Session&, const FoundMotions::Entry&, MotionStrips&);

}  // namespace gaitsmith::shell
