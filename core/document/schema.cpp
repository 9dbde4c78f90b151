// SPDX-License-Identifier: MIT
#include "core/document/schema.h"

#include "core/document/trial_worlds.h"
#include "core/rollout/models.h"
#include "core/world/terrain.h"

namespace gaitsmith {

namespace {

void Describe(Archive& ar, Rod& rod) {
  const Rod standard;
  ar.Integer("parent", rod.parent, kNoParent, kMaxRods - 1, standard.parent);
  ar.Choice("parent_end", rod.parent_end, kRodEndNames, standard.parent_end);
  ar.Real("length_m", rod.length_m, 0.001f, 1000.0f, standard.length_m);
  ar.Real("mass_kg", rod.mass_kg, 1e-6f, 1e6f, standard.mass_kg);
  ar.Real("rest_rad", rod.rest_rad, -6.2831855f, 6.2831855f, standard.rest_rad);
  ar.Real("min_rad", rod.min_rad, -3.1415927f, 0.0f, standard.min_rad);
  ar.Real("max_rad", rod.max_rad, 0.0f, 3.1415927f, standard.max_rad);
  ar.Since(7, [&] { ar.Real("strength", rod.strength, 0.0f, 1000.0f, standard.strength); });
  ar.Since(7, [&] { ar.Real("stiffness", rod.stiffness, 1.0f, 1e6f, standard.stiffness); });
}

void Describe(Archive& ar, Node& node) {
  const Node standard;
  ar.Real("x_m", node.x_m, -1000.0f, 1000.0f, standard.x_m);
  ar.Real("y_m", node.y_m, -1000.0f, 1000.0f, standard.y_m);
  ar.Real("mass_kg", node.mass_kg, 1e-6f, 1e6f, standard.mass_kg);
}

void Describe(Archive& ar, Spring& spring) {
  const Spring standard;
  ar.Integer("from", spring.from, 0, kMaxPoints - 1, standard.from);
  ar.Integer("to", spring.to, 0, kMaxPoints - 1, standard.to);
  ar.Real("stiffness_npm", spring.stiffness_npm, 0.0f, 1e6f, standard.stiffness_npm);
  ar.Real("damping_nspm", spring.damping_nspm, 0.0f, 1e6f, standard.damping_nspm);
  ar.Real("rest", spring.rest, kLeastRest, kMostRest, standard.rest);
  ar.Real("min_rest", spring.min_rest, kLeastRest, kMostRest, standard.min_rest);
  ar.Real("max_rest", spring.max_rest, kLeastRest, kMostRest, standard.max_rest);
}

void Describe(Archive& ar, Environment& environment) {
  const Environment standard;
  ar.Real("gravity_mps2", environment.gravity_mps2, 0.0f, 100.0f, standard.gravity_mps2);
  ar.Real("friction", environment.friction, 0.0f, 10.0f, standard.friction);
  ar.Real("slope_rad", environment.slope_rad, -0.6f, 0.6f, standard.slope_rad);
  ar.Since(2, [&] { ar.Real("sway_rad", environment.sway_rad, 0.0f, 0.6f, standard.sway_rad); });
  ar.Since(2,
           [&] { ar.Real("sway_period_s", environment.sway_period_s, 0.5f, 60.0f, standard.sway_period_s); });
  ar.Since(7, [&] {
    ar.List("ground", environment.ground, kMaxCorners, [&](Corner& corner) {
      ar.Real("x_m", corner.x_m, -kMaxCornerX, kMaxCornerX, 0.0f);
      ar.Real("y_m", corner.y_m, -kMaxCornerY, kMaxCornerY, 0.0f);
    });
  });
}

void Describe(Archive& ar, StartState& start) {
  ar.Real("drop_height_m", start.drop_height_m, 0.0f, 100.0f, 0.0f);
  ar.Real("velocity_x_mps", start.velocity_x_mps, -100.0f, 100.0f, 0.0f);
  ar.Real("velocity_y_mps", start.velocity_y_mps, -100.0f, 100.0f, 0.0f);
  ar.Real("spin_radps", start.spin_radps, -40.0f, 40.0f, 0.0f);
}

void Describe(Archive& ar, Push& push) {
  ar.Integer("step", push.step, 0, kMaxSteps - 1, 0);
  ar.Integer("endpoint", push.endpoint, kCentreOfMass, kMaxContacts - 1, kCentreOfMass);
  ar.Real("impulse_x_ns", push.impulse_x_ns, -1e6f, 1e6f, 0.0f);
  ar.Real("impulse_y_ns", push.impulse_y_ns, -1e6f, 1e6f, 0.0f);
}

void Describe(Archive& ar, Demonstration& shown) {
  ar.List("way", shown.way, kMaxWayPoints, [&](WayPoint& point) {
    ar.Integer("step", point.step, 0, kMaxSteps, 0);
    ar.Real("x_m", point.x_m, -10'000.0f, 10'000.0f, 0.0f);
    ar.Real("y_m", point.y_m, 0.0f, 10'000.0f, 0.0f);
  });
  ar.Integer("pose_step", shown.pose_step, 1, kMaxSteps, Demonstration{}.pose_step);
  ar.Real("pose_turn_rad", shown.pose_turn_rad, -6.2831855f, 6.2831855f, 0.0f);
  ar.List("pose", shown.pose_rad, kMaxJoints,
          [&](float& angle_rad) { ar.Real("angle_rad", angle_rad, -3.1415927f, 3.1415927f, 0.0f); });
}

void Describe(Archive& ar, Task& task) {
  const Task standard;
  ar.Choice("kind", task.kind, kTaskNames, standard.kind);
  ar.Integer("duration_steps", task.duration_steps, 1, kMaxSteps, standard.duration_steps);
  ar.Group("weights", [&] {
    for (std::size_t term = 0; term < kStyleTerms; ++term) {
      const StyleTermRow& row = kStyleTable[term];
      const auto weight = [&] {
        ar.Real(row.name, task.weights[term], -kMaxStyleWeight, kMaxStyleWeight, 0.0f);
      };
      if (row.since == 1) {
        weight();
      } else {
        ar.Since(row.since, weight);
      }
    }
  });
  ar.Since(6, [&] { ar.Group("shown", [&] { Describe(ar, task.shown); }); });
}

void Describe(Archive& ar, SenseSpec& senses) {
  const SenseSpec standard;
  ar.Choice("kind", senses.kind, kSenseKindNames, standard.kind);
  ar.Integer("period_steps", senses.period_steps, 2, kMaxSteps, standard.period_steps);
  ar.Real("tau_min_s", senses.tau_min_s, 0.02f, 10.0f, standard.tau_min_s);
  ar.Real("tau_max_s", senses.tau_max_s, 0.02f, 10.0f, standard.tau_max_s);
  ar.Real("force_weights", senses.force_weights, 0.1f, 100.0f, standard.force_weights);
  ar.Real("height_rods", senses.height_rods, 0.1f, 100.0f, standard.height_rods);
  ar.Real("velocity_mps", senses.velocity_mps, 0.1f, 100.0f, standard.velocity_mps);
  ar.Since(8, [&] { ar.Real("sight_rods", senses.sight_rods, 0.5f, 20.0f, standard.sight_rods); });
  ar.Since(8, [&] { ar.Choice("facing", senses.facing, kFacingNames, standard.facing); });
  ar.Since(9, [&] { ar.Choice("at_end", senses.at_end, kCurveEndNames, standard.at_end); });
}

void Describe(Archive& ar, GeneticSettings& genetic) {
  const GeneticSettings standard;
  ar.Integer("population", genetic.population, 2, 10'000, standard.population);
  ar.Real("mutation_rate", genetic.rates.mutation, 0.0f, 1.0f, standard.rates.mutation);
  ar.Real("crossover_rate", genetic.rates.crossover, 0.0f, 1.0f, standard.rates.crossover);
  ar.Choice("rates", genetic.rates.reading, kRateReadingNames, standard.rates.reading);
  ar.Real("rank_bias", genetic.rank_bias, 1.0f, 2.0f, standard.rank_bias);
  ar.Since(3, [&] { ar.Choice("copies", genetic.rates.copies, kCopiesNames, standard.rates.copies); });
  ar.Since(13, [&] { ar.Choice("niching", genetic.niching, kNichingNames, standard.niching); });
  ar.Since(13,
           [&] { ar.Choice("crossing", genetic.rates.crossing, kCrossingNames, standard.rates.crossing); });
}

void Describe(Archive& ar, TorusSettings& torus) {
  const TorusSettings standard;
  ar.Integer("side", torus.side, 2, 128, standard.side);
  ar.Integer("walk_steps", torus.walk_steps, 1, 1000, standard.walk_steps);
}

void Describe(Archive& ar, RefineSettings& refine) {
  ar.Real("step", refine.step, 0.001f, 1.0f, RefineSettings{}.step);
}

void Describe(Archive& ar, CmaSettings& cma) {
  const CmaSettings standard;
  ar.Choice("genes", cma.genes, kCmaGenesNames, standard.genes);
  ar.Choice("covariance", cma.covariance, kCovarianceNames, standard.covariance);
  ar.Integer("population", cma.population, 0, 10'000, standard.population);
  ar.Real("step", cma.step, 0.001f, 1.0f, standard.step);
  ar.Real("growth", cma.growth, 1.0f, 10.0f, standard.growth);
  ar.Integer("draws", cma.draws, 1, 10'000, standard.draws);
  ar.Since(13, [&] { ar.Choice("restarts", cma.restarts, kRestartsNames, standard.restarts); });
}

void Describe(Archive& ar, ElitesSettings& elites) {
  const ElitesSettings standard;
  ar.Integer("initial", elites.initial, 1, 100'000, standard.initial);
  ar.Integer("batch", elites.batch, 1, 1000, standard.batch);
  ar.Integer("bins", elites.bins, 1, 32, standard.bins);
  ar.Real("most_height_m", elites.most[0], 0.001f, 1000.0f, standard.most[0]);
  ar.Real("most_slip_m", elites.most[1], 0.001f, 1000.0f, standard.most[1]);
  ar.Real("most_rotations", elites.most[2], 0.001f, 1000.0f, standard.most[2]);
  ar.Since(13, [&] { ar.Real("crossover", elites.crossover, 0.0f, 1.0f, standard.crossover); });
  ar.Since(13, [&] { ar.Integer("emitters", elites.emitters, 1, 100, standard.emitters); });
  ar.Since(13, [&] { ar.Real("learning", elites.learning, 0.0f, 1.0f, standard.learning); });
}

void Describe(Archive& ar, TwoStageSettings& stages) {
  const TwoStageSettings standard;
  ar.Integer("random", stages.random, 1, 1'000'000, standard.random);
  ar.Integer("kept", stages.kept, 1, 1000, standard.kept);
}

void Describe(Archive& ar, DifferenceSettings& difference) {
  const DifferenceSettings standard;
  ar.Integer("population", difference.population, 4, 10'000, standard.population);
  ar.Real("weight", difference.weight, 0.0f, 2.0f, standard.weight);
  ar.Real("crossover", difference.crossover, 0.0f, 1.0f, standard.crossover);
}

void Describe(Archive& ar, Controller& controller, const PortCount& ports) {
  ar.Text("name", controller.name);
  ar.Group("senses", [&] { Describe(ar, controller.senses); });
  ar.Since(2, [&] { ar.Choice("kind", controller.kind, kControllerKindNames, ControllerKind::kRules); });
  ar.Genes(controller, ports);
}

void Describe(Archive& ar, Clip& clip) {
  ar.Integer("controller", clip.controller, 0, kMaxControllers - 1, 0);
  ar.Integer("start_step", clip.start_step, 0, kMaxSteps - 1, 0);
}

void Describe(Archive& ar, View& view) {
  const View standard;
  ar.Real("speed", view.speed, 0.01f, 16.0f, standard.speed);
  ar.Integer("panel", view.panel, 0, 15, standard.panel);
  ar.Flag("trail", view.trail, standard.trail);
  ar.Flag("forces", view.forces, standard.forces);
  ar.Flag("poses", view.poses, standard.poses);
  ar.Since(7, [&] { ar.Flag("torques", view.torques, standard.torques); });
}

void Describe(Archive& ar, BreedRound& round) {
  const BreedRound standard;
  ar.Text("name", round.name);
  ar.Integer("parent", round.parent, -1, kMaxBreedRounds - 1, standard.parent);
  ar.Natural("picks", round.picks, standard.picks);
  ar.Natural("seed", round.seed, standard.seed);
  ar.Real("difference", round.difference, 0.0f, 1.0f, standard.difference);
  ar.Flag("keep_goal", round.keep_goal, standard.keep_goal);
  ar.Natural("kept_rules", round.kept_rules, standard.kept_rules);
  ar.Natural("kept_joints", round.kept_joints, standard.kept_joints);
  ar.Group("task", [&] { Describe(ar, round.task); });
}

void Describe(Archive& ar, Lineage& lineage, const PortCount& ports) {
  ar.List("founders", lineage.founders, kMaxFounders, [&](Controller& c) { Describe(ar, c, ports); });
  ar.List("rounds", lineage.rounds, kMaxBreedRounds, [&](BreedRound& round) { Describe(ar, round); });
  ar.Integer("shown", lineage.shown, 0, kMaxBreedRounds - 1, 0);
}

void Describe(Archive& ar, Keyframe& keyframe) {
  ar.Integer("step", keyframe.step, 1, kMaxPlanSteps, 1);
  ar.List("pose", keyframe.pose_rad, kMaxJoints,
          [&](float& angle_rad) { ar.Real("angle_rad", angle_rad, -3.1415927f, 3.1415927f, 0.0f); });
  ar.Flag("turned", keyframe.turned, false);
  ar.Real("turn_rad", keyframe.turn_rad, -100.0f, 100.0f, 0.0f);
  ar.List("marks", keyframe.marks, kMaxMarks, [&](Mark& mark) {
    ar.Integer("endpoint", mark.endpoint, kCentreOfMass, kMaxEndpoints - 1, kCentreOfMass);
    ar.Choice("axes", mark.axes, kMarkAxesNames, MarkAxes::kBoth);
    ar.Real("x_m", mark.x_m, -200.0f, 200.0f, 0.0f);
    ar.Real("y_m", mark.y_m, -20.0f, 200.0f, 0.0f);
  });
  ar.Flag("still", keyframe.still, false);
}

void Describe(Archive& ar, Plan& plan) {
  const Plan standard;
  ar.Integer("steps", plan.steps, 2, kMaxPlanSteps, standard.steps);
  ar.List("keyframes", plan.keyframes, kMaxKeyframes, [&](Keyframe& keyframe) { Describe(ar, keyframe); });
  ar.List("stances", plan.stances, kMaxStances, [&](Stance& stance) {
    ar.Integer("endpoint", stance.endpoint, 0, kMaxEndpoints - 1, 0);
    ar.Integer("first_step", stance.first_step, 0, kMaxPlanSteps - 1, 0);
    ar.Integer("last_step", stance.last_step, 1, kMaxPlanSteps, 1);
  });
  ar.Real("smoothness", plan.smoothness, 1e-6f, 100.0f, standard.smoothness);
  ar.Group("solved", [&] {
    ar.Integer("degree", plan.solved.degree, 3, 5, standard.solved.degree);
    ar.Integer("pieces_per_second", plan.solved.pieces_per_second, 2, 64, standard.solved.pieces_per_second);
    ar.List("unknowns", plan.solved.unknowns, kMaxPlanUnknowns,
            [&](float& value) { ar.Real("value", value, -1e6f, 1e6f, 0.0f); });
  });
}

}  // namespace

void Describe(Archive& ar, Figure& figure) {
  ar.Text("name", figure.name);
  ar.List("rods", figure.rods, kMaxRods, [&](Rod& rod) { Describe(ar, rod); });
  ar.Since(14, [&] { ar.List("nodes", figure.nodes, kMaxPoints, [&](Node& node) { Describe(ar, node); }); });
  ar.Since(14, [&] {
    ar.List("springs", figure.springs, kMaxSprings, [&](Spring& spring) { Describe(ar, spring); });
  });
}

void Describe(Archive& ar, SearchSettings& search) {
  const SearchSettings standard;
  const Variation vary;
  ar.Choice("algorithm", search.algorithm, kAlgorithmNames, standard.algorithm);
  ar.Natural("seed", search.seed, standard.seed);
  ar.Integer("evaluations", search.evaluations, 1, 100'000'000, standard.evaluations);
  ar.Integer("population", search.population, 2, 1000, standard.population);
  ar.Integer("reseed_interval", search.reseed_interval, 1, 1'000'000, standard.reseed_interval);
  ar.Real("dont_care", search.variation.dont_care, 0.0f, 1.0f, vary.dont_care);
  ar.Real("gene_chance", search.variation.gene_chance, 0.001f, 1.0f, vary.gene_chance);
  ar.Real("creep", search.variation.creep, 0.001f, 1.0f, vary.creep);
  ar.Real("redraw", search.variation.redraw, 0.0f, 1.0f, vary.redraw);
  ar.Since(2, [&] { ar.Integer("start", search.start, -1, kMaxControllers - 1, standard.start); });
  ar.Since(2,
           [&] { ar.Integer("in_place_of", search.in_place_of, -1, kMaxClips - 1, standard.in_place_of); });
  ar.Since(2, [&] {
    ar.List("handovers", search.handovers, kMaxHandovers, [&](Handover& handover) {
      ar.Integer("controller", handover.controller, 0, kMaxControllers - 1, 0);
      ar.Integer("step", handover.step, 0, kMaxSteps - 1, 0);
    });
  });
  ar.Since(2, [&] { ar.Group("genetic", [&] { Describe(ar, search.genetic); }); });
  ar.Since(2, [&] { ar.Group("torus", [&] { Describe(ar, search.torus); }); });
  ar.Since(2, [&] { ar.Group("refine", [&] { Describe(ar, search.refine); }); });
  ar.Since(2, [&] { ar.Group("cma", [&] { Describe(ar, search.cma); }); });
  ar.Since(2, [&] { ar.Group("elites", [&] { Describe(ar, search.elites); }); });
  ar.Since(2, [&] { ar.Group("two_stage", [&] { Describe(ar, search.two_stage); }); });
  ar.Since(3, [&] { ar.Choice("heedless", search.variation.heedless, kHeedlessNames, vary.heedless); });
  ar.Since(5, [&] { ar.Choice("body", search.body, kBodyFreedomNames, standard.body); });
  ar.Since(11, [&] { ar.Integer("worlds", search.worlds, 1, kMaxWorlds, standard.worlds); });
  ar.Since(12, [&] { ar.Choice("finest_step", search.finest_step, kFinestStepNames, standard.finest_step); });
  ar.Since(13, [&] { ar.Group("difference", [&] { Describe(ar, search.difference); }); });
  ar.Since(13, [&] { ar.Choice("cost", search.cost, kCostNames, standard.cost); });
}

void Describe(Archive& ar, Document& d) {
  const Document standard;
  ar.Model("model", d.model);
  ar.Text("title", d.title);
  ar.Group("figure", [&] { Describe(ar, d.figure); });
  ar.Group("environment", [&] { Describe(ar, d.environment); });
  ar.Group("start", [&] { Describe(ar, d.start); });
  ar.List("pushes", d.pushes, kMaxPushes, [&](Push& push) { Describe(ar, push); });
  ar.Group("task", [&] { Describe(ar, d.task); });
  ar.Group("senses", [&] { Describe(ar, d.senses); });
  ar.Integer("rules", d.rules, 1, kMaxRules, standard.rules);
  ar.Since(2, [&] { ar.Choice("kind", d.kind, kControllerKindNames, standard.kind); });
  ar.Group("search", [&] { Describe(ar, d.search); });
  // What controllers are connected to depends on both.
  if (const char* why = WhyNotModel(d.model, d.figure); why != nullptr) ar.Refuse("model", why);
  const PortCount ports = CountPorts(d.model, d.figure);
  ar.List("controllers", d.controllers, kMaxControllers, [&](Controller& c) { Describe(ar, c, ports); });
  ar.List("timeline", d.timeline, kMaxClips, [&](Clip& clip) { Describe(ar, clip); });
  ar.Integer("duration_steps", d.duration_steps, 1, kMaxSteps, standard.duration_steps);
  ar.Group("view", [&] { Describe(ar, d.view); });
  ar.Since(4, [&] { ar.Group("lineage", [&] { Describe(ar, d.lineage, ports); }); });
  ar.Since(5, [&] { ar.List("drawn", d.drawn, kMaxRods, [&](Rod& rod) { Describe(ar, rod); }); });
  ar.Since(10, [&] { ar.Group("plan", [&] { Describe(ar, d.plan); }); });
  ar.Hash("hash", d.hash);
}

}  // namespace gaitsmith
