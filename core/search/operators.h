// SPDX-License-Identifier: MIT
// The operators that all searches share to create and change controllers [Fukunaga 1994, section 2; Ngo
// 1993]. The paper refers to other work for details, so these are our interpretation. Design decisions 10 and
// 20 give the reasons. A component is a bank's rule, a network's node or a trajectory's knot. Crossover
// exchanges whole components, mutation perturbs genes within them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/control/controller.h"
#include "core/control/sighting.h"

namespace gaitsmith {

/// Whether a rule may ignore every physical sense. Such a rule matches everything, so once it acts it mostly
/// acts for ever. Half of all random banks of five rods have one.
enum class Heedless { kAllowed, kForbidden };
inline constexpr std::array<std::string_view, 2> kHeedlessNames = {"allowed", "forbidden"};

/// How random banks are created and perturbed. The paper leaves both open. These numbers determine whether
/// rules ever switch.
struct Variation {
  /// Chance that a rule ignores a physical sense, [0, 1]. At 0 no rule ever matches.
  float dont_care = 0.8f;
  float gene_chance = 0.1f;  // chance that one gene of a perturbed bank changes, (0, 1]
  float creep = 0.1f;        // standard deviation of a change, as a share of the gene's range, (0, 1]
  float redraw = 0.05f;      // chance that a component is redrawn instead of perturbed, [0, 1]
  Heedless heedless = Heedless::kAllowed;  // forbidden: such a rule gets an interval of a random sense
};

/// Table 2 gives rates as the chance "with which a component of the genome will be subject to crossover or
/// mutation each time a child is generated". This can be read in two ways, and the ranking of the algorithms
/// depends on it.
enum class RateReading {
  kPerChild,      // the chance that the operator is applied to a child at all
  kPerComponent,  // the chance that each rule is crossed and each gene is perturbed
};
inline constexpr std::array<std::string_view, 2> kRateReadingNames = {"per-child", "per-component"};

/// What becomes of a child that equals one of its parents. Kept, it is simulated again.
enum class Copies { kKept, kPerturbed };
inline constexpr std::array<std::string_view, 2> kCopiesNames = {"kept", "perturbed"};

/// How a hybrid comes about.
enum class Crossing {
  kWhole,    // it has whole components of each parent [Fukunaga 1994]
  kBlended,  // its genes lie around those of both parents [Deb Agrawal 1995], and mutation moves single genes
             // a little [Deb Goyal 1996]: the operators that NSGA-II was published with. For Breed only
};
inline constexpr std::array<std::string_view, 2> kCrossingNames = {"whole", "blended"};

struct Rates {
  float mutation = 0.1f;   // [0, 1]; Table 2: 0.1 for both genetic algorithms
  float crossover = 0.6f;  // [0, 1]; Table 2: 0.6
  RateReading reading = RateReading::kPerChild;
  Copies copies = Copies::kKept;
  Crossing crossing = Crossing::kWhole;  // blended ones read their rates per child and per gene
};

/// The space a search works in.
struct SearchSpace {
  ControllerShape shape;
  SenseSpec senses;
  Genome start = {};  // first genome of every search, where refiners begin; empty: random
  /// That number of sightings of a bank's motion, evenly spaced, the last one at its end, the same each time.
  /// Empty if searches work without physics.
  std::function<std::vector<Sighting>(const Genome&, int)> sightings = {};
};

/// A new random controller.
[[nodiscard]] Genome RandomGenome(const ControllerShape&, const SenseSpec&, const Variation&, RandomStream&);

/// A perturbed copy that differs from its parent in at least one gene.
[[nodiscard]] Genome Perturb(std::span<const Gene> parent, const ControllerShape&, const SenseSpec&,
                             const Variation&, RandomStream&);

/// A member of the first generation: the given start for individual 0, otherwise a random bank.
[[nodiscard]] Genome FirstGenome(const SearchSpace&, const Variation&, std::uint32_t seed, int individual);

/// Crossover: a copy of `second` with some components of `first`. Per child: with chance `rates.crossover`
/// each component comes from either parent with equal chance, otherwise all come from `second`. Per
/// component: each comes from `first` with chance `rates.crossover`.
[[nodiscard]] Genome Cross(std::span<const Gene> first, std::span<const Gene> second, const ControllerShape&,
                           const Rates&, RandomStream&);

/// Mutation. Per child: the child is perturbed with chance `rates.mutation`. Per component: every gene
/// changes with this chance, which replaces Variation::gene_chance, and rules are redrawn in proportion.
void Mutate(Genome& child, const SearchSpace&, const Variation&, const Rates&, RandomStream&);

/// Perturbs a child that equals one of its parents, if the rates say so.
void PerturbCopy(Genome& child, std::span<const Gene> first, std::span<const Gene> second, const SearchSpace&,
                 const Variation&, const Rates&, RandomStream&);

/// "One child is a copy of one parent, and the other is a true hybrid". Both are mutated [Fukunaga 1994,
/// section 3], and perturbed if they are copies. Blended children are both hybrids.
struct Offspring {
  Genome copy;    // copy of the first parent
  Genome hybrid;  // hybrid of both parents
};
[[nodiscard]] Offspring Breed(std::span<const Gene> first, std::span<const Gene> second, const SearchSpace&,
                              const Variation&, const Rates&, RandomStream&);

/// The mean difference of the genes of two genomes of one shape, as a share of their range, [0, 1].
[[nodiscard]] double GeneDistance(std::span<const Gene>, std::span<const Gene>);

/// A genome as a point of the unit cube: gene / 65535.
[[nodiscard]] std::vector<double> PointOf(std::span<const Gene> genome);

/// The genome nearest to a point, for searches that work with real numbers: clamped to the cube and rounded
/// to the 16-bit grid. The ends of inverted intervals are swapped.
[[nodiscard]] Genome GenomeAt(std::span<const double> point, const ControllerShape&);

}  // namespace gaitsmith
