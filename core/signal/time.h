// SPDX-License-Identifier: MIT
// Discrete time, the same for plants and controllers. Changing either number changes the bits of every motion
// ever shared.
#pragma once

namespace gaitsmith {

/// Time step [s]. At 0.02 a gait's landings sink 13 mm before they are lifted, at 0.01 1.2 mm; 0.005 costs
/// twice as much and finds the same motions.
inline constexpr float kStep = 0.01f;

/// Longest motion [steps]: two minutes. Bounds what a link can make a browser compute.
inline constexpr int kMaxSteps = 12000;

}  // namespace gaitsmith
