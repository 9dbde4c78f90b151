// SPDX-License-Identifier: MIT
// Children move, look different from one another, keep what is locked, are better at the goal than at birth,
// and are the same however the batches are cut.
#include "core/breeding/brood.h"

#include "core/document/json.h"
#include "core/search/evaluation_score.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {
namespace {

constexpr int kRound = 2000;

struct Round {
  Problem problem;
  SearchSpace space;
  SearchSettings settings;
  BreedWish wish;

  /// A round of breeding from the first controller of a document of the repository.
  explicit Round(const std::string& path, std::uint32_t seed = 1)
      : Round(*DecodeJson(ReadFile(path)), seed) {}
  Round(const Document& d, std::uint32_t seed) : problem(Looked(d)), space(SpaceOf(problem)) {
    settings.seed = seed;
    settings.evaluations = kRound;
    wish.parents = {d.controllers.front().genes};
  }
  static Problem Looked(const Document& d) {
    Problem problem = ReplayProblem(d, d.controllers.front());
    problem.traits = true;
    return problem;
  }
  [[nodiscard]] Brood Make() const { return {settings, space, wish}; }
};

std::vector<Score> Scored(const Evaluator& evaluator, const std::vector<Genome>& genomes) {
  std::vector<Score> scores;
  for (const Evaluation& one : evaluator.Evaluate(genomes)) scores.push_back(ScoreOf(one));
  return scores;
}

Brood Bred(const Round& round, int wanted = 40) {
  Brood brood = round.Make();
  const Evaluator evaluator(round.problem);
  while (!brood.Done()) brood.Tell(Scored(evaluator, brood.Ask(wanted)));
  return brood;
}

bool Same(const std::vector<Brood::Member>& a, const std::vector<Brood::Member>& b) {
  return std::ranges::equal(a, b, [](const Brood::Member& one, const Brood::Member& other) {
    return one.genome == other.genome && one.fitness == other.fitness && one.traits == other.traits;
  });
}

float MedianFitness(const Brood& brood) {
  std::vector<float> fitness = brood.PopulationFitness();
  std::ranges::sort(fitness);
  return fitness[fitness.size() / 2];
}

std::vector<std::uint8_t> Saved(const Brood& brood) {
  BitWriter out;
  brood.Save(out);
  return out.Bytes();
}

const char* const kShuffle = "examples/star-man-shuffle.json";

}  // namespace

TEST_CASE("brood: nine children move, and no two look alike", "[search][brood][exhaustive]") {
  for (const std::string& path : GalleryDocuments()) {
    const Document d = *DecodeJson(ReadFile(path));
    if (d.timeline.size() != 1) continue;
    CAPTURE(path);
    Round round(d, 1);
    round.wish.difference = 0.1f;  // the less room there is, the harder
    const Brood brood = Bred(round);
    REQUIRE(brood.Children().size() == 9);
    for (std::size_t i = 0; i < 9; ++i) {
      const Traits& traits = brood.Children()[i].traits;
      CHECK(brood.Children()[i].fitness > kNoMotion);
      CHECK(TraitOf(traits, Trait::kStill) < 0.7f);
      CHECK(TraitDistance(traits, brood.Parents().front().traits) > 0.1f);
      for (std::size_t k = 0; k < i; ++k) CHECK(TraitDistance(traits, brood.Children()[k].traits) > 0.1f);
    }
  }
}

TEST_CASE("brood: the same children however the batches are cut, and after a pause", "[search][brood]") {
  Round round(kShuffle);
  round.settings.evaluations = 700;
  const Brood whole = Bred(round, 40);
  CHECK(Same(whole.Children(), Bred(round, 1).Children()));
  CHECK(Same(whole.Children(), Bred(round, 1000).Children()));
  const Evaluator evaluator(round.problem);
  Brood before = round.Make();
  while (!before.Done()) {
    before.Tell(Scored(evaluator, before.Ask(33)));
    Brood after = round.Make();
    const std::vector<std::uint8_t> state = Saved(before);
    BitReader in(state);
    REQUIRE(after.Load(in));
    CHECK(Saved(after) == state);
    before = std::move(after);
  }
  CHECK(Same(whole.Children(), before.Children()));
}

TEST_CASE("brood: another seed has other children", "[search][brood]") {
  Round one(kShuffle, 1), two(kShuffle, 2);
  one.settings.evaluations = two.settings.evaluations = 400;
  CHECK_FALSE(Same(Bred(one).Children(), Bred(two).Children()));
}

TEST_CASE("brood: children become better at the goal than they were born", "[search][brood]") {
  Round round(kShuffle);
  round.settings.evaluations = 400;
  const float young = MedianFitness(Bred(round));
  round.settings.evaluations = kRound;
  CHECK(MedianFitness(Bred(round)) > young);
}

TEST_CASE("brood: a greater difference means children that are further from their parent",
          "[search][brood]") {
  const auto distance = [](float difference) {
    Round round(kShuffle);
    round.wish.difference = difference;
    const Brood brood = Bred(round);
    float sum = 0.0f;
    for (const Brood::Member& child : brood.Children())
      sum += TraitDistance(child.traits, brood.Parents().front().traits);
    return sum / static_cast<float>(brood.Children().size());
  };
  CHECK(distance(0.9f) > 1.3f * distance(0.05f));
}

TEST_CASE("brood: kept rules and joints are as in the parent", "[search][brood]") {
  Round round(kShuffle);
  round.wish.kept_rules = {0, 3};
  round.wish.kept_joints = {1};
  round.settings.evaluations = 800;
  const Brood brood = Bred(round);
  const BankShape& bank = round.space.shape.Bank();
  const Genome& parent = round.wish.parents.front();
  REQUIRE(brood.Children().size() == 9);
  for (const Brood::Member& child : brood.Children()) {
    for (const int rule : round.wish.kept_rules) {
      for (std::size_t at = round.space.shape.Begin(rule); at < round.space.shape.Begin(rule + 1); ++at)
        REQUIRE(child.genome[at] == parent[at]);
    }
    for (int rule = 0; rule < bank.rules; ++rule)
      REQUIRE(child.genome[bank.Target(rule, 1)] == parent[bank.Target(rule, 1)]);
    CHECK(child.genome != parent);
  }
}

TEST_CASE("brood: a goal that is kept has better children", "[search][brood]") {
  Round round(kShuffle);
  round.wish.difference = 0.8f;
  round.settings.evaluations = 600;
  const float free = MedianFitness(Bred(round));
  round.wish.keep_goal = true;
  CHECK(MedianFitness(Bred(round)) > free);
}

TEST_CASE("brood: two parents have hybrids", "[search][brood]") {
  Round round(kShuffle);
  const Brood first = Bred(round);
  round.wish.parents = {first.Children()[0].genome, first.Children()[5].genome};
  round.settings.evaluations = 300;
  const Brood second = Bred(round);
  const BankShape& bank = round.space.shape.Bank();
  const auto rules_of = [&](const Genome& child, const Genome& parent) {
    int same = 0;
    for (int rule = 0; rule < bank.rules; ++rule) {
      const auto begin = static_cast<std::ptrdiff_t>(round.space.shape.Begin(rule));
      const auto end = static_cast<std::ptrdiff_t>(round.space.shape.Begin(rule + 1));
      same += std::equal(child.begin() + begin, child.begin() + end, parent.begin() + begin) ? 1 : 0;
    }
    return same;
  };
  int hybrids = 0;
  for (const Brood::Member& child : second.Children()) {
    const int of_first = rules_of(child.genome, round.wish.parents[0]);
    const int of_second = rules_of(child.genome, round.wish.parents[1]);
    const int of_both = rules_of(round.wish.parents[0], round.wish.parents[1]);
    hybrids += of_first > of_both && of_second > of_both ? 1 : 0;
  }
  CHECK(hybrids >= 1);
}

TEST_CASE("brood: networks, a single rod and a figure that cannot move", "[search][brood]") {
  Round round(kShuffle);
  round.problem.kind = ControllerKind::kNetwork;
  round.space = SpaceOf(round.problem);
  RandomStream random(1, 2, 3);
  round.wish.parents = {RandomGenome(round.space.shape, round.problem.senses, Variation{}, random)};
  round.settings.evaluations = 600;
  CHECK(!Bred(round).Children().empty());

  round.problem.kind = ControllerKind::kRules;
  round.problem.figure = LyingRod();
  round.problem.traits = true;
  round.space = SpaceOf(round.problem);
  round.wish.parents = {RandomGenome(round.space.shape, round.problem.senses, Variation{}, random)};
  const Brood lying = Bred(round);
  CHECK(lying.Done());
  CHECK(lying.Children().empty());
}

TEST_CASE("brood: a state that is not one is refused and changes nothing", "[search][brood]") {
  Round round(kShuffle);
  round.settings.evaluations = 500;
  const std::vector<std::uint8_t> state = Saved(Bred(round));
  Brood fresh = round.Make();
  const std::vector<std::uint8_t> before = Saved(fresh);
  const std::vector<std::uint8_t> half(state.begin(),
                                       state.begin() + static_cast<std::ptrdiff_t>(state.size() / 2));
  BitReader cut(half);
  CHECK_FALSE(fresh.Load(cut));
  CHECK(Saved(fresh) == before);
  round.wish.children = 3;  // the state has nine
  Brood smaller = round.Make();
  BitReader in(state);
  CHECK_FALSE(smaller.Load(in));
}

}  // namespace gaitsmith::test
