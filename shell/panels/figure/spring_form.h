// SPDX-License-Identifier: MIT
// The numbers of a figure of springs: what is chosen on the board, and all that can be done with it without
// the board.
#pragma once

#include "shell/panels/figure/spring_board.h"

namespace gaitsmith::shell {

void DrawSpringForm(Ui&, Session&, SpringBoardState&);

/// What a person can do on the board with its tool.
[[nodiscard]] const char* SpringToolWords(const Figure&, const SpringBoardState&);

}  // namespace gaitsmith::shell
