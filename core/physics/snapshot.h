// SPDX-License-Identifier: MIT
// What can be seen of one plant at one instant, for those who draw, print or compare motions.
#pragma once

namespace gaitsmith {

struct Snapshot {
  double x_m;  // centre of mass, along the ground
  float y_m;   // and above it
  float velocity_x_mps, velocity_y_mps;
  double turn_rad;                        // of the root rod, whole turns included
  float angular_momentum;                 // about the centre of mass [kg m^2/s]
  float normal_work_j, friction_work_j;   // of the ground in the step that led here
  float friction_gain_j, lifting_work_j;  // of friction, where it had the wrong sign; of lifting
};

}  // namespace gaitsmith
