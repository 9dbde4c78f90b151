// SPDX-License-Identifier: MIT
// Pins: the trajectory hash of every document in tests/golden, in examples/, in its gallery and its lessons,
// and the scores of forty searches. The same file runs natively with gcc and clang, at several optimisation
// levels, under sanitizers and as WASM under Node. Does not pin: how the motions look. To bless again (only
// by a numbered decision in docs/design.md):
//   tests/golden/bless build/release/shell/gaitsmith build/dev/tests/gaitsmith_tests
// Has caught: nothing yet.
#include <algorithm>
#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "core/rollout/evaluator.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

TEST_CASE("golden: every motion keeps its hash, in every lane", "[golden][determinism]") {
  auto names = GoldenMotions();
  REQUIRE(names.size() >= 8);
  const auto limited = GoldenLimitedMotions();
  REQUIRE(limited.size() >= 3);
  names.insert(names.end(), limited.begin(), limited.end());
  const auto springs = GoldenSpringMotions();
  REQUIRE(springs.size() >= 5);
  names.insert(names.end(), springs.begin(), springs.end());
  for (const std::string& name : names) {
    CAPTURE(name);
    const auto document = DecodeJson(ReadFile(name));
    REQUIRE(document);
    REQUIRE(document->hash);
    CHECK(HashText(Simulate(*document).Hash()) == HashText(*document->hash));
    if (document->timeline.size() != 1) continue;
    const Controller& controller =
        document->controllers[static_cast<std::size_t>(document->timeline[0].controller)];
    const Problem problem = ReplayProblem(*document, controller);
    for (const int lanes : Evaluator::kLaneCounts) {
      // Next to other genomes, so that any influence between lanes would show.
      std::vector<Genome> genomes(static_cast<std::size_t>(lanes), controller.genes);
      for (std::size_t lane = 0; lane < genomes.size(); lane += 2) {
        if (lane + 1 == genomes.size()) break;
        genomes[lane] = RandomController(document->figure, controller.senses, lane).genes;
        genomes[lane].resize(controller.genes.size(), kGeneMax / 2);
      }
      const auto results = Evaluator(problem, lanes, true).Evaluate(genomes);
      for (std::size_t lane = 0; lane < genomes.size(); ++lane) {
        CAPTURE(lanes, lane);
        if (genomes[lane] == controller.genes) {
          REQUIRE(HashText(results[lane].trajectory_hash) == HashText(*document->hash));
        }
      }
    }
  }
}

TEST_CASE("golden: every shipped motion keeps its hash, alone and among searchers", "[golden][determinism]") {
  int hashes = 0;
  for (const std::string& name : ShippedDocuments()) {
    CAPTURE(name);
    const auto document = DecodeJson(ReadFile(name));
    REQUIRE(document);
    if (!document->hash) continue;
    ++hashes;
    CHECK(HashText(Simulate(*document).Hash()) == HashText(*document->hash));
    if (document->timeline.size() != 1) continue;
    const Controller& controller =
        document->controllers[static_cast<std::size_t>(document->timeline[0].controller)];
    const std::vector<Genome> genomes = {controller.genes};
    const auto results = Evaluator(ReplayProblem(*document, controller), 4, true).Evaluate(genomes);
    CHECK(HashText(results[0].trajectory_hash) == HashText(*document->hash));
  }
  CHECK(hashes >= 44);
}

TEST_CASE("replay: a controller is what it is, whatever the document would search for", "[determinism]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.controllers = {RandomController(d.figure, d.senses, 5)};
  d.timeline = {{}};
  const std::uint64_t hash = Simulate(d).Hash();
  d.senses.velocity_mps = 5.0f;
  d.kind = ControllerKind::kNetwork;
  d.rules = 3;
  REQUIRE(Validate(d));
  CHECK(Simulate(d).Hash() == hash);
  const std::vector<Genome> genomes = {d.controllers[0].genes};
  CHECK(Evaluator(ReplayProblem(d, d.controllers[0]), true).Evaluate(genomes)[0].trajectory_hash == hash);
}

namespace {

float BestOf(Algorithm algorithm, SenseKind senses, std::uint32_t seed) {
  Document document = StarManTravel(senses);
  document.search.algorithm = algorithm;
  document.search.seed = seed;
  return RunSearchOf(document).fitness;
}

}  // namespace

TEST_CASE("golden: forty searches on Star-Man keep their scores, and SPHC beats RG&T by half",
          "[golden][search]") {
  struct Pinned {
    SenseKind senses;
    std::vector<float> rgt, sphc;  // best fitness after 4,000 evaluations, seeds 1 to 10
  };
  const std::vector<Pinned> pinned = {
#include "tests/golden/search_scores.inc"
  };
  for (const Pinned& row : pinned) {
    std::vector<float> rgt, sphc;
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
      rgt.push_back(BestOf(Algorithm::kRandomSearch, row.senses, seed));
      sphc.push_back(BestOf(Algorithm::kSphc, row.senses, seed));
    }
    CHECK(rgt == row.rgt);
    CHECK(sphc == row.sphc);
    const auto median = [](std::vector<float> scores) {
      std::ranges::sort(scores);
      return 0.5f * (scores[4] + scores[5]);
    };
    CAPTURE(median(rgt), median(sphc));
    CHECK(median(sphc) >= 1.5f * median(rgt));
  }
}

}  // namespace gaitsmith::test
