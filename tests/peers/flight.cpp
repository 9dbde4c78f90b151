// SPDX-License-Identifier: MIT
// Flights of a figure of model 2 with steps of different lengths, for comparison with other engines.
//   flight SECONDS STEPS_PER_SECOND… < DOC
// Writes lines of JSON. The first is the figure as a MuJoCo model (gaitsmith export --mjcf), a string. The
// others are, for each number of steps per second, where the figure is after SECONDS:
//   root_rad, joint_rad[]        angle of the root rod, and of each joint from its drawn angle
//   x_m, rise_m                  way of the centre of mass from its start
//   momentum_kgm2ps              angular momentum about the centre of mass
//   eased                        steps, summed over joints, in which a joint with strength gave less torque
//   touched, broken              whether the ground was touched, whether the motion is void
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>

#include "core/document/document.h"
#include "core/document/json.h"
#include "core/document/json_value.h"
#include "core/physics/strength_plant.h"
#include "core/rollout/rollout.h"
#include "shell/export/exporters.h"

namespace {

using namespace gaitsmith;

void Fly(const Document& document, double seconds, int per_second) {
  const float step_s = 1.0f / static_cast<float>(per_second);
  const int steps = static_cast<int>(std::lround(seconds * per_second));
  const Mechanism body(document.figure);
  const auto takeovers =
      DecodeClips(document.timeline, document.controllers, StrengthPlant<1>::PortsOf(body), step_s);
  Rollout<StrengthPlant, 1> rollout(body, document.environment, document.start, document.pushes, takeovers,
                                    step_s);
  int eased = 0;
  bool touched = false;
  rollout.RunTo(steps, kNothing, [&] {
    const LimbState<1> now = rollout.PlantNow().Save();
    for (std::size_t i = 1; i < static_cast<std::size_t>(body.rods); ++i) {
      const float most = body.torque_nm[i] * step_s;
      if (most > 0.0f && std::abs(std::abs(now.joint_impulse[i][0]) - most) > 1e-6f * most) ++eased;
    }
    for (const auto& normal : now.last_force.normal) touched = touched || normal[0] > 0.0f;
  });
  const LimbState<1> end = rollout.PlantNow().Save();
  std::cout << R"({"root_rad":)" << end.turn_rad[0] << R"(,"joint_rad":[)";
  for (std::size_t j = 0; j < static_cast<std::size_t>(body.joints); ++j)
    std::cout << (j == 0 ? "" : ",") << end.angle_rad[j][0];
  std::cout << R"(],"x_m":)" << end.distance_m[0] << R"(,"rise_m":)"
            << end.height_m[0] - end.start_height_m[0] << R"(,"momentum_kgm2ps":)" << end.angular_momentum[0]
            << R"(,"eased":)" << eased << R"(,"touched":)" << touched << R"(,"broken":)"
            << (end.broken[0] != 0) << "}\n";
}

}  // namespace

int main(int count, char** words) try {
  const auto document = DecodeJson(std::string(std::istreambuf_iterator<char>(std::cin), {}));
  if (!document || count < 3) {
    std::cerr << (document ? "flight SECONDS STEPS_PER_SECOND…" : document.error().Sentence()) << '\n';
    return 1;
  }
  std::cout << QuoteJson(shell::MujocoModel(*document, Simulate(*document), {})) << '\n';
  std::cout << std::setprecision(17) << std::boolalpha;
  for (int i = 2; i < count; ++i) Fly(*document, std::atof(words[1]), std::atoi(words[i]));
  return 0;
} catch (const std::exception&) {
  return 1;
}
