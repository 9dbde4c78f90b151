// SPDX-License-Identifier: MIT
#include "tests/lesson_visit.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/breeding/litter.h"
#include "core/control/rule_edit.h"
#include "core/document/link.h"
#include "core/document/style_weights.h"
#include "core/document/timeline_edit.h"
#include "core/document/transition.h"
#include "core/numeric/scalar_math.h"
#include "shell/host/script_answers.h"
#include "shell/host/script_options.h"
#include "tests/litter.h"
#include "tests/scene.h"
#include "tests/style_map.h"

namespace gaitsmith::test {

namespace {

int StepAt(double seconds) { return static_cast<int>(std::lround(100.0 * seconds)); }

}  // namespace

LessonVisit::LessonVisit(const Lesson& lesson) : session_(host_) { Open(lesson.links[0]); }

void LessonVisit::Open(const std::string& path) { REQUIRE(session_.Open(ReadFile(path))); }

void LessonVisit::Do(const JsonValue& step) {
  REQUIRE(step.names.size() == 1);
  const std::string& what = step.names[0];
  const JsonValue& value = step.items[0];
  const auto number = static_cast<float>(value.number);
  const int rods = Doc().figure.Rods();
  const auto change = [this](const shell::Session::Edit& edit) { REQUIRE(session_.Change(edit)); };
  session_.BeginGesture();
  if (what == "open") {
    Open("examples/" + value.text + ".json");
  } else if (what == "script" || what == "search") {
    Document wanted = Doc();
    int workers = 1;
    REQUIRE(shell::ApplySearchOptions(value, wanted, workers).empty());
    REQUIRE(session_.Set([&](Document& d) { d = wanted; }));
    const std::size_t before = host_.started.size();
    what == "script" ? session_.Search().SynthesizeForScript() : session_.Synthesize();
    REQUIRE(host_.started.size() == before + 1);
    EndSearch();
  } else if (what == "try") {
    session_.TryStyle();
    EndSearch();
  } else if (what == "record") {
    session_.RecordAsCurves();
  } else if (what == "knot") {
    change([&](Document& d) { d.controllers[0].genes[static_cast<std::size_t>(number)] ^= 8; });
  } else if (what == "delete") {
    for (const JsonValue& rule : value.items)
      change([&](Document& d) { DeleteRule(d.controllers[0], rods, static_cast<int>(rule.number) - 1); });
  } else if (what == "edit") {
    change([&](Document& d) {
      RuleEdit(d.controllers.back(), rods, static_cast<int>(number) - 1).SetTarget(0, 0.1f, -1.0f, 1.0f);
    });
  } else if (what == "rules") {
    REQUIRE(session_.Set([&](Document& d) { d.rules = static_cast<int>(number); }));
  } else if (what == "seed") {
    REQUIRE(session_.Set([&](Document& d) { d.search.seed = static_cast<std::uint32_t>(number); }));
  } else if (what == "weight") {
    const auto term = static_cast<std::size_t>(std::ranges::find(kStyleTermNames, value.names[0]) -
                                               kStyleTermNames.begin());
    const double weight = value.items[0].number * static_cast<double>(UsualWeights(Doc())[term]);
    REQUIRE(session_.Set([&](Document& d) { d.task.weights[term] = static_cast<float>(weight); }));
  } else if (what == "period") {
    change([&](Document& d) { d.controllers[0].senses.period_steps = StepAt(value.number); });
  } else if (what == "push") {
    change([&](Document& d) {
      d.pushes.clear();
      if (value.kind != JsonValue::Kind::kArray) return;
      d.pushes = {{.step = StepAt(value.items[2].number),
                   .impulse_x_ns = static_cast<float>(value.items[0].number),
                   .impulse_y_ns = static_cast<float>(value.items[1].number)}};
    });
  } else if (what == "slope") {
    change([&](Document& d) { d.environment.slope_rad = static_cast<float>(value.number * kPi / 180.0); });
  } else if (what == "gravity") {
    change([&](Document& d) { d.environment.gravity_mps2 = number; });
  } else if (what == "joints") {
    session_.World().LimitJoints(true);
    session_.World().SetJointStrength(number);
  } else if (what == "drop") {
    change([&](Document& d) { d.start.drop_height_m = number; });
  } else if (what == "switch") {
    change([&](Document& d) { REQUIRE(MoveSwitch(d, 1, StepAt(value.number))); });
  } else if (what == "snap") {
    Snap(StepAt(value.number));
  } else if (what == "square") {
    const auto bin = [&](std::size_t axis) { return static_cast<int>(value.items[axis].number); };
    session_.ShowElite(MapOf(host_.started.back()).MotionAt(bin(0), bin(1), bin(2)));
  } else if (what == "breed") {
    Breed(static_cast<int>(number));
  } else {
    FAIL(what);
  }
}

void LessonVisit::EndSearch() {
  const Document& searched = host_.started.back();
  Outcome found = RunSearchOf(searched);
  shell::SearchProgress progress{.state = shell::SearchState::kDone,
                                 .evaluations = searched.search.evaluations,
                                 .budget = searched.search.evaluations,
                                 .curve = {},
                                 .best_genome = std::move(found.best)};
  progress.best_fitness = found.fitness;
  session_.OnSearchProgress(std::move(progress));
}

void LessonVisit::Snap(int expected_step) {
  session_.Timeline().Select(1);
  session_.Timeline().Transitions().Advance(1.0);
  REQUIRE_FALSE(host_.mapped.empty());
  const TransitionMap map = TransitionMapOf(host_.mapped.back());
  session_.Timeline().Transitions().OnScores({.generation = host_.generations.back(),
                                              .first = 0,
                                              .usual = map.UsualScore(),
                                              .scores = map.Scores(0, map.Count())});
  session_.Timeline().SnapToBest();
  CHECK(Doc().timeline[1].start_step == expected_step);
}

void LessonVisit::Breed(int generations) {
  Document document = Doc();
  Lineage& family = document.lineage;
  std::vector<Genome> litter;
  std::vector<int> line;
  for (int round = family.rounds.empty() ? -1 : family.shown; round >= 0;
       round = family.rounds[static_cast<std::size_t>(round)].parent)
    line.insert(line.begin(), round);
  const auto grow = [&](int round) {
    const auto nursery = NurseryOf(document, round, litter);
    REQUIRE(nursery);
    litter.clear();
    for (const Brood::Member& child : ChildrenOf(*nursery)) litter.push_back(child.genome);
  };
  for (const int round : line) grow(round);
  if (line.empty()) family.founders = {document.controllers[0]};
  std::size_t best = 0;
  for (int i = 0; i < generations; ++i) {
    BreedRound round;
    round.difference = 0.5f;
    round.task = document.task;
    if (!litter.empty()) {
      round.parent = family.shown;
      round.picks = 0;
      std::vector<std::size_t> order(litter.size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::ranges::sort(order, std::greater(), [&](std::size_t child) {
        return TermsOf(ChildOf(document, litter[child])).rotations;
      });
      for (std::size_t k = 0; k < 2; ++k) round.picks |= 1u << order[k];
    }
    family.rounds.push_back(round);
    family.shown = static_cast<int>(family.rounds.size()) - 1;
    grow(family.shown);
  }
  float most = -1.0f;
  for (std::size_t child = 0; child < litter.size(); ++child) {
    const float turns = TermsOf(ChildOf(document, litter[child])).rotations;
    if (turns > most) best = child;
    most = std::max(most, turns);
  }
  REQUIRE(session_.Open(EncodeLink(ChildOf(document, litter[best])), shell::OpenedFrom::kBreeding));
}

bool LessonVisit::Meets(const std::string& goal) const {
  const auto measures = ParseJson(shell::MeasuresJson(session_));
  REQUIRE(measures);
  bool all = !measures->Find("broke")->boolean;
  for (const Condition& condition : ConditionsOf(goal)) {
    if (const JsonValue* one = measures->Find(condition.name); one != nullptr) {
      all &= one->kind == JsonValue::Kind::kNumber
                 ? Compare(one->number, condition)
                 : condition.relation == "=" && (one->text == condition.wanted ||
                                                 (condition.wanted == "earth" && one->text == "usual"));
      continue;
    }
    const JsonValue* has = nullptr;
    for (const JsonValue& term : measures->Find("terms")->items)
      if (term.Find("name")->text == condition.name) has = term.Find("value");
    REQUIRE(has != nullptr);
    all &= has->kind == JsonValue::Kind::kNumber && Compare(has->number, condition);
  }
  return all;
}

}  // namespace gaitsmith::test
