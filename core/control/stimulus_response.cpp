// SPDX-License-Identifier: MIT
#include "core/control/stimulus_response.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {
namespace {

// In double precision, so that rounding never shifts a gene by a grid cell.
Gene Nearest(double share) {
  return static_cast<Gene>(std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(kGeneMax)));
}

}  // namespace

Gene Encode(float value, float low, float high) {
  if (!(high > low)) return 0;
  return Nearest((static_cast<double>(value) - static_cast<double>(low)) /
                 (static_cast<double>(high) - static_cast<double>(low)));
}

float DecodeTau(Gene gene, const SenseSpec& senses) {
  const double span = Log(static_cast<double>(senses.tau_max_s) / static_cast<double>(senses.tau_min_s));
  return static_cast<float>(static_cast<double>(senses.tau_min_s) * Exp(span * gene / kGeneMax));
}

Gene EncodeTau(float tau_s, const SenseSpec& senses) {
  const double span = Log(static_cast<double>(senses.tau_max_s) / static_cast<double>(senses.tau_min_s));
  if (!(span > 0.0)) return 0;
  const float tau = std::clamp(tau_s, senses.tau_min_s, senses.tau_max_s);
  return Nearest(Log(static_cast<double>(tau) / static_cast<double>(senses.tau_min_s)) / span);
}

}  // namespace gaitsmith
