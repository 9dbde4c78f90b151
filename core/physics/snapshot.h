// SPDX-License-Identifier: MIT
// One plant at one instant, for drawing, printing and comparing motions.
#pragma once

namespace gaitsmith {

struct Snapshot {
  double x_m;  // centre of mass, along the ground
  float y_m;   // centre of mass, above the ground
  float velocity_x_mps, velocity_y_mps;
  double turn_rad;                        // of the root rod, whole turns included
  float angular_momentum;                 // about the centre of mass [kg m^2/s]
  float normal_work_j, friction_work_j;   // work of the ground in the step that ended here
  float friction_gain_j, lifting_work_j;  // positive work of friction (ideally 0); work of lifting
};

}  // namespace gaitsmith
