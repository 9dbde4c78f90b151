// SPDX-License-Identifier: MIT
// How controllers are made and changed: the operators that all searches share [Fukunaga 1994, section 2;
// Ngo 1993]. The paper describes them elsewhere, so these are our reading; design decisions 10 and 20 say
// why. A bank's component is a rule, a network's a node: crossover exchanges whole ones, mutation perturbs
// genes within.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/control/controller.h"

namespace gaitsmith {

/// How random banks are made and perturbed. The paper leaves both open; these decide whether rules ever
/// switch.
struct Variation {
  float dont_care =
      0.8f;  // chance that a rule ignores a physical sense, [0, 1]; with none ignored no rule ever fires
  float gene_chance = 0.1f;  // chance that one gene of a perturbed bank creeps, (0, 1]
  float creep = 0.1f;        // standard deviation of a creep, as a share of the gene's range, (0, 1]
  float redraw = 0.05f;  // chance that a component of a perturbed controller is drawn anew instead, [0, 1]
};

/// Table 2 gives rates as the chance "with which a component of the genome will be subject to crossover or
/// mutation each time a child is generated". That can be read in two ways, and the order of the algorithms
/// depends on it.
enum class RateReading {
  kPerChild,      // the chance that the operator is applied to a child at all
  kPerComponent,  // the chance of every rule to be crossed, of every gene to be perturbed
};
inline constexpr std::array<std::string_view, 2> kRateReadingNames = {"per-child", "per-component"};

struct Rates {
  float mutation = 0.1f;   // [0, 1]; Table 2: 0.1 for both genetic algorithms
  float crossover = 0.6f;  // [0, 1]; Table 2: 0.6
  RateReading reading = RateReading::kPerChild;
};

/// The space a search works in.
struct SearchSpace {
  ControllerShape shape;
  SenseSpec senses;
  Genome start = {};  // the first genome of every search: where refiners begin; empty: a random one
};

/// A new random controller.
[[nodiscard]] Genome RandomGenome(const ControllerShape&, const SenseSpec&, const Variation&, RandomStream&);

/// A perturbed copy; differs from its parent in at least one gene.
[[nodiscard]] Genome Perturb(std::span<const Gene> parent, const ControllerShape&, const SenseSpec&,
                             const Variation&, RandomStream&);

/// Individual `individual` of a first generation: the given start for number 0, else a random bank of its
/// own.
[[nodiscard]] Genome FirstGenome(const SearchSpace&, const Variation&, std::uint32_t seed, int individual);

/// Crossover: a copy of `second` with rules of `first` in their places. Per child: with chance
/// `rates.crossover` every rule comes from either parent alike, otherwise none from `first`. Per component:
/// every rule comes from `first` with that chance.
[[nodiscard]] Genome Cross(std::span<const Gene> first, std::span<const Gene> second, const ControllerShape&,
                           const Rates&, RandomStream&);

/// Mutation. Per child: with chance `rates.mutation` the child is perturbed. Per component: every gene creeps
/// with that chance, in place of Variation::gene_chance, and rules are drawn anew in proportion to it.
void Mutate(Genome& child, const SearchSpace&, const Variation&, const Rates&, RandomStream&);

/// "One child is a copy of one parent, and the other is a true hybrid"; both are mutated
/// [Fukunaga 1994, section 3].
struct Offspring {
  Genome copy;    // of the first parent
  Genome hybrid;  // of both
};
[[nodiscard]] Offspring Breed(std::span<const Gene> first, std::span<const Gene> second, const SearchSpace&,
                              const Variation&, const Rates&, RandomStream&);

/// A genome as a point of the unit cube: gene / 65535.
[[nodiscard]] std::vector<double> PointOf(std::span<const Gene> genome);

/// The genome nearest to a point, for searches that work with real numbers: clamped to the cube, rounded to
/// the 16-bit grid, and intervals whose ends have crossed turned round.
[[nodiscard]] Genome GenomeAt(std::span<const double> point, const ControllerShape&);

}  // namespace gaitsmith
