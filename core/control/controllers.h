// SPDX-License-Identifier: MIT
// W controllers of one shape side by side, decoded and ready to run.
#pragma once

#include <variant>

#include "core/control/bank.h"
#include "core/control/controller.h"

namespace gaitsmith {

template <int W>
using Controllers = std::variant<Bank<W>, Network<W>>;

/// Parameters as of Bank and Network.
template <int W>
[[nodiscard]] Controllers<W> DecodeControllers(const ControllerShape& shape, const SenseSpec& senses,
                                               std::span<const std::span<const Gene>> genomes,
                                               std::span<const std::array<float, 2>> limits, float step_s) {
  if (shape.Kind() == ControllerKind::kNetwork) {
    return Network<W>(shape.Network(), senses, genomes, limits, step_s);
  }
  return Bank<W>(shape.Bank(), senses, genomes, limits, step_s);
}

}  // namespace gaitsmith
