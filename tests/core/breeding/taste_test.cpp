// SPDX-License-Identifier: MIT
// A hidden taste is found again from comparisons, doubt falls with their number, and what contradicts itself
// says nothing.
#include "core/breeding/taste.h"

#include <catch_amalgamated.hpp>

#include "core/breeding/taste_weights.h"
#include "core/document/standing.h"
#include "core/numeric/random.h"
#include "core/numeric/scalar_math.h"
#include "tests/scene.h"

namespace gaitsmith::test {
namespace {

Traits RandomTraits(RandomStream& random) {
  Traits traits{};
  for (std::size_t i = 0; i < kTraits; ++i)
    traits[i] = static_cast<float>(random.Normal()) * kTraitTable[i].scale;
  return traits;
}

double Worth(const Traits& weights, const Traits& traits) {
  double worth = 0.0;
  for (std::size_t i = 0; i < kTraits; ++i)
    worth += static_cast<double>(weights[i] * traits[i] / kTraitTable[i].scale);
  return worth;
}

/// Random comparisons by a person with these weights and the model's errors.
std::vector<Comparison> ComparedBy(const Traits& weights, int count, std::uint64_t seed) {
  std::vector<Comparison> comparisons;
  RandomStream random(seed, 0, 0);
  for (int i = 0; i < count; ++i) {
    Comparison one{RandomTraits(random), RandomTraits(random), Verdict::kSecond};
    const double better = Worth(weights, one.first) - Worth(weights, one.second);
    if (random.Chance(1.0 / (1.0 + Exp(-better)))) one.verdict = Verdict::kFirst;
    comparisons.push_back(one);
  }
  return comparisons;
}

Traits With(Trait trait, float weight) {
  Traits weights{};
  weights[static_cast<std::size_t>(trait)] = weight;
  return weights;
}

}  // namespace

TEST_CASE("taste: without a comparison nothing is known", "[taste]") {
  const Taste taste({});
  for (std::size_t i = 0; i < kTraits; ++i) {
    CHECK(taste.Weights()[i] == 0.0f);
    CHECK(taste.Doubts()[i] == Catch::Approx(Taste::kPriorDoubt));
  }
  RandomStream random(1, 2, 3);
  CHECK(taste.ChanceOfFirst(RandomTraits(random), RandomTraits(random)) == 0.5f);
}

TEST_CASE("taste: one comparison has the posterior of its closed form", "[taste]") {
  // One trait differs by d scales. The weight at the maximum solves w = s^2 d (1 - logistic(w d)).
  Comparison one;
  one.first = With(Trait::kTurns, 1.5f * kTraitTable[static_cast<std::size_t>(Trait::kTurns)].scale);
  one.verdict = Verdict::kFirst;
  const Taste taste(std::span(&one, 1));
  const double w = static_cast<double>(TraitOf(taste.Weights(), Trait::kTurns)), d = 1.5;
  const double left = 1.0 - 1.0 / (1.0 + Exp(-w * d));
  CHECK(w == Catch::Approx(4.0 * d * left).epsilon(1e-4));
  const double precision = 0.25 + d * d * left * (1.0 - left);
  CHECK(static_cast<double>(TraitOf(taste.Doubts(), Trait::kTurns)) ==
        Catch::Approx(1.0 / std::sqrt(precision)).epsilon(1e-4));
  CHECK(TraitOf(taste.Weights(), Trait::kSlip) == 0.0f);
  CHECK(TraitOf(taste.Doubts(), Trait::kSlip) == Catch::Approx(2.0f));
}

TEST_CASE("taste: hidden weights are found again within their doubt", "[taste]") {
  RandomStream random(7, 7, 7);
  int within = 0, all = 0;
  for (std::uint64_t person = 0; person < 20; ++person) {
    Traits hidden{};
    for (float& weight : hidden) weight = static_cast<float>(random.Normal());
    const Taste taste(ComparedBy(hidden, 400, 100 + person));
    for (std::size_t i = 0; i < kTraits; ++i, ++all)
      within += std::abs(taste.Weights()[i] - hidden[i]) < 2.0f * taste.Doubts()[i] ? 1 : 0;
  }
  CHECK(within >= all * 9 / 10);  // two standard deviations: 95 %
}

TEST_CASE("taste: more comparisons, less doubt, and better guesses", "[taste]") {
  Traits hidden = With(Trait::kTurns, 2.0f);
  hidden[static_cast<std::size_t>(Trait::kSlip)] = -2.0f;
  const std::vector<Comparison> fresh = ComparedBy(hidden, 500, 9);
  const auto right = [&](const Taste& taste) {
    int count = 0;
    for (const Comparison& one : fresh)
      count +=
          (taste.ChanceOfFirst(one.first, one.second) > 0.5f) == (one.verdict == Verdict::kFirst) ? 1 : 0;
    return count;
  };
  const Taste few(ComparedBy(hidden, 10, 8)), many(ComparedBy(hidden, 200, 8));
  CHECK(right(many) > right(few));
  CHECK(right(many) > 400);
  for (std::size_t i = 0; i < kTraits; ++i) CHECK(many.Doubts()[i] < few.Doubts()[i]);
}

TEST_CASE("taste: exchanging the motions of every comparison changes nothing", "[taste]") {
  const std::vector<Comparison> comparisons = ComparedBy(With(Trait::kAir, 3.0f), 50, 4);
  std::vector<Comparison> exchanged = comparisons;
  for (Comparison& one : exchanged) {
    std::swap(one.first, one.second);
    one.verdict = one.verdict == Verdict::kFirst ? Verdict::kSecond : Verdict::kFirst;
  }
  const Taste taste(comparisons), other(exchanged);
  for (std::size_t i = 0; i < kTraits; ++i)
    CHECK(taste.Weights()[i] == Catch::Approx(other.Weights()[i]).margin(1e-5));
}

TEST_CASE("taste: contradictions, neither, and the same motion twice say that nothing is preferred",
          "[taste]") {
  RandomStream random(5, 5, 5);
  const Traits a = RandomTraits(random), b = RandomTraits(random);
  const std::vector<Comparison> contradictory(40, {a, b, Verdict::kFirst});
  std::vector<Comparison> both = contradictory;
  for (const Comparison& one : contradictory) both.push_back({one.first, one.second, Verdict::kSecond});
  CHECK(Taste(both).ChanceOfFirst(a, b) == Catch::Approx(0.5f));
  const std::vector<Comparison> neither(40, {a, b, Verdict::kNeither});
  CHECK(Taste(neither).ChanceOfFirst(a, b) == Catch::Approx(0.5f));
  // Unlike no comparison at all, it is known.
  CHECK(Taste(neither).Telling(a, b) < 0.1f * Taste({}).Telling(a, b));
  const std::vector<Comparison> alike(40, {a, a, Verdict::kFirst});
  CHECK(Taste(alike).Weights() == Traits{});
}

TEST_CASE("taste: a small difference that decides is found among large ones that do not", "[taste]") {
  // As with the first children of a motion that does not turn: all turn little, and they lie in all ways.
  RandomStream random(3, 1, 4);
  std::vector<Comparison> comparisons;
  for (int i = 0; i < 60; ++i) {
    Comparison one{RandomTraits(random), RandomTraits(random), Verdict::kFirst};
    float& first = one.first[static_cast<std::size_t>(Trait::kTurns)];
    float& second = one.second[static_cast<std::size_t>(Trait::kTurns)];
    first *= 0.2f;
    second *= 0.2f;
    if (first < second) one.verdict = Verdict::kSecond;
    comparisons.push_back(one);
  }
  const Taste taste(comparisons);
  CHECK(SureOf(taste, Trait::kTurns));
  for (std::size_t i = 0; i < kTraits; ++i) {
    if (i == static_cast<std::size_t>(Trait::kTurns)) continue;
    CHECK(std::abs(taste.Weights()[i]) < 0.5f * TraitOf(taste.Weights(), Trait::kTurns));
  }
}

TEST_CASE("taste: thousands of unanimous comparisons stay finite", "[taste]") {
  Comparison one;
  one.first = With(Trait::kSpeed, 1e6f);
  one.verdict = Verdict::kFirst;
  const std::vector<Comparison> all(5000, one);
  const Taste taste(all);
  CHECK(TraitOf(taste.Weights(), Trait::kSpeed) > 1.0f);
  CHECK(TraitOf(taste.Weights(), Trait::kSpeed) < 20.0f);
}

TEST_CASE("taste: its weights order motions of a document as the taste does", "[taste]") {
  Document d = Standing(ShippedFigure("ostrich"));
  // A plain difference in speed is worth as much as one in turns, and slip is as bad.
  Traits liked = With(Trait::kSpeed, 2.0f);
  liked[static_cast<std::size_t>(Trait::kTurns)] = 2.0f;
  liked[static_cast<std::size_t>(Trait::kSlip)] = -2.0f;
  const Taste taste(ComparedBy(liked, 3000, 11));
  const auto weights = WeightsOf(taste, d);
  const float seconds = static_cast<float>(d.task.duration_steps) * kStep;
  // One scale of speed is size * seconds metres, one of turns seconds / 4 turns.
  const float metres = SizeOf(d.figure) * seconds, turns = 0.25f * seconds;
  CHECK(weights[static_cast<std::size_t>(StyleTerm::kRotations)] * turns ==
        Catch::Approx(metres).epsilon(0.25));
  CHECK(weights[static_cast<std::size_t>(StyleTerm::kSlipSum)] == Catch::Approx(-1.0f).epsilon(0.25));
  // A taste without interest in distance: documents have no weight for distance, but the other weights stay
  // in range.
  const auto lazy = WeightsOf(Taste(ComparedBy(With(Trait::kTurns, 3.0f), 400, 12)), d);
  CHECK(lazy[static_cast<std::size_t>(StyleTerm::kRotations)] >
        weights[static_cast<std::size_t>(StyleTerm::kRotations)]);
  d.task.weights = lazy;
  CHECK(Validate(d));
  d.task.kind = TaskKind::kJump;
  CHECK(WeightsOf(taste, d)[static_cast<std::size_t>(StyleTerm::kMaxCmHeight)] == 0.0f);
}

}  // namespace gaitsmith::test
