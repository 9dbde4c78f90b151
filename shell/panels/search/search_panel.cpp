// SPDX-License-Identifier: MIT
// The search button, progress and curve, and below them the foldable sections.
#include "shell/panels/search/search_panel.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "shell/panels/search/elite_panel.h"
#include "shell/panels/search/queue_list.h"
#include "shell/panels/search/search_settings_form.h"
#include "shell/panels/search/suite_form.h"
#include "shell/widgets/fold.h"
#include "shell/widgets/plot.h"
#include "shell/words/algorithm_words.h"
#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kGap = 8.0f;  // between buttons in a row

std::array<ImRect, 2> Halves(const ImRect& row) {
  const float middle = row.GetCenter().x;
  return {ImRect(row.Min, {middle - 0.5f * kGap, row.Max.y}),
          ImRect({middle + 0.5f * kGap, row.Min.y}, row.Max)};
}

void DrawSearchButtons(Ui& ui, Session& session) {
  const ImRect row = ui.Row(ui.Look().MainHeight());
  if (!session.Search().Running()) {
    const bool again = session.Search().WouldRepeat() && !session.Layout().Locks(LockedPart::kSearch);
    if (ui.Button("search/start", row, Tr(again ? "Try another" : "Synthesize"), ButtonLook::kPrimary))
      session.Synthesize();
    return;
  }
  const auto [left, right] = Halves(row);
  if (session.Search().Progress().state == SearchState::kPaused) {
    if (ui.Button("search/resume", left, Tr("Resume"), ButtonLook::kPrimary)) session.Search().Resume();
  } else {
    if (ui.Button("search/pause", left, Tr("Pause"))) session.Search().Pause();
  }
  if (ui.Button("search/stop", right, Tr("Stop"))) session.Stop();
}

/// Buttons that queue the search, with one seed or several, and that save the motion to the results.
void DrawKeepingButtons(Ui& ui, Session& session) {
  const ImRect row = ui.ControlRow();
  const float part = (row.GetWidth() - 2.0f * kGap) / 3.0f;
  const auto place = [&](float from, float to) {
    return ImRect({row.Min.x + from * (part + kGap), row.Min.y},
                  {row.Min.x + to * (part + kGap) - kGap, row.Max.y});
  };
  const bool full = session.Queue().List().Full();
  if (ui.Button("queue/add", place(0, 1), Tr(full ? "Queue is full" : "Add to queue"), ButtonLook::kOutlined,
                !full))
    session.Queue().Add(session.Doc());
  if (ui.Button("queue/seeds", place(1, 2), Tr(full ? "Queue is full" : "Queue 5 seeds"),
                ButtonLook::kOutlined, !full))
    session.Queue().AddSeeds(kQueuedSeeds);
  const bool motion = !session.Doc().timeline.empty();
  if (ui.Button("found/keep", place(2, 3), Tr(motion ? "Save to results" : "No motion yet"),
                ButtonLook::kOutlined, motion))
    session.Results().KeepShown();
}

void DrawProgress(Ui& ui, const SearchRun& search) {
  const SearchProgress& progress = search.Progress();
  const Palette& p = ui.Ink();
  // Always one line, so that nothing below moves under the pointer when the next search begins.
  const ImRect title = ui.Row(Fonts::LineHeight(Type::kNote) + 6.0f);
  ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {title.Min.x, title.GetCenter().y - 3.0f},
                          title.GetWidth(), p.second_ink, search.Title());
  const ImRect row = ui.Row(6.0f);
  ui.Canvas()->AddRectFilled(row.Min, row.Max, p.soft, 3.0f);
  ui.Canvas()->AddRectFilled(row.Min, {row.Min.x + progress.Share() * row.GetWidth(), row.Max.y}, p.good,
                             3.0f);
  ui.Gap(8.0f);
  ui.Fact(Tr("{1} of {2}", Grouped(progress.evaluations), Grouped(progress.budget)),
          progress.state == SearchState::kRunning   ? Tr("{1} left", Duration(progress.seconds_left))
          : progress.state == SearchState::kPaused  ? Tr("paused")
          : progress.state == SearchState::kDone    ? Tr("done")
          : progress.state == SearchState::kStopped ? Tr("stopped")
                                                    : Tr("failed"));
  ui.Fact(Tr("{1} evaluations/s", Grouped(static_cast<long long>(progress.evaluations_per_second))),
          Tr(progress.workers == 1 ? "{1} worker" : "{1} workers", progress.workers));
}

/// The population's spread in words; empty if there is no population.
std::string SpreadText(const SearchProgress& progress) {
  if (!progress.spread) return {};
  const Spread& s = *progress.spread;
  return Tr("population of {1}: median {2}, quartiles {3} and {4}, from {5} to {6}", Grouped(s.members),
            Fixed(s.median, 2), Fixed(s.lower_quartile, 2), Fixed(s.upper_quartile, 2), Fixed(s.least, 2),
            Fixed(s.best, 2));
}

/// The plot's legend.
void DrawLegend(Ui& ui, const SearchProgress& progress) {
  const Palette& p = ui.Ink();
  const ImRect row = ui.Row(Fonts::LineHeight(Type::kNote));
  const float y = row.GetCenter().y;
  const float sample = 14.0f;
  ui.Canvas()->AddRectFilled({row.Min.x, y - 1.0f}, {row.Min.x + sample, y + 1.0f}, p.good);
  float x = row.Min.x + sample + 6.0f;
  ui.Letters().Draw(ui.Canvas(), Type::kNote, {x, y}, p.second_ink, Tr("best"));
  if (!progress.spread) return;  // no population, or no report of it yet
  x += ui.Letters().Width(Type::kNote, Tr("best")) + 14.0f;
  ui.Canvas()->AddRectFilled({x, y - 5.0f}, {x + sample, y + 5.0f}, Fade(p.second_ink, 0.18f));
  ui.Canvas()->AddRectFilled({x, y - 0.6f}, {x + sample, y + 0.6f}, p.second_ink);
  x += sample + 6.0f;
  ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {x, y}, row.Max.x - x, p.second_ink,
                          Tr("population of {1}: median and quartiles", Grouped(progress.spread->members)));
}

void DrawCurve(Ui& ui, const SearchRun& search) {
  const SearchProgress& progress = search.Progress();
  std::vector<PlotPoint> best_points;
  best_points.reserve(progress.curve.size() + 1);
  for (const Search::CurvePoint& point : progress.curve) {
    if (point.best <= kVoidScore / 2.0f) continue;
    best_points.push_back({static_cast<double>(point.evaluation), static_cast<double>(point.best)});
  }
  if (!best_points.empty())
    best_points.push_back({static_cast<double>(progress.evaluations), best_points.back().y});
  std::vector<PlotPoint> medians;
  std::vector<PlotSpread> quartiles;
  for (const auto& [evaluation, spread] : search.PopulationSpread().Points()) {
    const auto x = static_cast<double>(evaluation);
    medians.push_back({x, static_cast<double>(spread.median)});
    quartiles.push_back(
        {x, static_cast<double>(spread.lower_quartile), static_cast<double>(spread.upper_quartile)});
  }
  const std::array<PlotSeries, 2> series = {
      PlotSeries{.name = Tr("population"),
                 .points = medians,
                 .colour = ui.Ink().second_ink,
                 .spread = quartiles,
                 .thin = true},
      PlotSeries{.name = Tr("best so far"), .points = best_points, .colour = ui.Ink().good}};
  const std::string best = best_points.empty() ? Tr("none yet") : Fixed(progress.best_fitness, 2);
  const ImRect head = ui.Row(24.0f);
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {head.Min.x, head.GetCenter().y}, ui.Ink().ink,
                    Tr("Best so far"));
  const ImU32 colour = best_points.empty() ? ui.Ink().ink : ui.Ink().ScoreInk(progress.best_fitness);
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {head.Max.x, head.GetCenter().y}, colour, best,
                    Align::kRight);
  const std::string summary = Tr("best {1} after {2} evaluations", best, Grouped(progress.evaluations));
  const std::string spread = SpreadText(progress);
  DrawPlot(ui, "search/curve", Tr("Best score so far, and the population's spread"), ui.Row(158.0f),
           {.x_end = static_cast<double>(std::max(progress.budget, 1)),
            .x_label = Tr("evaluations"),
            .y_unit = ""},
           series, summary + (spread.empty() ? "" : "; " + spread));
  DrawLegend(ui, progress);
}

void DrawSettings(Ui& ui, Session& session, SearchPanelState& state) {
  const Document& d = session.Doc();
  if (!DrawFold(ui, "search/settings", Tr("Next search"), state.settings ? "" : SearchLine(d),
                state.settings))
    return;
  ui.Paragraph(Tr("Looks for {1} that can make {2} {3} for {4} s.",
                  ControllerWords(d.kind, d.senses, d.rules), TrTitle(d.figure.name), TaskWords(d.task.kind),
                  Fixed(static_cast<float>(d.task.duration_steps) * kStep, 1)),
               Type::kNote);
  ui.Gap(6.0f);
  if (session.Layout().Locks(LockedPart::kSearch)) ui.LockNote();
  DrawSearchSettings(ui, session, state.form);
  ui.Gap(6.0f);
}

}  // namespace

void DrawSearchPanel(Ui& ui, Session& session, SearchPanelState& state) {
  DrawSearchButtons(ui, session);
  ui.Gap(kGap);
  if (session.Search().Progress().budget > 0) {
    DrawProgress(ui, session.Search());
    ui.Gap(4.0f);
    DrawCurve(ui, session.Search());
    ui.Gap(10.0f);
  }
  state.elite_map.poses.BeginFrame();
  if (session.Search().Elites() && SameTree(session.Search().Elites()->Whose(), session.Doc().figure) &&
      DrawFold(ui, "elites", Tr("Map of styles"), Grouped(session.Search().Elites()->Count()), state.elites))
    DrawEliteMap(ui, session, state.elite_map);
  state.front_map.poses.BeginFrame();
  if (session.Search().Front() && SameTree(session.Search().Front()->Whose(), session.Doc().figure) &&
      DrawFold(ui, "front", Tr("Score against cost"),
               Grouped(static_cast<long long>(session.Search().Front()->Count())), state.front))
    DrawFront(ui, session, state.front_map);
  DrawKeepingButtons(ui, session);
  ui.Gap(kGap);
  ui.Lock(session.Layout().Locks(LockedPart::kSearch));
  DrawSettings(ui, session, state);
  ui.Lock(false);
  if (DrawFold(ui, "suite", Tr("Suite"), Tr("{1} to make", std::to_string(state.suite_of.Searches())),
               state.suite))
    DrawSuiteForm(ui, session, state.suite_of);
  const auto waiting = static_cast<long long>(session.Queue().List().Waiting().size());
  const std::string queued =
      waiting == 0 ? Tr("empty") : Tr(waiting == 1 ? "{1} waits" : "{1} wait", Grouped(waiting));
  if (DrawFold(ui, "queue", Tr("Queue"), queued, state.queue)) DrawQueue(ui, session);
  const auto found = static_cast<long long>(session.Results().Motions().Count());
  if (DrawFold(ui, "found", Tr("Results"), found == 0 ? Tr("none yet") : Grouped(found), state.found))
    DrawFound(ui, session, state.list);
}

}  // namespace gaitsmith::shell
