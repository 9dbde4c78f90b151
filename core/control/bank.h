// SPDX-License-Identifier: MIT
// W decoded stimulus-response banks side by side, and the choice of the active rule in each lane.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/control/sense_reader.h"
#include "core/control/stimulus_response.h"
#include "core/numeric/lane.h"
#include "core/numeric/scalar_math.h"
#include "core/signal/actuator_targets.h"

namespace gaitsmith {

template <int W>
class Bank {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  /// @param genomes 1 to W of them, all of this shape; missing lanes repeat the last one
  /// @param ports with shape.joints actuators
  /// @param step_s  time step, for the decay of responses
  Bank(const BankShape& shape, const SenseSpec& senses, std::span<const std::span<const Gene>> genomes,
       const Ports& ports, float step_s)
      : senses_(senses), shape_(shape), reader_(senses, ports, step_s) {
    const auto rules = static_cast<std::size_t>(shape.rules);
    targets_.resize(rules * static_cast<std::size_t>(shape.joints));
    decay_.resize(rules);
    inverse_tau_.resize(rules);
    for (int lane = 0; lane < W; ++lane) {
      const auto& genes = genomes[std::min(static_cast<std::size_t>(lane), genomes.size() - 1)];
      DecodeResponses(genes, ports.actuator_range, step_s, lane);
    }
    for (int rule = 0; rule < shape.rules; ++rule) {
      const std::size_t before = intervals_.size();
      for (int sense = 0; sense < shape.senses; ++sense) AddInterval(genomes, rule, sense);
      intervals_of_[static_cast<std::size_t>(rule)] = intervals_.size() - before;
    }
    if (senses.kind == SenseKind::kTimer) TableChoices();
  }

  [[nodiscard]] const SenseSpec& Senses() const { return senses_; }
  [[nodiscard]] int Rules() const { return shape_.rules; }

  /// The rule whose stimulus contains the senses with the greatest depth. The present rule stays active if no
  /// stimulus contains them. Of rules with equal depth the first one wins.
  [[nodiscard]] I Choose(const SenseVector<W>& senses, I present) const {
    I chosen = present;
    F least = L::Splat(kJustOutside);
    I number{};
    const Interval* interval = intervals_.data();
    for (std::size_t rule = 0; rule < static_cast<std::size_t>(shape_.rules); ++rule) {
      F off{};  // distance from the middle of the stimulus: 1 - depth
      for (const Interval* end = interval + intervals_of_[rule]; interval != end; ++interval) {
        const F sense = senses[interval->sense];
        off = L::Max(L::Abs(sense - interval->middle) * interval->inverse_half_width, off);
      }
      chosen = L::Select(off < least, number, chosen);
      least = L::Min(least, off);
      number += 1;
    }
    return chosen;
  }

  /// The numbers that Choose compares. Calls back with (rule, sense, off) for every interval that this lane's
  /// rules use, in order. off = |S - mid| / half-width, at most 1 inside the interval.
  template <class Visit>
  void Measure(const SenseVector<W>& senses, int lane, Visit visit) const {
    const Interval* interval = intervals_.data();
    for (std::size_t rule = 0; rule < static_cast<std::size_t>(shape_.rules); ++rule) {
      for (const Interval* end = interval + intervals_of_[rule]; interval != end; ++interval) {
        const F off = L::Abs(senses[interval->sense] - interval->middle) * interval->inverse_half_width;
        if (L::At(interval->inverse_half_width, lane) > 0.0f) {
          visit(static_cast<int>(rule), static_cast<int>(interval->sense), L::At(off, lane));
        }
      }
    }
  }

  /// The intervals of one lane as Choose uses them. Calls back with (rule, sense, middle, 1 / half-width) for
  /// every interval that this lane's rules use, in order.
  template <class Visit>
  void ForEachInterval(int lane, Visit visit) const {
    const Interval* interval = intervals_.data();
    for (std::size_t rule = 0; rule < static_cast<std::size_t>(shape_.rules); ++rule) {
      for (const Interval* end = interval + intervals_of_[rule]; interval != end; ++interval) {
        const float inverse = L::At(interval->inverse_half_width, lane);
        if (inverse > 0.0f) {
          visit(static_cast<int>(rule), static_cast<int>(interval->sense), L::At(interval->middle, lane),
                inverse);
        }
      }
    }
  }

  /// The rules that a timer chooses at a phase, from a table, because they depend on the phase alone. -1 if
  /// no stimulus contains the phase, so that the present rule stays active. Only for banks with a timer.
  /// @param phase step within the period, [0, period_steps)
  [[nodiscard]] const I& ChoiceAt(int phase) const { return choice_at_[static_cast<std::size_t>(phase)]; }

  /// Reads the senses and chooses the active rule of each lane.
  /// @param steps   since the bank took over
  /// @param senses  out: the senses that the bank reads
  /// @param present the rules active so far
  [[nodiscard]] I Decide(const Readings<W>& readings, int steps, const I& present,
                         SenseVector<W>& senses) const {
    if (senses_.kind == SenseKind::kTimer) {
      const int phase = steps % senses_.period_steps;
      senses[0] = L::Splat(TimerSense(phase, senses_.period_steps));
      const I& choice = ChoiceAt(phase);
      return L::Select(choice < 0, present, choice);
    }
    reader_.Read(readings, senses);
    return Choose(senses, present);
  }

  /// Writes the response of one lane's rule to the targets.
  void Respond(int rule, int lane, ActuatorTargets<W>& targets) const {
    const auto r = static_cast<std::size_t>(rule);
    const auto joints = static_cast<std::size_t>(shape_.joints);
    for (std::size_t j = 0; j < joints; ++j) {
      L::Put(targets.target[j], lane, L::At(targets_[r * joints + j], lane));
      L::Put(targets.decay[j], lane, L::At(decay_[r], lane));
      L::Put(targets.inverse_tau[j], lane, L::At(inverse_tau_[r], lane));
    }
  }

 private:
  /// The smallest float above 1, so that a stimulus includes its border.
  static constexpr float kJustOutside = 1.00000011920928955078125f;

  struct Interval {
    F middle;
    F inverse_half_width;  // 0 in lanes that do not use this sense, so that it is never the largest distance
    std::size_t sense;
  };

  /// Computes the same as Choose, lane by lane and rule by rule, over the phases that each rule can contain.
  void TableChoices() {
    const int period = senses_.period_steps;
    choice_at_.assign(static_cast<std::size_t>(period), I{} - 1);
    std::vector<float> least(static_cast<std::size_t>(period));
    for (int lane = 0; lane < W; ++lane) {
      least.assign(least.size(), kJustOutside);
      const Interval* interval = intervals_.data();
      for (int rule = 0; rule < shape_.rules; ++rule) {
        // Without an interval, no lane uses the timer.
        const bool stored = intervals_of_[static_cast<std::size_t>(rule)] > 0;
        const float middle = stored ? interval->middle[lane] : 0.0f;
        const float inverse = stored ? interval->inverse_half_width[lane] : 0.0f;
        if (stored) ++interval;
        int first = 0, end = period;
        if (inverse > 0.0f) {
          // One phase more on either side than the interval contains, so that rounding here has no effect.
          first = std::max(0, static_cast<int>((middle - 1.0f / inverse) * static_cast<float>(period)) - 1);
          end =
              std::min(period, static_cast<int>((middle + 1.0f / inverse) * static_cast<float>(period)) + 2);
        }
        for (int phase = first; phase < end; ++phase) {
          const auto p = static_cast<std::size_t>(phase);
          const float from_middle = TimerSense(phase, period) - middle;
          const float off = (from_middle < 0.0f ? -from_middle : from_middle) * inverse;
          if (!(off < least[p])) continue;
          least[p] = off;
          choice_at_[p][lane] = rule;
        }
      }
    }
  }

  void DecodeResponses(std::span<const Gene> genes, std::span<const std::array<float, 2>> limits,
                       float step_s, int lane) {
    for (int rule = 0; rule < shape_.rules; ++rule) {
      const auto r = static_cast<std::size_t>(rule);
      const float tau = DecodeTau(genes[shape_.Tau(rule)], senses_);
      decay_[r][lane] = static_cast<float>(Exp(-static_cast<double>(step_s) / static_cast<double>(tau)));
      inverse_tau_[r][lane] = 1.0f / tau;
      for (int joint = 0; joint < shape_.joints; ++joint) {
        const auto j = static_cast<std::size_t>(joint);
        targets_[r * static_cast<std::size_t>(shape_.joints) + j][lane] =
            Decode(genes[shape_.Target(rule, joint)], limits[j][0], limits[j][1]);
      }
    }
  }

  void AddInterval(std::span<const std::span<const Gene>> genomes, int rule, int sense) {
    Interval interval{F{}, F{}, static_cast<std::size_t>(sense)};
    bool any_cares = false;
    const auto [edge_low, edge_high] = EdgesOf(senses_.kind);
    // Half a grid cell, so that a stimulus of a single point can still be matched.
    const float least_half_width = (edge_high - edge_low) * (0.5f / 65535.0f);
    for (int lane = 0; lane < W; ++lane) {
      const auto& genes = genomes[std::min(static_cast<std::size_t>(lane), genomes.size() - 1)];
      if (!shape_.Cares(genes, rule, sense)) continue;
      any_cares = true;
      const float low = Decode(genes[shape_.Low(rule, sense)], edge_low, edge_high);
      const float high = Decode(genes[shape_.High(rule, sense)], edge_low, edge_high);
      const float half_width = 0.5f * (high - low);
      interval.middle[lane] = 0.5f * (low + high);
      interval.inverse_half_width[lane] =
          1.0f / (half_width > least_half_width ? half_width : least_half_width);
    }
    if (any_cares) intervals_.push_back(interval);
  }

  SenseSpec senses_;
  BankShape shape_;
  SenseReader<W> reader_;
  std::vector<Interval> intervals_;  // of all rules in order, only those that some lane uses
  std::array<std::size_t, kMaxRules> intervals_of_{};
  std::vector<I> choice_at_;    // (period_steps), only with a timer
  std::vector<F> targets_;      // [rad] (rules x joints)
  std::vector<F> decay_;        // (rules)
  std::vector<F> inverse_tau_;  // [1/s] (rules)
};

}  // namespace gaitsmith
