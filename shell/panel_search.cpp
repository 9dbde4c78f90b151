// SPDX-License-Identifier: MIT
// Settings, the one big button, progress and the curve.
#include "shell/panel_search.h"

#include <algorithm>
#include <array>
#include <string>

#include "shell/plot.h"
#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

void DrawSettings(Ui& ui, Session& session) {
  const SearchSettings& search = session.Doc().search;
  static const std::array<std::string, 2> kAlgorithms = {"RG&T: at random", "SPHC: hill climbing"};
  int algorithm = static_cast<int>(search.algorithm);
  if (ui.Combo("search/algorithm", "Algorithm", kAlgorithms, algorithm)) {
    session.Set([&](Document& d) { d.search.algorithm = static_cast<Algorithm>(algorithm); });
  }
  ui.Gap(6.0f);
  double budget = search.evaluations;
  if (ui.Slider("search/budget", "Budget", budget,
                {.low = 1000.0, .high = 1e6, .step = 1000.0, .logarithmic = true},
                Grouped(search.evaluations) + " evaluations")) {
    session.Set([&](Document& d) { d.search.evaluations = static_cast<int>(budget); });
  }
  ui.Gap(8.0f);
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
  ui.Paragraph("Looks for " + std::to_string(d.rules) + " rules with " + SenseWords(d.senses) +
                   " that make " + d.figure.name + " " + TaskWords(d.task.kind) + " for " +
                   Fixed(static_cast<float>(d.task.duration_steps) * kStep, 1) + " s.",
               Type::kNote);
}

}  // namespace gaitsmith::shell
