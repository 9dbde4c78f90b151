// SPDX-License-Identifier: MIT
// The board for drawing a figure of springs: a tap makes a node, a drag between nodes a spring, a tap on a
// spring a muscle.
#pragma once

#include "shell/panels/figure/spring_edit.h"
#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

enum class SpringTool { kDraw, kMove };

/// The board's state between frames.
struct SpringBoardState {
  SpringTool tool = SpringTool::kDraw;
  bool symmetric = false;
  float mirror_m = 0.0f;  // where the mirror stands during a stroke
  bool blank = false;     // nothing is drawn yet: the first stroke is the first spring
  SpringPart chosen;
  int held = kNone;           // the node under the finger
  bool pressed = false;       // on the board, whatever is there
  ImVec2 middle{0.0f, 0.0f};  // of the board [m]
  float scale = 0.0f;         // [points per metre]; 0: fit the figure into the board
  ImVec2 size{0.0f, 0.0f};    // of the board that the view was fitted into

  static constexpr int kNone = -1;
  [[nodiscard]] Mirror MirrorNow() const { return symmetric ? Mirror(mirror_m) : Mirror(); }
  /// In the middle of what is drawn, where edits of both sides leave it.
  [[nodiscard]] Mirror MirrorOf(const Figure& figure) const {
    return symmetric ? Mirror(MiddleOf(figure)) : Mirror();
  }
};

/// Keeps the choice within the figure.
void KeepChosen(const Figure&, SpringBoardState&);

void DrawSpringBoard(Ui&, Session&, SpringBoardState&, const ImRect&);

}  // namespace gaitsmith::shell
