// SPDX-License-Identifier: MIT
// Discrete time, the same for plants and controllers. Changing either constant changes the bits of every
// motion ever shared.
#pragma once

namespace gaitsmith {

/// Time step [s]. At 0.02 the feet of a gait sink 13 mm when they land, before they are lifted out. At 0.01
/// they sink 1.2 mm. 0.005 costs twice as much and finds the same motions.
inline constexpr float kStep = 0.01f;

/// Longest motion [steps]: two minutes. Limits how much a link can make a browser compute.
inline constexpr int kMaxSteps = 12000;

}  // namespace gaitsmith
