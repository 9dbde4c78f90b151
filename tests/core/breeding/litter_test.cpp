// SPDX-License-Identifier: MIT
// Children follow from a document's lineage: the same after any encoding, and as if they had been bred one
// round after the other. Wrong lineages are refused. Pins one family.
#include "core/breeding/litter.h"

#include <functional>
#include <utility>

#include "core/document/binary.h"
#include "core/document/joints.h"
#include "core/document/json.h"
#include "core/document/link.h"
#include "core/rollout/evaluator.h"
#include "core/search/evaluation_score.h"
#include "tests/litter.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {
namespace {

/// A document with a motion that was bred from: three rounds, the last two of them from the same parents.
Document Family() {
  Document d = *DecodeJson(ReadFile("examples/star-man-shuffle.json"));
  d.lineage.founders = {d.controllers.front()};
  Task slow = d.task;
  slow.weights[static_cast<std::size_t>(StyleTerm::kSlipSum)] = -0.5f;
  BreedRound first, second, third;
  first.task = third.task = d.task;
  second = {.name = "Hops", .parent = 0, .picks = 0b101, .seed = 7, .difference = 0.6f, .task = slow};
  third.parent = 0;
  third.picks = 0b101;
  third.seed = 8;
  third.keep_goal = true;
  third.kept_rules = 2;
  third.kept_joints = 1;
  d.lineage.rounds = {first, second, third};
  d.lineage.shown = 2;
  return d;
}

std::vector<Genome> Grown(const Document& nursery) {
  std::vector<Genome> children;
  for (const Brood::Member& child : ChildrenOf(nursery)) children.push_back(child.genome);
  return children;
}

std::uint64_t HashOf(const std::vector<Genome>& genomes) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const Genome& genome : genomes) {
    for (const Gene gene : genome) hash = (hash ^ gene) * 0x100000001b3u;
  }
  return hash;
}

std::string FaultOf(const std::function<void(Document&)>& edit) {
  Document d = Family();
  edit(d);
  const auto valid = Validate(d);
  return valid ? "" : valid.error().where + ": " + valid.error().what;
}

}  // namespace

TEST_CASE("litter: a family has the same children from every encoding", "[golden][determinism][breeding]") {
  const Document d = Family();
  const auto linked = DecodeLink(EncodeLink(d));
  REQUIRE(linked);
  const auto written = DecodeJson(EncodeJson(d));
  REQUIRE(written);
  CHECK(EncodeLink(*written) == EncodeLink(d));

  const auto first = NurseryOf(*linked, 0, {});
  REQUIRE(first);
  CHECK(Validate(*first));
  const std::vector<Genome> children = Grown(*first);
  REQUIRE(children.size() == kLitter);
  CHECK(HashText(HashOf(children)) == "f5455316ff56ce9b");

  const auto second = NurseryOf(*written, 2, children);
  REQUIRE(second);
  CHECK(second->lineage.founders.size() == 2);
  CHECK(second->lineage.founders[1].genes == children[2]);
  CHECK(HashText(HashOf(Grown(*second))) == "0d070b54a66ce7c7");
  // As if those two had been found elsewhere.
  Controller one = d.controllers.front(), two = one;
  one.genes = children[0];
  two.genes = children[2];
  CHECK(EncodeBinary(NurseryOf(d, {one, two}, d.lineage.rounds[2])) == EncodeBinary(*second));
}

TEST_CASE("litter: a nursery has no pushes, and its own goal", "[breeding]") {
  Document d = Family();
  d.pushes = {{.step = 10, .impulse_x_ns = 5.0f}};
  std::vector<Genome> children(kLitter, d.controllers.front().genes);
  const auto nursery = NurseryOf(d, 1, children);
  REQUIRE(nursery);
  CHECK(nursery->pushes.empty());
  CHECK(nursery->task.weights == d.lineage.rounds[1].task.weights);
  CHECK(nursery->controllers.empty());
  CHECK(NurseryProblem(*nursery).traits);
}

TEST_CASE("litter: limited joints stay limited, from pick to child", "[breeding]") {
  Document d = Family();
  d.model = 2;
  SetJointStrength(3.0f, d);
  REQUIRE(Validate(d));
  const auto nursery = NurseryOf(d, 0, {});
  REQUIRE(nursery);
  CHECK(nursery->model == 2);
  const Problem problem = NurseryProblem(*nursery);
  CHECK(problem.model == 2);
  CHECK(problem.figure.rods == d.figure.rods);
  for (const Brood::Member& member : ChildrenOf(*nursery)) {
    const Document child = ChildOf(d, member.genome);
    REQUIRE(Validate(child));
    CHECK(SameJoints(child, d));
    const Motion motion = Simulate(child);
    CHECK(motion.TermsAt(motion.Frames() - 1).travel_m != 0.0f);
    const auto found = Evaluator(problem).Evaluate(std::vector<Genome>{member.genome});
    CHECK(found[0].fitness == member.fitness);
  }
  // From a link the same children.
  const auto linked = DecodeLink(EncodeLink(d));
  REQUIRE(linked);
  CHECK(Grown(*NurseryOf(*linked, 0, {})) == Grown(*nursery));
}

TEST_CASE("litter: breeding keeps the body that a search may change", "[breeding]") {
  Document d = Family();
  d.search.body = BodyFreedom::kLot;
  std::vector<Genome> children(kLitter, d.controllers.front().genes);
  const auto nursery = NurseryOf(d, 1, children);
  REQUIRE(nursery);
  const Problem problem = NurseryProblem(*nursery);
  CHECK_FALSE(problem.bodies);
  CHECK(problem.figure.rods == d.figure.rods);
  const auto brood = BroodOf(*nursery, 40, 9);
  const auto asked = brood->Ask(10);
  REQUIRE(!asked.empty());
  CHECK(asked.front().size() == d.controllers.front().genes.size());
}

TEST_CASE("litter: a child's document moves as the child did, without pushes", "[breeding]") {
  Document d = Family();
  d.pushes = {{.step = 10, .impulse_x_ns = 5.0f}};
  const Genome genes = d.controllers.front().genes;
  d.controllers.clear();
  d.timeline.clear();
  const Document child = ChildOf(d, genes);
  REQUIRE(Validate(child));
  CHECK(child.title == "Mr. Star-Man");
  CHECK(child.lineage.rounds.size() == 3);
  const Document alone = *DecodeJson(ReadFile("examples/star-man-shuffle.json"));
  CHECK(Simulate(child).Hash() == Simulate(alone).Hash());
}

TEST_CASE("litter: a pick that was not born is refused", "[breeding]") {
  const Document d = Family();
  const std::vector<Genome> two(2, d.controllers.front().genes);
  const auto nursery = NurseryOf(d, 1, two);
  REQUIRE_FALSE(nursery);
  CHECK(nursery.error().where == "lineage.rounds[1].picks");
  CHECK(nursery.error().what == "child 2 was picked, but it was not born");
  CHECK_FALSE(NurseryOf(d, 3, two));
  CHECK_FALSE(NurseryOf(d, -1, two));
  const std::vector<Genome> short_ones(kLitter, Genome(3));
  CHECK_FALSE(NurseryOf(d, 1, short_ones));
}

TEST_CASE("litter: a document without a lineage is as short as before", "[breeding][document]") {
  Document d = Family();
  d.lineage = {};
  CHECK(EncodeBinary(d).front() == 1);
  CHECK(EncodeJson(d).find("lineage") == std::string::npos);
}

TEST_CASE("litter: wrong lineages are refused with their place", "[breeding][document]") {
  CHECK(FaultOf([](Document&) {}).empty());
  CHECK(FaultOf([](Document& d) { d.lineage.founders.clear(); }) ==
        "lineage: needs founders and rounds, or neither");
  CHECK(FaultOf([](Document& d) {
          d.lineage.rounds.clear();
          d.lineage.shown = 0;
        }) == "lineage: needs founders and rounds, or neither");
  CHECK(FaultOf([](Document& d) { d.lineage.shown = 3; }) == "lineage.shown: there is no round 3");
  CHECK(FaultOf([](Document& d) { d.lineage.rounds[1].parent = 1; }) ==
        "lineage.rounds[1].parent: must be an earlier round");
  CHECK(FaultOf([](Document& d) { d.lineage.rounds[1].picks = 0; }) ==
        "lineage.rounds[1].picks: must pick from 9 motions, one bit each");
  CHECK(FaultOf([](Document& d) { d.lineage.rounds[1].picks = 512; }) ==
        "lineage.rounds[1].picks: must pick from 9 motions, one bit each");
  CHECK(FaultOf([](Document& d) { d.lineage.rounds[0].picks = 2; }) ==
        "lineage.rounds[0].picks: must pick from 1 motions, one bit each");
  CHECK(FaultOf([](Document& d) {
          d.lineage.founders.push_back(d.lineage.founders.front());
          d.lineage.founders[1].senses.tau_min_s = 0.05f;
        }) == "lineage.founders[1].senses: founders must have the same kind, senses and number of rules");
  CHECK_FALSE(FaultOf([](Document& d) { d.lineage.founders[0].genes.pop_back(); }).empty());
  CHECK_FALSE(FaultOf([](Document& d) { d.lineage.rounds[0].difference = 1.5f; }).empty());
  CHECK_FALSE(FaultOf([](Document& d) { d.lineage.rounds[0].task.duration_steps = 0; }).empty());
  CHECK_FALSE(FaultOf([](Document& d) { d.lineage.rounds.resize(kMaxBreedRounds + 1); }).empty());
}

}  // namespace gaitsmith::test
