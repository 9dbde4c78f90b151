// SPDX-License-Identifier: MIT
// Documents of figures of springs (model 3): what they can hold, what is refused and where, and what of other
// documents' features they have.
#include <catch_amalgamated.hpp>
#include <string>

#include "core/document/binary.h"
#include "core/document/goals.h"
#include "core/document/joints.h"
#include "core/document/json.h"
#include "core/document/link.h"
#include "core/document/parts.h"
#include "core/document/recording.h"
#include "core/document/standing.h"
#include "core/gait/document_loop.h"
#include "core/kinematics/state_distance.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/mirror_image.h"
#include "core/rollout/models.h"
#include "tests/scene.h"
#include "tests/search_run.h"
#include "tests/spring_scene.h"

namespace gaitsmith::test {

namespace {

/// With a controller that the first genes of a search's stream make.
Document Moving(const Figure& figure, SenseKind senses = SenseKind::kPhysical, std::uint32_t seed = 7) {
  Document document = Standing(figure);
  document.senses.kind = senses;
  document.duration_steps = 300;
  Controller controller{.name = "Random", .senses = document.senses, .rules = 6, .genes = {}};
  controller.genes.resize(controller.Shape(CountPorts(document.model, figure)).Genes());
  RandomStream random(seed, 0, 0);
  for (Gene& gene : controller.genes) gene = random.Gene();
  const BankShape shape(controller.rules, senses, CountPorts(document.model, figure));
  for (int rule = 0; rule < shape.rules; ++rule) {
    for (int sense = 0; sense < shape.senses; ++sense) {
      Gene &low = controller.genes[shape.Low(rule, sense)], &high = controller.genes[shape.High(rule, sense)];
      if (low > high) std::swap(low, high);
    }
  }
  document.controllers = {controller};
  document.timeline = {{.controller = 0, .start_step = 0}};
  return document;
}

std::string FaultOf(const Document& document) {
  const auto valid = Validate(document);
  REQUIRE_FALSE(valid);
  return valid.error().where + ": " + valid.error().what;
}

}  // namespace

TEST_CASE("springs: a document goes through links and files, and its motion keeps its bits",
          "[document][springs]") {
  for (const SenseKind senses : {SenseKind::kPhysical, SenseKind::kTimer, SenseKind::kSight}) {
    Document document = Moving(Table(), senses);
    document.environment.ground = {{0.6f, 0.0f}, {0.6f, 0.1f}, {3.0f, 0.1f}};
    REQUIRE(Validate(document));
    CHECK(document.model == kSpringModel);
    const auto bytes = EncodeBinary(document);
    CHECK(bytes[0] == 14);
    const auto of_link = DecodeLink(EncodeLink(document));
    const auto of_file = DecodeJson(EncodeJson(document));
    REQUIRE((of_link && of_file));
    CHECK(DifferingParts(*of_link, document, AllParts().Without(Part::kHash)).Empty());
    CHECK(EncodeBinary(*of_file) == bytes);
    const Motion motion = Simulate(document);
    CHECK(Simulate(*of_link).Hash() == motion.Hash());
    CHECK_FALSE(motion.TermsAt(300).broke_physics);
    CHECK(motion.TermsAt(300).effort_rad > 0.1f);
    // What a search would score is what the document shows.
    const Problem problem = ReplayProblem(document, document.controllers[0]);
    const Genome& genome = document.controllers[0].genes;
    CHECK(Evaluator(problem, true).Evaluate(std::span(&genome, 1)).front().trajectory_hash == motion.Hash());
  }
  // A figure of rods needs no newer version than before.
  CHECK(EncodeBinary(Standing(StarManTravel(SenseKind::kTimer).figure))[0] < 14);
}

TEST_CASE("springs: what a document of them cannot hold is refused with its place", "[document][springs]") {
  const auto fault = [](auto change) {
    Document document = Moving(Box());
    change(document);
    return FaultOf(document);
  };
  CHECK(fault([](Document& d) { d.model = 2; }) == "model: must be 3 for a figure of springs");
  CHECK(fault([](Document& d) { d.figure = StarManTravel(SenseKind::kTimer).figure; }) ==
        "model: is for figures of springs, and this one has rods");
  CHECK(fault([](Document& d) { d.figure.rods.emplace_back(); }) ==
        "figure.nodes: a figure has either rods, or nodes and springs");
  CHECK(fault([](Document& d) { d.figure.nodes.clear(); }) ==
        "figure.nodes: a figure of springs needs nodes");
  CHECK(fault([](Document& d) { d.figure.springs[1].to = 9; }) ==
        "figure.springs[1].to: there is no node 9, the figure has nodes 0 to 3");
  CHECK(fault([](Document& d) { d.figure.springs[1].max_rest = 0.5f; }) ==
        "figure.springs[1].max_rest: must be from 1 to 3, is 0.5");
  CHECK(fault([](Document& d) {
          d.figure.springs[2].stiffness_npm = 2e6f;
        }).starts_with("figure.springs[2].stiffness_npm: must be from 0 to 1e+06"));
  CHECK(fault([](Document& d) {
          d.figure.nodes[2].mass_kg = 0.0001f;
        }).starts_with("figure.nodes[2].mass_kg: is too little for the springs there"));
  const std::string rules = ": a figure of springs follows rules or curves, not a network";
  CHECK(fault([](Document& d) { d.kind = ControllerKind::kNetwork; }) == "kind" + rules);
  CHECK(fault([](Document& d) { d.controllers[0].kind = ControllerKind::kNetwork; }) ==
        "controllers[0].kind" + rules);
  CHECK(fault([](Document& d) {
          d.lineage.founders = d.controllers;
          d.lineage.founders[0].kind = ControllerKind::kNetwork;
        }) == "lineage.founders[0].kind" + rules);
  CHECK(fault([](Document& d) { d.drawn.emplace_back(); }) ==
        "drawn: is for figures of rods, and this one has springs");
  CHECK(fault([](Document& d) { d.search.body = BodyFreedom::kLittle; }) ==
        "search.body: the bodies of figures of springs cannot be searched");
  CHECK(fault([](Document& d) { d.plan.keyframes = {{.step = 5}}; }) ==
        "plan: figures of springs have no keyframes");
  CHECK(fault([](Document& d) {
          d.task.shown.pose_rad = {0.5f};
        }).starts_with("task.shown.pose: is for figures of rods"));
  CHECK(fault([](Document& d) { d.pushes = {{.step = 3, .endpoint = 4}}; }) ==
        "pushes[0].endpoint: there is no endpoint 4, the figure has 0 to 3");
  CHECK(fault([](Document& d) { d.controllers[0].genes.pop_back(); }).starts_with("controllers[0].rules"));
  // A file is refused where model and figure part, not where their controllers do.
  std::string json = EncodeJson(Moving(Box()));
  json.replace(json.find("\"model\": 3"), 10, "\"model\": 1");
  const auto decoded = DecodeJson(json);
  REQUIRE_FALSE(decoded);
  CHECK(decoded.error().where + ": " + decoded.error().what == "model: must be 3 for a figure of springs");
  const auto recorded = RecordAsCurves(Moving(Box()), 8);
  REQUIRE_FALSE(recorded);
  CHECK(recorded.error().what == "has springs: only angles of joints are recorded as curves");
  const Document document = Moving(Box());
  const auto loop = LoopOf(document, Simulate(document), true);
  REQUIRE_FALSE(loop);
  CHECK(loop.error().what == "the figure has no two limbs that can take each other's part");
}

TEST_CASE("springs: every shipped figure is valid, stands on the ground, and can move itself",
          "[figure][springs]") {
  const std::vector<std::string> files = ShippedSpringFiles();
  CHECK(files.size() == 6);
  for (const std::string& file : files) {
    CAPTURE(file);
    const Figure figure = ShippedFigure(file);
    CHECK(Validate(Standing(figure)));
    CHECK(figure.Muscles() >= 5);
    const Motion still = Simulate(Standing(figure));
    float lowest = 1e9f;
    for (int k = 0; k < still.Connections().contacts; ++k)
      lowest = std::min(lowest, still.At(0).y_m + still.Endpoint(0, k).y);
    CHECK(lowest == Catch::Approx(0.0f).margin(1e-6f));
    CHECK_FALSE(AtEnd(still).broke_physics);
    // Even a short search finds a way of a fifth of its size in four seconds.
    Document document = Standing(figure);
    document.task.duration_steps = 400;
    document.search.evaluations = 300;
    CHECK(RunSearchOf(document).fitness > 0.2f * SizeOf(figure));
  }
}

TEST_CASE("springs: another figure brings the model that moves it", "[document][springs]") {
  Document document = StarManTravel(SenseKind::kTimer);
  LimitJoints(document);
  const Figure rods = document.figure;
  SetFigure(rods, document);
  CHECK(HasLimitedJoints(document));
  SetFigure(Box(), document);
  CHECK(document.model == kSpringModel);
  CHECK(Validate(document));
  FreeJoints(document);
  LimitJoints(document);
  CHECK(document.model == kSpringModel);
  CHECK_FALSE(HasLimitedJoints(document));
  SetFigure(rods, document);
  CHECK(document.model == 1);
  CHECK(Validate(document));
  // What only rods can have goes, and drawn ground keeps a model that knows it.
  document.kind = ControllerKind::kNetwork;
  document.search.body = BodyFreedom::kLot;
  document.plan.keyframes = {{.step = 5}};
  SetFigure(Box(), document);
  CHECK(Validate(document));
  document.environment.ground = {{1.0f, 0.0f}, {2.0f, 0.5f}};
  SetFigure(rods, document);
  CHECK(document.model == 2);
  CHECK(Validate(document));
}

TEST_CASE("springs: the mirror image of a controller does to the left what it does to the right",
          "[document][springs]") {
  Figure even = Table();
  Document document = Moving(even, SenseKind::kTimer);
  const auto image = MirrorImageOf(document.controllers[0], even);
  REQUIRE(image);
  CHECK(image->name == "Random, mirrored");
  Document mirrored = document;
  mirrored.controllers = {*image};
  const Motion motion = Simulate(document), other = Simulate(mirrored);
  double furthest = 0.0;
  for (int frame = 0; frame <= 40; ++frame)
    furthest = std::max(furthest, std::abs(motion.At(frame).x_m + other.At(frame).x_m));
  CHECK(furthest < 2e-4);
  CHECK(std::abs(motion.At(40).x_m) > 0.005);
  const auto back = MirrorImageOf(*image, even);
  REQUIRE(back);
  CHECK(back->genes == document.controllers[0].genes);
  even.nodes[9].mass_kg *= 1.5f;
  CHECK_FALSE(MirrorImageOf(document.controllers[0], even));
  even = Table();
  even.springs[12].max_rest = 1.4f;
  CHECK_FALSE(MirrorImageOf(document.controllers[0], even));
  // Hardly a muscle, but one: what mirrors it must be one, too.
  even = Table();
  even.springs[0].max_rest = 1.0005f;
  Document hardly = Moving(even, SenseKind::kTimer);
  CHECK_FALSE(MirrorImageOf(hardly.controllers[0], even));
}

TEST_CASE("springs: trial worlds weigh nodes, and goals are judged by the drawn figure",
          "[document][springs]") {
  Document document = Moving(Table());
  document.search.worlds = 4;
  const Problem problem = ProblemOf(document);
  REQUIRE(problem.worlds.size() == 3);
  for (const TrialWorld& world : problem.worlds) {
    REQUIRE(world.masses.size() == document.figure.nodes.size());
    CHECK(problem.In(world).figure.nodes[3].mass_kg == 0.3f * world.masses[3]);
  }
  // 1.2 m long: a quarter of that in each of eight seconds.
  Terms terms{};
  terms.travel_m = 2.5f;
  CHECK(Meets(Goal::kFar, document.figure, terms, 8.0f));
  terms.travel_m = 2.3f;
  CHECK_FALSE(Meets(Goal::kFar, document.figure, terms, 8.0f));
}

TEST_CASE("springs: states are apart where nodes are, though muscles are alike", "[document][springs]") {
  const Motion still = Simulate(Standing(Pair(500.0f, 1.0f)));
  Document swung = Standing(Pair(500.0f, 1.0f));
  swung.start.drop_height_m = 1.0f;
  swung.pushes = {{.step = 1, .endpoint = 0, .impulse_x_ns = -1.0f},
                  {.step = 1, .endpoint = 1, .impulse_x_ns = 1.0f}};
  Document fallen = swung;
  fallen.pushes.clear();
  const Motion stretched = Simulate(swung), plain = Simulate(fallen);
  CHECK(StateDistance(plain, 10, plain, 1) == 0.0);
  CHECK(StateDistance(stretched, 6, plain, 1) > 0.01);
}

}  // namespace gaitsmith::test
