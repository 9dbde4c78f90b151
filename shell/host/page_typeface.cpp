// SPDX-License-Identifier: MIT
// Gives the page the canvas's typeface, so that it is downloaded only once.
#include <emscripten.h>

#include "shell/embedded/embedded.h"

namespace {

std::span<const unsigned char> Face(int semibold) {
  return semibold != 0 ? gaitsmith::shell::InterSemiBold() : gaitsmith::shell::InterRegular();
}

}  // namespace

extern "C" {

/// A TrueType file.
EMSCRIPTEN_KEEPALIVE const unsigned char* gs_typeface(int semibold) { return Face(semibold).data(); }
EMSCRIPTEN_KEEPALIVE int gs_typeface_size(int semibold) { return static_cast<int>(Face(semibold).size()); }

}  // extern "C"
