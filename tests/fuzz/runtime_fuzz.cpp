// SPDX-License-Identifier: MIT
// Any text: the C header for games loads a controller or says where the text is wrong. A controller that it
// accepts decides without undefined behaviour, whatever it senses, and asks for finite angles.
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "core/runtime/gaitsmith.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static gaitsmith_controller controller;
  std::size_t where = size + 1;
  const int error = gaitsmith_load(&controller, reinterpret_cast<const char*>(data), size, &where);
  if (where > size) std::abort();
  if (error != GAITSMITH_OK) return 0;
  gaitsmith_state state;
  gaitsmith_begin(&controller, &state);
  float senses[GAITSMITH_SENSES];
  float angle = 0.0f, rate = 0.0f;
  for (std::size_t step = 0; step < 100; ++step) {
    for (std::size_t i = 0; i < GAITSMITH_SENSES; ++i) {
      const std::uint8_t byte = data[(step * GAITSMITH_SENSES + i) % size];
      senses[i] =
          byte == 0 ? std::numeric_limits<float>::quiet_NaN() : 0.01f * static_cast<float>(byte) - 0.5f;
      if (i < static_cast<std::size_t>(controller.senses))
        senses[i] = gaitsmith_normalise(&controller, static_cast<int>(i), senses[i]);
    }
    gaitsmith_step(&controller, &state, senses);
    if (state.rule < 0 || state.rule > controller.units) std::abort();
    for (int joint = 0; joint < controller.joints; ++joint) {
      if (!(state.target[joint] > -10.0f && state.target[joint] < 10.0f)) std::abort();
      gaitsmith_move(&controller, &state, joint, &angle, &rate);
    }
  }
  return 0;
}
