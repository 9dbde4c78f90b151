// SPDX-License-Identifier: MIT
// Writes and reads a genome and its fitness in the saved state of a search.
#pragma once

#include <bit>
#include <limits>

#include "core/control/stimulus_response.h"
#include "core/numeric/bit_stream.h"

namespace gaitsmith {

inline void PutGenome(BitWriter& out, const Genome& genome, float fitness) {
  out.Put(genome.empty() ? 0 : 1, 1);
  for (const Gene gene : genome) out.Put(gene, 16);
  out.Put(std::bit_cast<std::uint32_t>(fitness), 32);
}

/// @return false if the fitness is NaN or plus infinity
[[nodiscard]] inline bool TakeGenome(BitReader& in, Genome& genome, float& fitness, std::size_t genes) {
  genome.assign(in.Take(1) != 0 ? genes : 0, 0);
  for (Gene& gene : genome) gene = static_cast<Gene>(in.Take(16));
  fitness = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
  return fitness < std::numeric_limits<float>::infinity();
}

}  // namespace gaitsmith
