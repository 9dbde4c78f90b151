// SPDX-License-Identifier: MIT
// Settings, the one big button, progress and the curve.
#include "shell/panel_search.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "shell/algorithm_words.h"
#include "shell/plot.h"
#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

/// A population must fit into the budget.
void SuitBudget(SearchSettings& search) {
  const bool genetic = search.algorithm == Algorithm::kGga || search.algorithm == Algorithm::kSsga;
  if (genetic) search.evaluations = std::max(search.evaluations, search.genetic.population);
  if (search.algorithm == Algorithm::kMpga) {
    search.evaluations = std::max(search.evaluations, search.torus.side * search.torus.side);
  }
}

/// One parameter of the next search, whole or real, in a row of its own.
void WholeParameter(Ui& ui, Session& session, const char* id, const char* label, int low, int high, int step,
                    int& (*field)(SearchSettings&)) {
  SearchSettings search = session.Doc().search;
  int value = field(search);
  if (ui.Number(id, label, value, low, high, step)) {
    session.Set([&](Document& d) {
      field(d.search) = value;
      SuitBudget(d.search);
    });
  }
  ui.Gap(6.0f);
}
void RealParameter(Ui& ui, Session& session, const char* id, const char* label, const SliderRange& range,
                   float& (*field)(SearchSettings&)) {
  SearchSettings search = session.Doc().search;
  double value = static_cast<double>(field(search));
  if (ui.Slider(id, label, value, range, Fixed(value, 2))) {
    session.Set([&](Document& d) { field(d.search) = static_cast<float>(value); });
  }
  ui.Gap(6.0f);
}

void DrawRates(Ui& ui, Session& session) {
  RealParameter(ui, session, "search/mutation", "Mutation rate", {.low = 0.0, .high = 1.0},
                [](SearchSettings& s) -> float& { return s.genetic.rates.mutation; });
  RealParameter(ui, session, "search/crossover", "Crossover rate", {.low = 0.0, .high = 1.0},
                [](SearchSettings& s) -> float& { return s.genetic.rates.crossover; });
  static constexpr std::array<std::string_view, 2> kReadings = {"Per child", "Per component"};
  int reading = static_cast<int>(session.Doc().search.genetic.rates.reading);
  if (ui.Segmented("search/rates", ui.ControlRow(), "Rates are", kReadings, reading)) {
    session.Set([&](Document& d) { d.search.genetic.rates.reading = static_cast<RateReading>(reading); });
  }
  ui.Gap(6.0f);
}

void DrawStart(Ui& ui, Session& session) {
  const Document& d = session.Doc();
  const Controller* shown = session.ShownController();
  if (shown == nullptr || !SuitsSearch(d, *shown)) return;
  bool on = d.search.start >= 0;
  if (ui.Switch("search/start-here", "Start from the shown motion", on)) {
    session.Set([&](Document& next) {
      const auto clip = static_cast<std::size_t>(session.SelectedClip());
      next.search.start = on && clip < next.timeline.size() ? next.timeline[clip].controller : -1;
    });
  }
  ui.Gap(6.0f);
}

/// What the chosen algorithm can be told, beside budget and seed.
void DrawParameters(Ui& ui, Session& session) {
  const Algorithm algorithm = session.Doc().search.algorithm;
  if (RefinesOne(algorithm)) DrawStart(ui, session);
  switch (algorithm) {
    case Algorithm::kRandomSearch:
    case Algorithm::kShc:
      break;
    case Algorithm::kSphc:
      WholeParameter(ui, session, "search/population", "Population", 2, 1000, 1,
                     [](SearchSettings& s) -> int& { return s.population; });
      WholeParameter(ui, session, "search/reseed", "Reseed every (generations)", 1, 1'000'000, 10,
                     [](SearchSettings& s) -> int& { return s.reseed_interval; });
      break;
    case Algorithm::kGga:
    case Algorithm::kSsga:
      WholeParameter(ui, session, "search/population", "Population", 2, 10'000, 10,
                     [](SearchSettings& s) -> int& { return s.genetic.population; });
      DrawRates(ui, session);
      if (algorithm == Algorithm::kGga) break;
      RealParameter(ui, session, "search/rank-bias", "Rank bias", {.low = 1.0, .high = 2.0},
                    [](SearchSettings& s) -> float& { return s.genetic.rank_bias; });
      break;
    case Algorithm::kMpga:
      WholeParameter(ui, session, "search/side", "Side of the torus", 2, 128, 1,
                     [](SearchSettings& s) -> int& { return s.torus.side; });
      WholeParameter(ui, session, "search/walk", "Walk to a mate (steps)", 1, 1000, 1,
                     [](SearchSettings& s) -> int& { return s.torus.walk_steps; });
      DrawRates(ui, session);
      break;
    case Algorithm::kNelderMead:
    case Algorithm::kPowell:
      RealParameter(ui, session, "search/step", "First step", {.low = 0.01, .high = 1.0},
                    [](SearchSettings& s) -> float& { return s.refine.step; });
      break;
    case Algorithm::kCmaEs:
      RealParameter(ui, session, "search/step", "First step", {.low = 0.01, .high = 1.0},
                    [](SearchSettings& s) -> float& { return s.cma.step; });
      RealParameter(ui, session, "search/growth", "Growth at a restart",
                    {.low = 1.0, .high = 10.0, .step = 0.1},
                    [](SearchSettings& s) -> float& { return s.cma.growth; });
      break;
    case Algorithm::kMapElites:
      WholeParameter(ui, session, "search/bins", "Bins of each style term", 1, 32, 1,
                     [](SearchSettings& s) -> int& { return s.elites.bins; });
      WholeParameter(ui, session, "search/initial", "Random at first", 1, 100'000, 10,
                     [](SearchSettings& s) -> int& { return s.elites.initial; });
      break;
    case Algorithm::kTwoStage:
      WholeParameter(ui, session, "search/random", "Random at first", 1, 1'000'000, 100,
                     [](SearchSettings& s) -> int& { return s.two_stage.random; });
      WholeParameter(ui, session, "search/kept", "Of which climb", 1, 1000, 1,
                     [](SearchSettings& s) -> int& { return s.two_stage.kept; });
      break;
  }
}

void DrawSettings(Ui& ui, Session& session) {
  const SearchSettings& search = session.Doc().search;
  static const std::vector<std::string> kAlgorithms = [] {
    std::vector<std::string> titles;
    for (const AlgorithmWords& words : AlgorithmTexts()) titles.push_back(words.title);
    return titles;
  }();
  int algorithm = static_cast<int>(search.algorithm);
  if (ui.Combo("search/algorithm", "Algorithm", kAlgorithms, algorithm)) {
    session.Set([&](Document& d) {
      d.search.algorithm = static_cast<Algorithm>(algorithm);
      SuitBudget(d.search);
    });
  }
  ui.Paragraph(WordsOf(search.algorithm).line, Type::kNote);
  ui.Gap(6.0f);
  double budget = search.evaluations;
  if (ui.Slider("search/budget", "Budget", budget,
                {.low = 1000.0, .high = 1e6, .step = 1000.0, .logarithmic = true},
                Grouped(search.evaluations) + " evaluations")) {
    session.Set([&](Document& d) {
      d.search.evaluations = static_cast<int>(budget);
      SuitBudget(d.search);
    });
  }
  ui.Gap(8.0f);
  DrawParameters(ui, session);
  int seed = static_cast<int>(std::min<std::uint32_t>(search.seed, 999'999'999u));
  if (ui.Number("search/seed", "Seed", seed, 0, 999'999'999)) {
    session.Set([&](Document& d) { d.search.seed = static_cast<std::uint32_t>(seed); });
  }
  ui.Gap(6.0f);
  const int most = std::max(1, session.Place().MaxWorkers());
  ui.Number("search/workers", "Workers", session.workers, 1, most);
}

void DrawButtons(Ui& ui, Session& session) {
  const float height = 38.0f;
  const ImRect row = ui.Row(height);
  if (!session.Searching()) {
    if (ui.Button("search/start", row, "Synthesize", ButtonLook::kPrimary)) session.Synthesize();
    return;
  }
  const float middle = row.GetCenter().x;
  const ImRect left(row.Min, {middle - 4.0f, row.Max.y});
  const ImRect right({middle + 4.0f, row.Min.y}, row.Max);
  if (session.Progress().state == SearchState::kPaused) {
    if (ui.Button("search/resume", left, "Resume", ButtonLook::kPrimary)) session.Resume();
  } else {
    if (ui.Button("search/pause", left, "Pause")) session.Pause();
  }
  if (ui.Button("search/stop", right, "Stop")) session.Stop();
}

void DrawProgress(Ui& ui, const Session& session) {
  const SearchProgress& progress = session.Progress();
  const Palette& p = ui.Ink();
  const float share = progress.budget > 0
                          ? static_cast<float>(progress.evaluations) / static_cast<float>(progress.budget)
                          : 0.0f;
  const ImRect row = ui.Row(6.0f);
  ui.Canvas()->AddRectFilled(row.Min, row.Max, p.soft, 3.0f);
  ui.Canvas()->AddRectFilled(row.Min, {row.Min.x + std::clamp(share, 0.0f, 1.0f) * row.GetWidth(), row.Max.y},
                             p.good, 3.0f);
  ui.Gap(8.0f);
  ui.Fact(Grouped(progress.evaluations) + " of " + Grouped(progress.budget),
          progress.state == SearchState::kRunning  ? Duration(progress.seconds_left) + " left"
          : progress.state == SearchState::kPaused ? "paused"
          : progress.state == SearchState::kDone   ? "done"
                                                   : "stopped");
  ui.Fact(Grouped(static_cast<long long>(progress.evaluations_per_second)) + " evaluations/s",
          std::to_string(progress.workers) + (progress.workers == 1 ? " worker" : " workers"));
}

void DrawCurve(Ui& ui, const Session& session) {
  const SearchProgress& progress = session.Progress();
  std::vector<PlotPoint> points;
  points.reserve(progress.curve.size() + 1);
  for (const Search::CurvePoint& point : progress.curve) {
    if (point.best <= kVoidScore / 2.0f) continue;
    points.push_back({static_cast<double>(point.evaluation), static_cast<double>(point.best)});
  }
  if (!points.empty()) points.push_back({static_cast<double>(progress.evaluations), points.back().y});
  const PlotSeries series{.name = "best so far", .points = points, .colour = ui.Ink().good};
  const std::string best = points.empty() ? "none yet" : Fixed(progress.best_fitness, 2);
  const ImRect head = ui.Row(24.0f);
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {head.Min.x, head.GetCenter().y}, ui.Ink().ink,
                    "Best so far");
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {head.Max.x, head.GetCenter().y}, ui.Ink().good, best,
                    Align::kRight);
  DrawPlot(
      ui, "search/curve", "Best score so far", ui.Row(168.0f),
      {.x_end = static_cast<double>(std::max(progress.budget, 1)), .x_label = "evaluations", .y_unit = ""},
      std::span(&series, 1), "best " + best + " after " + Grouped(progress.evaluations) + " evaluations");
}

}  // namespace

void DrawSearchPanel(Ui& ui, Session& session) {
  DrawButtons(ui, session);
  ui.Gap(12.0f);
  if (session.Progress().budget > 0) {
    DrawProgress(ui, session);
    ui.Gap(6.0f);
    DrawCurve(ui, session);
    ui.Gap(12.0f);
  }
  DrawSettings(ui, session);
  ui.Gap(10.0f);
  const Document& d = session.Doc();
  ui.Paragraph("Looks for " + ControllerWords(d.kind, d.senses, d.rules) + " that can make " + d.figure.name +
                   " " + TaskWords(d.task.kind) + " for " +
                   Fixed(static_cast<float>(d.task.duration_steps) * kStep, 1) + " s.",
               Type::kNote);
}

}  // namespace gaitsmith::shell
