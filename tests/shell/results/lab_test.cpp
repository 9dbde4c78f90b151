// SPDX-License-Identifier: MIT
// The lab without workers: the order of trials, the summary of their curves, and refused settings.
#include "shell/results/lab.h"

#include <catch_amalgamated.hpp>

#include "tests/scene.h"

namespace gaitsmith::shell::test {

namespace {

Document LabProblem() {
  Document document;
  document.title = "Mr. Star-Man · travel, seed 5";
  document.figure = gaitsmith::test::ShippedFigure("mr-star-man");
  return document;
}

LabSettings TwoAlgorithms() {
  LabSettings settings{.trials = 3, .evaluations = 400, .first_seed = 7};
  settings.chosen.fill(false);
  settings.chosen[static_cast<std::size_t>(Algorithm::kSphc)] = true;
  settings.chosen[static_cast<std::size_t>(Algorithm::kRandomSearch)] = true;
  return settings;
}

}  // namespace

TEST_CASE("lab: algorithms take turns", "[shell][lab]") {
  Lab lab;
  lab.settings = TwoAlgorithms();
  REQUIRE(lab.Begin(LabProblem()));
  REQUIRE(lab.Total() == 6);
  const std::vector<Search::CurvePoint> curve = {{1, 0.5f}};
  for (int i = 0; i < 6; ++i) {
    CAPTURE(i);
    const Lab::Trial trial = lab.Now();
    CHECK(trial.algorithm == (i % 2 == 0 ? Algorithm::kRandomSearch : Algorithm::kSphc));
    CHECK(trial.seed == 7u + static_cast<std::uint32_t>(i / 2));
    CHECK(trial.document.search.seed == trial.seed);
    CHECK(trial.document.search.evaluations == 400);
    CHECK(Validate(trial.document));
    REQUIRE(lab.Running());
    lab.Finish(curve);
  }
  CHECK(lab.State() == LabState::kDone);
}

TEST_CASE("lab: medians and quartiles are those of the curves at each count", "[shell][lab]") {
  Lab lab;
  lab.settings = TwoAlgorithms();
  lab.settings.chosen[static_cast<std::size_t>(Algorithm::kSphc)] = false;
  REQUIRE(lab.Begin(LabProblem()));
  // One point every 4 evaluations. The second trial has no motion before evaluation 101.
  lab.Finish(std::vector<Search::CurvePoint>{{1, 1.0f}, {200, 3.0f}});
  lab.Finish(std::vector<Search::CurvePoint>{{1, kVoidScore}, {101, 2.0f}});
  lab.Finish(std::vector<Search::CurvePoint>{{4, 5.0f}, {399, 7.0f}});
  const LabSeries& series = lab.Series().front();
  REQUIRE(series.trials == 3);
  REQUIRE(series.points.front().evaluations == 104);  // earlier counts have a trial without a motion
  CHECK(series.points.front().lower_quartile == 1.5);
  CHECK(series.points.front().median == 2.0);
  CHECK(series.points.front().upper_quartile == 3.5);
  CHECK(series.points.back().evaluations == 400);
  CHECK(series.points.back().lower_quartile == 2.5);
  CHECK(series.points.back().median == 3.0);
  CHECK(series.points.back().upper_quartile == 5.0);
}

TEST_CASE("lab: writes a file that compare can read, even before the end", "[shell][lab]") {
  Lab lab;
  lab.settings = TwoAlgorithms();
  REQUIRE(lab.Begin(LabProblem()));
  lab.Finish(std::vector<Search::CurvePoint>{{1, 0.25f}});
  lab.Finish(std::vector<Search::CurvePoint>{{2, 0.5f}});
  lab.Finish(std::vector<Search::CurvePoint>{{3, 0.75f}});
  const auto file = StudyFile::Parse(lab.Csv(), "curves.csv", Ending::kWhole);
  REQUIRE(file);
  CHECK(file->plan.problems == std::vector<std::string>{"mr-star-man-travel-seed-5"});
  CHECK(file->plan.Total() == 6);
  CHECK(file->trials.size() == 3);
  CHECK(file->trials.contains(3));  // in canonical order all trials of rgt precede those of sphc
  CHECK(file->Text() == lab.Csv());
}

TEST_CASE("lab: refuses settings that an algorithm cannot use, and keeps the earlier results",
          "[shell][lab]") {
  Lab lab;
  lab.settings = TwoAlgorithms();
  REQUIRE(lab.Begin(LabProblem()));
  lab.Finish(std::vector<Search::CurvePoint>{{1, 0.25f}});
  lab.End(LabState::kStopped);
  const std::string before = lab.Csv();

  lab.settings.chosen[static_cast<std::size_t>(Algorithm::kMpga)] = true;  // its torus has 4,096 cells
  const auto crowded = lab.Begin(LabProblem());
  REQUIRE_FALSE(crowded);
  CHECK(crowded.error().where == "mpga: search.evaluations");
  lab.settings.chosen.fill(false);
  CHECK_FALSE(lab.Begin(LabProblem()));
  lab.settings = TwoAlgorithms();
  lab.settings.trials = kMaxLabTrials + 1;
  CHECK_FALSE(lab.Begin(LabProblem()));
  lab.settings.trials = 2;
  lab.settings.first_seed = 0xffffffffu;
  CHECK_FALSE(lab.Begin(LabProblem()));

  CHECK(lab.State() == LabState::kStopped);
  CHECK(lab.Csv() == before);
}

TEST_CASE("lab: the problem keeps senses, task and kind of controller, not the document's search",
          "[shell][lab]") {
  Document document = LabProblem();
  document.kind = ControllerKind::kNetwork;
  document.rules = 7;
  document.task.kind = TaskKind::kJump;
  document.search.population = 33;
  Lab lab;
  lab.settings = TwoAlgorithms();
  REQUIRE(lab.Begin(document));
  const Document trial = lab.Now().document;
  CHECK(trial.kind == ControllerKind::kNetwork);
  CHECK(trial.rules == 7);
  CHECK(trial.task.kind == TaskKind::kJump);
  CHECK(trial.search.population == SearchSettings{}.population);
}

}  // namespace gaitsmith::shell::test
