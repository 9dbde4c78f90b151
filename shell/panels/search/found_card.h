// SPDX-License-Identifier: MIT
// A found motion as a card: a moving picture, its name, terms and origin, and buttons.
#pragma once

#include <string>

#include "shell/session/session.h"
#include "shell/stage/motion_strip.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

enum class CardAction {
  kNothing,
  kShow,
  kInsert,
  kKeep,
  kRename,
  kAgain,
  kMoreLike,
  kLessLike,
  kBrain,
  kDelete
};

/// The name given by a person, or else the title of its search.
[[nodiscard]] std::string CardName(const FoundMotion&);
/// What it reached, "12.3 m"; without a motion the reason.
[[nodiscard]] std::string MetresText(const FoundMotion&);
/// The name and the control mode, in a sentence.
[[nodiscard]] std::string SceneText(const FoundMotion&);

/// Click the card to view the motion; drag it to the timeline to insert the motion there.
CardAction DrawFoundCard(Ui&, const Session&, const FoundMotions::Entry&, MotionStrips&);

}  // namespace gaitsmith::shell
