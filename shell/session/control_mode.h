// SPDX-License-Identifier: MIT
// What decides a controller's state: a clock, the physical senses, or a network of sensors. The paper
// compares the first two.
#pragma once

#include "core/document/document.h"

namespace gaitsmith::shell {

enum class ControlMode { kTimer, kSenses, kNetwork };

/// The mode of the document's next search.
[[nodiscard]] ControlMode ControlModeOf(const Document&);
void SetControlMode(Document&, ControlMode);

/// The mode that a controller is compared with: physical senses for a timer, a timer for all others.
[[nodiscard]] ControlMode ContrastTo(const Controller&);

}  // namespace gaitsmith::shell
