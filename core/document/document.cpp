// SPDX-License-Identifier: MIT
#include "core/document/document.h"

#include "core/document/archive.h"
#include "core/document/schema.h"
#include "core/document/trial_worlds.h"
#include "core/rollout/models.h"
#include "core/search/evaluation_score.h"
#include "core/world/terrain.h"

namespace gaitsmith {

namespace {

/// Walks a document and only checks it.
class Checker : public Archive {
 public:
  void Real(std::string_view name, float& value, float low, float high, float) override {
    CheckReal(name, value, low, high);
  }
  void Integer(std::string_view name, int& value, int low, int high, int) override {
    CheckInteger(name, value, low, high);
  }
  void Model(std::string_view name, int& model) override { CheckModel(name, model); }
  void Text(std::string_view name, std::string& text) override { CheckText(name, text); }
  void Genes(Controller& controller, const PortCount&) override {
    CheckInteger("rules", controller.rules, 1, kMaxRules);
  }

 private:
  void Index(std::string_view name, int& index, std::span<const std::string_view> names, int) override {
    CheckInteger(name, index, 0, static_cast<int>(names.size()) - 1);
  }
  bool BeginList(std::string_view name, std::size_t& size, int most) override {
    CheckCount(name, size, static_cast<std::size_t>(most));
    return Archive::BeginList(name, size, most);
  }
};

}  // namespace

Result<void> Validate(const Document& document) {
  Checker checker;
  Document copy = document;  // an archive may change the document, a check must not
  Describe(checker, copy);
  if (!checker.Ok()) return std::unexpected(*checker.Fault());
  return CheckReferences(document);
}

void SetFigure(const Figure& figure, Document& document) {
  document.figure = figure;
  if (figure.HasSprings()) {
    document.model = kSpringModel;
    if (document.kind == ControllerKind::kNetwork) document.kind = ControllerKind::kRules;
    document.search.body = BodyFreedom::kNone;
    document.drawn.clear();
    document.plan = {};
  } else if (document.model == kSpringModel) {
    document.model = document.environment.ground.empty() ? Document{}.model : kFirstDrawnGround;
  }
}

Script ScriptOf(const Document& d) {
  return {.figure = d.figure,
          .environment = d.environment,
          .start = d.start,
          .pushes = d.pushes,
          .controllers = d.controllers,
          .clips = d.timeline,
          .steps = d.duration_steps,
          .model = d.model,
          .shown = d.task.shown};
}

Motion Simulate(const Document& d) { return Motion(ScriptOf(d)); }

PlanScene SceneOf(const Document& d) { return {Skeleton(d.figure), d.environment, d.start, d.plan}; }

Figure AsDrawn(const Document& d) {
  Figure drawn = d.figure;
  if (!d.drawn.empty()) drawn.rods = d.drawn;
  return drawn;
}

Problem ProblemOf(const Document& d) {
  Problem problem = {d.figure, d.environment, d.start, d.pushes, d.task, d.senses, d.rules, d.kind};
  problem.model = d.model;
  problem.traits = d.search.algorithm == Algorithm::kNsga;  // for its cost
  if (d.search.body != BodyFreedom::kNone) {
    problem.bodies = {AsDrawn(d), kBodyTimes[static_cast<std::size_t>(d.search.body)]};
    // Without a controller to start from, nothing of what was found before counts.
    if (d.search.start < 0) problem.figure = problem.bodies->drawn;
  }
  problem.worlds = DrawWorlds(d.search.seed, d.search.worlds, problem.figure.Parts(),
                              {.halvings = static_cast<int>(d.search.finest_step)});
  if (d.search.in_place_of >= 0) {
    const auto clip = static_cast<std::size_t>(d.search.in_place_of);
    const int start = d.timeline[clip].start_step;
    problem.beginnings.push_back(
        {d.controllers, {d.timeline.begin(), d.timeline.begin() + d.search.in_place_of}, start});
    problem.task.duration_steps = EndOf(d, clip) - start;
  }
  if (!d.search.handovers.empty()) problem.beginnings.emplace_back();  // the start itself
  for (const Handover& handover : d.search.handovers) {
    problem.beginnings.push_back({{d.controllers[static_cast<std::size_t>(handover.controller)]},
                                  {{.controller = 0, .start_step = 0}},
                                  handover.step});
  }
  return problem;
}

int EndOf(const Document& d, std::size_t clip) {
  return clip + 1 < d.timeline.size() ? d.timeline[clip + 1].start_step : d.duration_steps;
}

bool SameShape(const Controller& a, const Controller& b) {
  return a.kind == b.kind && a.senses == b.senses && a.rules == b.rules;
}

bool FitsSearch(const Document& d, const Controller& controller) {
  return controller.kind == d.kind && controller.senses == d.senses && controller.rules == d.rules;
}

Problem ReplayProblem(const Document& d, const Controller& controller) {
  Problem problem = ProblemOf(d);
  problem.senses = controller.senses;
  problem.rules = controller.rules;
  problem.kind = controller.kind;
  problem.task.duration_steps = d.duration_steps;
  problem.beginnings.clear();
  problem.worlds.clear();
  problem.figure = d.figure;
  problem.bodies.reset();
  return problem;
}

Genome StartOf(const Document& d) {
  if (d.search.start < 0) return {};
  Genome start = d.controllers[static_cast<std::size_t>(d.search.start)].genes;
  start.resize(ProblemOf(d).Shape().Genes(), kUnchangedGene);
  return start;
}

SearchSpace SpaceOf(const Document& d) { return SpaceOf(ProblemOf(d), StartOf(d)); }

Controller TakeFound(const Document& searched, Genome genome, Document& to) {
  const Problem problem = ProblemOf(searched);
  if (problem.bodies) {
    const std::size_t of_body = problem.Shape().BodyGenes();
    if (genome.size() >= of_body) {
      to.drawn = problem.bodies->drawn.rods;
      to.figure.rods = problem.WithBodyOf(genome).figure.rods;
      to.lineage = {};  // its children would be others on this body
      genome.resize(genome.size() - of_body);
      if (to.drawn == to.figure.rods) to.drawn.clear();
    }
  }
  return {"", searched.kind, searched.senses, searched.rules, std::move(genome)};
}

std::string HashText(std::uint64_t hash) {
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 15u];
  return text;
}

}  // namespace gaitsmith
