// SPDX-License-Identifier: MIT
// A person's taste, learned from comparisons of two motions. The chance that one is preferred is
// the logistic function of the difference of their worths [Bradley Terry 1952], and the worth is linear in
// the traits, as in learning a reward from preferences [Sadigh 2017]. Weights have a Gaussian prior. Their
// posterior is approximated by a Gaussian at its maximum (Laplace), which gives a doubt for each weight.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/signal/traits.h"

namespace gaitsmith {

enum class Verdict { kFirst, kSecond, kNeither };
inline constexpr std::array<std::string_view, 3> kVerdictNames = {"first", "second", "neither"};

struct Comparison {
  Traits first{}, second{};
  Verdict verdict = Verdict::kNeither;
};

class Taste {
 public:
  /// @param comparisons any number of them, in any order; their traits are finite. The order changes only
  /// rounding
  explicit Taste(std::span<const Comparison> comparisons);

  /// How much more likely, in log-odds, a motion is preferred that plainly has more of each trait (a
  /// TraitRow's scale). 0 if nothing is known.
  [[nodiscard]] const Traits& Weights() const { return weights_; }
  /// Standard deviation of each weight; kPriorDoubt if nothing is known, more if the shown motions differ too
  /// little in the trait to show a preference of plain differences.
  [[nodiscard]] const Traits& Doubts() const { return doubts_; }
  /// The chance that the first motion is preferred to the second, (0, 1), without regard to doubt.
  [[nodiscard]] float ChanceOfFirst(const Traits& first, const Traits& second) const;

  /// How much the answer would tell about the weights, in nats: half the logarithm of 1 + p (1 − p) v, where
  /// v is the variance of the difference's worth [Houlsby 2011]. At least 0; 0 for two motions that look
  /// alike.
  [[nodiscard]] float Telling(const Traits& first, const Traits& second) const;

  /// Standard deviation of each weight before the first comparison.
  static constexpr float kPriorDoubt = 2.0f;

 private:
  Traits weights_{}, doubts_{};
  std::array<Traits, kTraits> covariance_{};
};

}  // namespace gaitsmith
