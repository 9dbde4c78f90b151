// SPDX-License-Identifier: MIT
// The found motions in the Search panel as cards, sorted and filtered.
#pragma once

#include "shell/panels/search/found_card.h"

namespace gaitsmith::shell {

struct FoundListState {
  enum class Filter { kAll, kThisFigure, kKept };

  FoundMotions::Order order = FoundMotions::Order::kNewest;
  Filter filter = Filter::kAll;
  MotionStrips strips = {};
};

void DrawFound(Ui&, Session&, FoundListState&);

}  // namespace gaitsmith::shell
