// SPDX-License-Identifier: MIT
// The figure of springs of fuzzers that search.
#pragma once

#include "core/document/document.h"
#include "core/rollout/models.h"

namespace gaitsmith::test {

/// Two muscles and a spring, in place of a figure of rods. Rules and curves move it, networks cannot.
inline void MakeSpringy(Document& document) {
  document.model = kSpringModel;
  document.figure = {.name = "",
                     .rods = {},
                     .nodes = {{}, {.x_m = 1.0f}, {.x_m = 0.5f, .y_m = 0.8f}},
                     .springs = {{.from = 0, .to = 1},
                                 {.from = 1, .to = 2, .min_rest = 0.6f, .max_rest = 1.4f},
                                 {.from = 2, .to = 0, .min_rest = 0.6f, .max_rest = 1.4f}}};
}

}  // namespace gaitsmith::test
