// SPDX-License-Identifier: MIT
// Banked stimulus-response (BSR) controllers [Fukunaga 1994, section 2]: N rules, each a box in sense space
// (stimulus), a target pose and a time constant (response). The active rule is the one whose box contains the
// senses with the greatest depth:
//   depth = min over the senses the rule uses of 1 - |S - mid| / half-width
// If no box contains them, the active rule stays. Rules are stored as genes on a 16-bit grid from the start,
// so that the search and shared documents use exactly the same values.
#pragma once

#include <span>
#include <string>

#include "core/control/gene_groups.h"
#include "core/control/sense_table.h"
#include "core/numeric/random.h"

namespace gaitsmith {

inline constexpr int kMaxRules = 32;

/// The position of each number of a bank in its genome. Each rule has the low and high end of every sense's
/// interval, the target angle of every joint and the time constant: 2 S + J + 1 genes.
struct BankShape {
  int rules = 10;  // [1, kMaxRules]
  int senses = 1;
  int joints = 0;

  BankShape(int rule_count, SenseKind kind, const PortCount& ports)
      : rules(rule_count), senses(SenseCount(kind, ports)), joints(ports.actuators) {}

  [[nodiscard]] int GenesPerRule() const { return 2 * senses + joints + 1; }
  [[nodiscard]] std::size_t Genes() const {
    return static_cast<std::size_t>(rules) * static_cast<std::size_t>(GenesPerRule());
  }
  [[nodiscard]] std::size_t Low(int rule, int sense) const { return At(rule, 2 * sense); }
  [[nodiscard]] std::size_t High(int rule, int sense) const { return At(rule, 2 * sense + 1); }
  [[nodiscard]] std::size_t Target(int rule, int joint) const { return At(rule, 2 * senses + joint); }
  [[nodiscard]] std::size_t Tau(int rule) const { return At(rule, 2 * senses + joints); }

  [[nodiscard]] bool Cares(std::span<const Gene> genes, int rule, int sense) const {
    return gaitsmith::Cares(genes[Low(rule, sense)], genes[High(rule, sense)]);
  }
  [[nodiscard]] GeneGroups GroupsOf(int rule) const {
    return GeneGroups(At(rule, 0))
        .Add("when", GeneRole::kIntervals, 2 * senses)
        .Add("pose", GeneRole::kList, joints)
        .Add("tau", GeneRole::kNumber, 1);
  }

 private:
  [[nodiscard]] std::size_t At(int rule, int offset) const {
    return static_cast<std::size_t>(rule) * static_cast<std::size_t>(GenesPerRule()) +
           static_cast<std::size_t>(offset);
  }
};

/// A gene as a number: low + (high - low) * gene / 65535, in single precision and in this order of
/// operations.
[[nodiscard]] inline float Decode(Gene gene, float low, float high) {
  return low + (high - low) * (static_cast<float>(gene) * (1.0f / 65535.0f));
}

/// The gene with the nearest number. Encode(Decode(g)) = g wherever the grid is wider than a float's
/// rounding.
/// @param value clamped to [low, high]; an empty range gives 0
[[nodiscard]] Gene Encode(float value, float low, float high);

/// The time constant of a gene [s], log-uniform over the spec's range.
[[nodiscard]] float DecodeTau(Gene gene, const SenseSpec&);

/// The gene with the nearest time constant, as a ratio. @param tau_s clamped to the spec's range
[[nodiscard]] Gene EncodeTau(float tau_s, const SenseSpec&);

}  // namespace gaitsmith
