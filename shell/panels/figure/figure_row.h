// SPDX-License-Identifier: MIT
// The figures to begin with, in a row below a stage whose figure cannot move yet, or in a few where it is
// high enough.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

inline constexpr float kFigureRowHeight = 116.0f;

struct FigureRowChoice {
  bool draw = false;  // a figure of one's own
  bool more = false;  // all figures
  int figure = -1;    // an index of ShippedDocuments::Figures, or none
};

/// As many figures as fit, in rows of kFigureRowHeight. The chosen one is always among them.
FigureRowChoice DrawFigureRow(Ui&, const Session&, const ImRect&);

}  // namespace gaitsmith::shell
