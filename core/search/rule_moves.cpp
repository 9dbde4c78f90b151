// SPDX-License-Identifier: MIT
#include "core/search/rule_moves.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"
#include "core/search/pose_cycle_form.h"

namespace gaitsmith {

namespace {

constexpr double kMore = 0.4;            // chance of a further change in the same child
constexpr double kRedrawResponse = 0.3;  // chance that a gene of a new rule's response is drawn anew

/// Log-uniform in [least, least * ratio].
double LogUniform(double least, double ratio, RandomStream& random) {
  return least * Exp(random.Uniform() * Log(ratio));
}

class Mover {
 public:
  Mover(const Genome& parent, std::span<const Sighting> sightings, const BankShape& bank,
        RandomStream& random)
      : child_(parent), sightings_(sightings), bank_(bank), random_(random) {
    acts_.assign(static_cast<std::size_t>(bank.rules), sightings.empty() ? 1 : 0);
    for (const Sighting& sighting : sightings) ++acts_[static_cast<std::size_t>(sighting.rule)];
    for (int rule = 0; rule < bank.rules; ++rule) {
      const int acts = acts_[static_cast<std::size_t>(rule)] + (rule == 0 ? 1 : 0);
      chances_.push_back((chances_.empty() ? 0.0 : chances_.back()) + std::sqrt(acts));
    }
  }

  void MoveOnce() {
    step_ = LogUniform(0.005, 60.0, random_);
    const double kind = random_.Uniform();
    if (kind < 0.50) {
      MoveResponse(ActingRule());
    } else if (kind < 0.80) {
      MoveStimulus(ActingRule());
    } else if (kind < 0.95) {
      PlaceRule();
    } else if (bank_.rules > 1) {
      Silence(child_, bank_, 1 + Below(bank_.rules - 1));
    }
  }

  [[nodiscard]] const Genome& Child() const { return child_; }

 private:
  int Below(int bound) { return static_cast<int>(random_.Below(static_cast<std::uint32_t>(bound))); }

  /// A rule, with a chance that grows with the root of the time in which it acts. The first rule always has
  /// one, because every motion begins with it.
  int ActingRule() {
    const double u = random_.Uniform() * chances_.back();
    const auto found = std::ranges::upper_bound(chances_, u);
    return static_cast<int>(std::min(found, chances_.end() - 1) - chances_.begin());
  }

  Gene Creep(Gene gene) { return GeneOf(gene * (1.0 / kGeneMax) + step_ * random_.Normal()); }

  void MoveResponse(int rule) {
    const double chance = 2.0 / (bank_.joints + 1);
    const auto creep = [&](Gene& gene) {
      if (random_.Chance(std::min(chance, 1.0))) gene = Creep(gene);
    };
    for (int joint = 0; joint < bank_.joints; ++joint) creep(child_[bank_.Target(rule, joint)]);
    creep(child_[bank_.Tau(rule)]);
  }

  void MoveStimulus(int rule) {
    std::vector<int> used;
    for (int sense = 0; sense < bank_.senses; ++sense) {
      if (bank_.Cares(child_, rule, sense)) used.push_back(sense);
    }
    const auto any_used = [&] {
      return used[static_cast<std::size_t>(Below(static_cast<int>(used.size())))];
    };
    if (!used.empty() && random_.Chance(0.7)) {
      MoveEnds(rule, any_used());
    } else if (used.size() > 1 && random_.Chance(0.5)) {
      const int sense = any_used();
      child_[bank_.Low(rule, sense)] = 0;
      child_[bank_.High(rule, sense)] = kGeneMax;
    } else {
      std::vector<const Sighting*> of_rule;
      for (const Sighting& sighting : sightings_) {
        if (sighting.rule == rule) of_rule.push_back(&sighting);
      }
      if (of_rule.empty()) return;
      const Sighting& at = *of_rule[static_cast<std::size_t>(Below(static_cast<int>(of_rule.size())))];
      BoxAround(at, rule, Below(bank_.senses), 0.05);
    }
  }

  /// Moves the low end, the high end, both, or widens: with chances 2, 2, 1, 1 of 6.
  void MoveEnds(int rule, int sense) {
    Gene& low = child_[bank_.Low(rule, sense)];
    Gene& high = child_[bank_.High(rule, sense)];
    const int what = Below(6);
    const double by = step_ * random_.Normal();
    const double at_low = low * (1.0 / kGeneMax), at_high = high * (1.0 / kGeneMax);
    if (what != 2 && what != 3) low = GeneOf(what == 5 ? at_low - by : at_low + by);
    if (what > 1) high = GeneOf(at_high + by);
    if (low > high) std::swap(low, high);
  }

  /// Limits a sense to a box around what was sensed. @param tight least half-width, of a physical sense's
  /// range from 0 to 1; its genes span 1.5 times as much
  void BoxAround(const Sighting& at, int rule, int sense, double tight) {
    const double middle = at.senses[static_cast<std::size_t>(sense)] * (1.0 / kGeneMax);
    const double half = LogUniform(tight, 10.0, random_) * (1.0 / 1.5);
    child_[bank_.Low(rule, sense)] = GeneOf(middle - half);
    child_[bank_.High(rule, sense)] = GeneOf(middle + half);
  }

  /// A rule that does not act becomes one at a state that the motion passes. Its response is that of the rule
  /// acting there, changed.
  void PlaceRule() {
    std::vector<int> idle;
    for (int rule = 1; rule < bank_.rules; ++rule) {
      if (acts_[static_cast<std::size_t>(rule)] == 0) idle.push_back(rule);
    }
    if (idle.empty() || sightings_.empty()) return;
    const int rule = idle[static_cast<std::size_t>(Below(static_cast<int>(idle.size())))];
    const Sighting& at = sightings_[static_cast<std::size_t>(Below(static_cast<int>(sightings_.size())))];
    IgnoreAll(child_, bank_, rule);
    for (int count = 1 + Below(4); count > 0; --count) {
      const bool of_joint = bank_.joints > 0 && bank_.joints < bank_.senses && random_.Chance(0.5);
      BoxAround(at, rule, Below(of_joint ? bank_.joints : bank_.senses), 0.03);
    }
    const auto respond = [&](Gene& gene, Gene model) {
      gene = random_.Chance(kRedrawResponse) ? random_.Gene() : Creep(model);
    };
    for (int joint = 0; joint < bank_.joints; ++joint) {
      respond(child_[bank_.Target(rule, joint)], child_[bank_.Target(at.rule, joint)]);
    }
    respond(child_[bank_.Tau(rule)], child_[bank_.Tau(at.rule)]);
  }

  Genome child_;
  std::span<const Sighting> sightings_;
  const BankShape& bank_;
  RandomStream& random_;
  std::vector<int> acts_;        // sightings in which each rule acts
  std::vector<double> chances_;  // cumulative, of each rule
  double step_ = 0.0;            // standard deviation of a creeping gene, as a share of its range
};

}  // namespace

Genome MoveRules(const Genome& parent, std::span<const Sighting> sightings, const BankShape& bank,
                 RandomStream& random) {
  Mover mover(parent, sightings, bank, random);
  do {
    mover.MoveOnce();
  } while (mover.Child() == parent || random.Chance(kMore));
  return mover.Child();
}

}  // namespace gaitsmith
