// SPDX-License-Identifier: MIT
#include "core/control/stimulus_response.h"

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

float DecodeTau(Gene gene, const SenseSpec& senses) {
  const double span = Log(static_cast<double>(senses.tau_max_s) / static_cast<double>(senses.tau_min_s));
  return static_cast<float>(static_cast<double>(senses.tau_min_s) * Exp(span * gene / kGeneMax));
}

}  // namespace gaitsmith
