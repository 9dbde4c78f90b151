// SPDX-License-Identifier: MIT
// The lab: choice of algorithms and trials, their curves with quartiles, a table and a file.
#include "shell/panels/lab/lab_panel.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "shell/panels/lab/algorithm_look.h"
#include "shell/widgets/fold.h"
#include "shell/widgets/plot.h"
#include "shell/words/algorithm_words.h"
#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

ImU32 ColourOf(const Theme& theme, Algorithm algorithm) { return theme.Rule(LookOf(algorithm).hue); }

/// "SPHC, 3 trials: median 5.31, quartiles 4.20 and 6.10"
std::string SeriesText(const LabSeries& series) {
  const std::string name = AlgorithmName(series.algorithm);
  std::string text =
      Tr(series.trials == 1 ? "{1}, {2} trial" : "{1}, {2} trials", name, Grouped(series.trials));
  if (series.trials == 0) return text;
  if (series.points.empty()) return Tr("{1}: no motion", text);
  const LabSeries::Point& end = series.points.back();
  return Tr("{1}: median {2}, quartiles {3} and {4}", text, Fixed(end.median, 2),
            Fixed(end.lower_quartile, 2), Fixed(end.upper_quartile, 2));
}

/// "halfway after 1,240 (900 to 2,100)", or "(900 or more)": some samples of the trials never got there.
std::string HalfwayText(const RunningTime& time) {
  if (time.reached == 0) return Tr("not halfway");
  const auto rounded = [](double evaluations) {
    return Grouped(static_cast<long long>(std::lround(evaluations)));
  };
  if (!std::isfinite(time.high))
    return Tr("halfway after {1} ({2} or more)", rounded(time.expected), rounded(time.low));
  return Tr("halfway after {1} ({2} to {3})", rounded(time.expected), rounded(time.low), rounded(time.high));
}

std::string AllText(const Lab& lab) {
  std::string text;
  for (const LabSeries& series : lab.Series()) text += (text.empty() ? "" : "; ") + SeriesText(series);
  return Tr("{1}. After {2} evaluations", text, Grouped(lab.Evaluations()));
}

void DrawButtons(Ui& ui, Session& session) {
  const ImRect row = ui.Row(ui.Look().MainHeight());
  if (session.Lab().Running()) {
    if (ui.Button("lab/stop", row, Tr("Stop"))) session.Lab().Stop();
  } else if (ui.Button("lab/start", row, Tr("Start"), ButtonLook::kPrimary)) {
    session.Lab().Start();
  }
}

void DrawProgress(Ui& ui, const Lab& lab) {
  const ImRect row = ui.Row(6.0f);
  const float share = static_cast<float>(lab.Finished()) / static_cast<float>(std::max(1, lab.Total()));
  ui.Canvas()->AddRectFilled(row.Min, row.Max, ui.Ink().soft, 3.0f);
  ui.Canvas()->AddRectFilled(row.Min, {row.Min.x + share * row.GetWidth(), row.Max.y}, ui.Ink().good, 3.0f);
  ui.Gap(8.0f);
  ui.Fact(Tr(lab.Total() == 1 ? "{1} of {2} trial" : "{1} of {2} trials", Grouped(lab.Finished()),
             Grouped(lab.Total())),
          Tr(lab.Running()                       ? "running"
             : lab.State() == LabState::kDone    ? "done"
             : lab.State() == LabState::kStopped ? "stopped"
                                                 : "failed"));
}

void DrawCurves(Ui& ui, const Lab& lab) {
  std::vector<std::vector<PlotPoint>> medians;
  std::vector<std::vector<PlotSpread>> spreads;
  for (const LabSeries& series : lab.Series()) {
    medians.emplace_back();
    spreads.emplace_back();
    for (const LabSeries::Point& point : series.points) {
      const auto x = static_cast<double>(point.evaluations);
      medians.back().push_back({x, point.median});
      spreads.back().push_back({x, point.lower_quartile, point.upper_quartile});
    }
  }
  std::vector<PlotSeries> plotted;
  for (std::size_t i = 0; i < medians.size(); ++i) {
    const Algorithm algorithm = lab.Series()[i].algorithm;
    plotted.push_back({.name = AlgorithmName(algorithm),
                       .points = medians[i],
                       .colour = ColourOf(ui.Look(), algorithm),
                       .spread = spreads[i],
                       .dashed = LookOf(algorithm).dashed});
  }
  const ImRect head = ui.Row(24.0f);
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {head.Min.x, head.GetCenter().y}, ui.Ink().ink,
                    Tr("Best so far"));
  ui.Letters().Draw(ui.Canvas(), Type::kNote, {head.Max.x, head.GetCenter().y}, ui.Ink().second_ink,
                    Tr("median and quartiles"), Align::kRight);
  DrawPlot(ui, "lab/curves", Tr("Best score so far: medians and quartiles"), ui.Row(190.0f),
           {.x_end = static_cast<double>(std::max(lab.Evaluations(), 1)),
            .x_label = Tr("evaluations"),
            .y_unit = ""},
           plotted, AllText(lab));
}

/// "SPHC: 62 % of the targets, halfway after 1,240 (900 to 2,100)"
std::string ReachedText(const LabSeries& series) {
  const std::string name = AlgorithmName(series.algorithm);
  if (!series.to_halfway) return Tr("{1}: none yet", name);
  return Tr("{1}: {2} % of the targets, {3}", name, Fixed(100.0 * series.reached.back().share, 0),
            HalfwayText(*series.to_halfway));
}

/// How soon targets are reached: the empirical distribution of running times.
void DrawReached(Ui& ui, const Lab& lab) {
  std::vector<std::vector<PlotPoint>> shares;
  std::string all;
  for (const LabSeries& series : lab.Series()) {
    shares.emplace_back();
    for (const auto& [evaluations, share] : series.reached)
      shares.back().push_back({static_cast<double>(evaluations), 100.0 * share});
    all += (all.empty() ? "" : "; ") + ReachedText(series);
  }
  std::vector<PlotSeries> plotted;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Algorithm algorithm = lab.Series()[i].algorithm;
    plotted.push_back({.name = AlgorithmName(algorithm),
                       .points = shares[i],
                       .colour = ColourOf(ui.Look(), algorithm),
                       .spread = {},
                       .dashed = LookOf(algorithm).dashed});
  }
  DrawPlot(ui, "lab/reached", Tr("Targets reached"), ui.Row(150.0f),
           {.x_end = static_cast<double>(std::max(lab.Evaluations(), 1)),
            .x_label = Tr("evaluations"),
            .y_unit = "%"},
           plotted, all);
  ui.Paragraph(
      Tr("Twenty targets, from what the trials have at first to the best of all. The curve is how many of "
         "them the trials have reached. Halfway is a score of {1}.",
         lab.Halfway() ? Fixed(*lab.Halfway(), 2) : "–"),
      Type::kNote);
  for (const LabSeries& series : lab.Series()) {
    if (series.to_halfway) ui.Fact(AlgorithmName(series.algorithm), HalfwayText(*series.to_halfway));
  }
}

/// The final values of the curves, and the plot's legend.
void DrawTable(Ui& ui, const Lab& lab) {
  // Right edges of the right-aligned columns, as shares of the width.
  constexpr float kTrials = 0.44f, kMedian = 0.66f, kQuartiles = 1.0f;
  const float line = ui.Look().touch ? 24.0f : 20.0f;
  const ImRect whole = ui.Row(line * static_cast<float>(lab.Series().size() + 1));
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav | ImGuiItemFlags_NoTabStop, true);
  ui.Area("lab/table", whole, Grab::kNothing,
          {.label = Tr("Best of the trials"), .role = "note", .value = AllText(lab)});
  ImGui::PopItemFlag();
  ImDrawList* list = ui.Canvas();
  float y = whole.Min.y + 0.5f * line;
  const auto put = [&](Type type, float column, ImU32 colour, const std::string& text) {
    ui.Letters().Draw(list, type, {whole.Min.x + column * whole.GetWidth(), y}, colour, text, Align::kRight);
  };
  put(Type::kNote, kTrials, ui.Ink().second_ink, Tr("trials"));
  put(Type::kNote, kMedian, ui.Ink().second_ink, Tr("median"));
  put(Type::kNote, kQuartiles, ui.Ink().second_ink, Tr("quartiles"));
  for (const LabSeries& series : lab.Series()) {
    y += line;
    DrawLineSample(list, {whole.Min.x + 0.5f * kLineSample, y}, ColourOf(ui.Look(), series.algorithm),
                   LookOf(series.algorithm).dashed);
    ui.Letters().Draw(list, Type::kBody, {whole.Min.x + kLineSample + 7.0f, y}, ui.Ink().ink,
                      AlgorithmName(series.algorithm));
    put(Type::kBody, kTrials, ui.Ink().second_ink, Grouped(series.trials));
    if (series.points.empty()) {
      put(Type::kBody, kQuartiles, ui.Ink().second_ink, Tr(series.trials > 0 ? "no motion" : "none yet"));
      continue;
    }
    const LabSeries::Point& end = series.points.back();
    put(Type::kStrong, kMedian, ui.Ink().ink, Fixed(end.median, 2));
    put(Type::kBody, kQuartiles, ui.Ink().second_ink,
        Tr("{1} to {2}", Fixed(end.lower_quartile, 2), Fixed(end.upper_quartile, 2)));
  }
}

/// One toggle per algorithm, wrapped into rows.
/// @param all  further ones, too; those that are chosen are always there
void DrawAlgorithms(Ui& ui, LabSettings& settings, bool all) {
  constexpr float kGap = 6.0f;
  const PartScope part = ui.Part("lab/algorithms", "group", Tr("Algorithms to compare"));
  const Palette& p = ui.Ink();
  const auto width_of = [&](std::size_t i) {
    return ui.Letters().Width(Type::kBody, AlgorithmTexts()[i].name) + 34.0f;
  };
  std::vector<std::size_t> listed;
  for (std::size_t i = 0; i < AlgorithmTexts().size(); ++i) {
    if (all || std::cmp_less(i, kListedAlgorithms) || settings.chosen[i]) listed.push_back(i);
  }
  for (std::size_t at = 0; at < listed.size(); ui.Gap(kGap)) {
    const ImRect row = ui.ControlRow();
    for (float x = row.Min.x; at < listed.size(); ++at) {
      const std::size_t next = listed[at];
      const float width = width_of(next);
      if (x > row.Min.x && x + width > row.Max.x) break;
      const ImRect chip({x, row.Min.y}, {std::min(x + width, row.Max.x), row.Max.y});
      bool& on = settings.chosen[next];
      const Touch touch = ui.Area("lab/algorithm/" + std::string(kAlgorithmNames[next]), chip, Grab::kPress,
                                  {.label = Tr(AlgorithmTexts()[next].title),
                                   .role = "switch",
                                   .value = Tr(on ? "on" : "off"),
                                   .state = {.checked = on}});
      if (touch.pressed) on = !on;
      x += width + kGap;
      if (!touch.visible) continue;
      const auto algorithm = static_cast<Algorithm>(next);
      const ImU32 colour = ColourOf(ui.Look(), algorithm);
      const ImU32 behind =
          on ? Mix(p.panel, colour, 0.14f) : Mix(p.panel, p.ink, touch.hovered ? 0.04f : 0.0f);
      ui.Frame(chip, behind, on ? Mix(p.panel, colour, 0.7f) : p.line);
      const ImVec2 dot(chip.Min.x + 14.0f, chip.GetCenter().y);
      if (on) {
        ui.Canvas()->AddCircleFilled(dot, 4.5f, colour);
        if (LookOf(algorithm).dashed)  // cut in two, like its line
          ui.Canvas()->AddRectFilled({dot.x - 1.0f, dot.y - 5.0f}, {dot.x + 1.0f, dot.y + 5.0f}, behind);
      } else {
        ui.Canvas()->AddCircle(dot, 4.0f, p.second_ink, 0, 1.2f);
      }
      ui.Letters().Draw(ui.Canvas(), Type::kBody, {chip.Min.x + 24.0f, chip.GetCenter().y},
                        on ? p.ink : p.second_ink, AlgorithmTexts()[next].name);
      ui.DrawFocus(touch, chip);
    }
  }
}

void DrawSettings(Ui& ui, LabSettings& settings, bool& all_algorithms) {
  DrawAlgorithms(ui, settings, all_algorithms);
  ui.Gap(4.0f);
  ui.Switch("lab/all-algorithms", Tr("More algorithms"), all_algorithms);
  ui.Gap(4.0f);
  ui.Number("lab/trials", Tr("Trials of each"), settings.trials, kMinLabTrials, kMaxLabTrials);
  ui.Gap(6.0f);
  double evaluations = settings.evaluations;
  if (ui.Slider("lab/evaluations", Tr("Evaluations of each"), evaluations,
                {.low = 500.0, .high = 40'000.0, .step = 100.0, .logarithmic = true},
                Grouped(settings.evaluations))) {
    settings.evaluations = static_cast<int>(evaluations);
  }
  ui.Gap(6.0f);
  constexpr int kMaxSeed = 999'999'999;
  int seed = static_cast<int>(std::min<std::uint32_t>(settings.first_seed, kMaxSeed));
  if (ui.Number("lab/first-seed", Tr("First seed"), seed, 0, kMaxSeed))
    settings.first_seed = static_cast<std::uint32_t>(seed);
}

}  // namespace

void DrawLabPanel(Ui& ui, Session& session, LabPanelState& state) {
  Lab& lab = session.Lab().Trials();
  DrawButtons(ui, session);
  ui.Gap(12.0f);
  if (lab.Total() > 0) {
    DrawProgress(ui, lab);
    ui.Gap(6.0f);
    DrawCurves(ui, lab);
    ui.Gap(8.0f);
    if (!lab.IsOf(session.Doc())) {
      ui.Paragraph(Tr("The document has changed since these trials began."), ui.Ink().accent, Type::kNote);
      ui.Gap(4.0f);
    }
    DrawTable(ui, lab);
    ui.Gap(8.0f);
    if (DrawFold(ui, "lab/targets", Tr("How soon"), "", state.targets)) DrawReached(ui, lab);
    ui.Gap(8.0f);
    if (ui.Button("lab/save", ui.ControlRow(), Tr("Save curves as CSV"), ButtonLook::kOutlined,
                  lab.Finished() > 0))
      session.Lab().SaveCurves();
    ui.Gap(14.0f);
  }
  DrawSettings(ui, lab.settings, state.all_algorithms);
  ui.Gap(10.0f);
  const Document& d = session.Doc();
  ui.Paragraph(Tr("The next run compares how fast each algorithm finds {1} that can make {2} {3} for {4} s. "
                  "Trials use consecutive seeds. Your motion is not changed.",
                  ControllerWords(d.kind, d.senses, d.rules), TrTitle(d.figure.name), TaskWords(d.task.kind),
                  Fixed(static_cast<float>(d.task.duration_steps) * kStep, 1)),
               Type::kNote);
  if (d.pushes.empty()) return;
  ui.Gap(6.0f);
  ui.Paragraph(
      d.pushes.size() == 1
          ? Tr("In every trial the figure gets the push at {1} s. Remove it in the World card to compare "
               "without it.",
               Fixed(static_cast<float>(d.pushes.front().step) * kStep, 2))
          : Tr("In every trial the figure gets the {1} pushes of this document. Remove them in the World "
               "card to compare without them.",
               Grouped(static_cast<long long>(d.pushes.size()))),
      ui.Ink().accent, Type::kNote);
}

}  // namespace gaitsmith::shell
