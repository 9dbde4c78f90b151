// SPDX-License-Identifier: MIT
#include "shell/panels/search/search_settings_form.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "shell/widgets/fold.h"
#include "shell/words/algorithm_words.h"
#include "shell/words/language.h"
#include "shell/words/search_parameters.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

void Change(Session& session, const std::function<void(SearchSettings&)>& edit) {
  session.Set([&](Document& d) {
    edit(d.search);
    Fit(d.search);
  });
}

void Draw(Ui& ui, Session& session, const SearchParameter& parameter, const WholeParameter& whole) {
  SearchSettings search = session.Doc().search;
  int value = whole.field(search);
  if (ui.Number(parameter.id, Tr(parameter.label), value, whole.low, whole.high, whole.step))
    Change(session, [&](SearchSettings& s) { whole.field(s) = value; });
}

void Draw(Ui& ui, Session& session, const SearchParameter& parameter, const RealParameter& real) {
  SearchSettings search = session.Doc().search;
  double value = static_cast<double>(real.field(search));
  const SliderRange range{
      .low = real.low, .high = real.high, .step = real.step, .logarithmic = real.logarithmic};
  const int decimals = real.step < 0.01 && value < 0.1 ? 3 : real.step < 0.1 ? 2 : 1;
  if (ui.Slider(parameter.id, Tr(parameter.label), value, range, Fixed(value, decimals)))
    Change(session, [&](SearchSettings& s) { real.field(s) = static_cast<float>(value); });
}

void Draw(Ui& ui, Session& session, const SearchParameter& parameter, const ChoiceParameter& choice) {
  int value = choice.get(session.Doc().search);
  std::vector<std::string> options;
  for (const char* option : choice.options) options.emplace_back(Tr(option));
  if (ui.Combo(parameter.id, Tr(parameter.label), options, value))
    Change(session, [&](SearchSettings& s) { choice.set(s, value); });
}

void DrawAll(Ui& ui, Session& session, const std::vector<const SearchParameter*>& parameters) {
  for (const SearchParameter* parameter : parameters) {
    const bool body_fixed = session.Layout().Locks(LockedPart::kFigure) || session.Doc().figure.HasSprings();
    if (parameter->id == "search/body" && body_fixed) continue;
    if (parameter->matters != nullptr && !parameter->matters(session.Doc().search)) continue;
    std::visit([&](const auto& kind) { Draw(ui, session, *parameter, kind); }, parameter->kind);
    ui.Paragraph(Tr(parameter->line), Type::kNote);
    ui.Gap(7.0f);
  }
}

void DrawStart(Ui& ui, Session& session) {
  const Document& d = session.Doc();
  const Controller* shown = session.Timeline().ShownController();
  if (shown == nullptr || !FitsSearch(d, *shown)) return;
  bool on = d.search.start >= 0;
  if (ui.Switch("search/start-here", Tr("Start from the shown motion"), on)) {
    session.Set([&](Document& next) {
      const auto clip = static_cast<std::size_t>(session.Timeline().Selected());
      next.search.start = on && clip < next.timeline.size() ? next.timeline[clip].controller : -1;
    });
  }
  ui.Paragraph(Tr("Refines the shown motion instead of starting at random."), Type::kNote);
  ui.Gap(7.0f);
}

}  // namespace

void DrawSearchSettings(Ui& ui, Session& session, SearchFormState& state) {
  const SearchSettings& search = session.Doc().search;
  int algorithm = static_cast<int>(search.algorithm);
  const bool further = algorithm >= kListedAlgorithms;
  bool all = state.all_algorithms || further;
  std::vector<std::string> algorithms;
  for (const AlgorithmWords& words : AlgorithmTexts()) {
    if (all || std::cmp_less(algorithms.size(), kListedAlgorithms)) algorithms.emplace_back(Tr(words.title));
  }
  if (ui.Combo("search/algorithm", Tr("Algorithm"), algorithms, algorithm))
    Change(session, [&](SearchSettings& s) { s.algorithm = static_cast<Algorithm>(algorithm); });
  ui.Paragraph(Tr(WordsOf(search.algorithm).line), Type::kNote);
  ui.Gap(7.0f);
  if (!further) {
    if (ui.Switch("search/all-algorithms", Tr("More algorithms"), all)) state.all_algorithms = all;
    ui.Paragraph(Tr("For experts: the list above then has further ones."), Type::kNote);
    ui.Gap(7.0f);
  }
  double budget = search.evaluations;
  if (ui.Slider("search/budget", Tr("Budget"), budget,
                {.low = 1000.0, .high = 1e6, .step = 1000.0, .logarithmic = true},
                Tr("{1} evaluations", Grouped(search.evaluations)))) {
    Change(session, [&](SearchSettings& s) { s.evaluations = static_cast<int>(budget); });
  }
  ui.Paragraph(Tr("How many motions to try before stopping."), Type::kNote);
  ui.Gap(7.0f);
  int seed = static_cast<int>(std::min<std::uint32_t>(search.seed, 999'999'999u));
  if (ui.Number("search/seed", Tr("Seed"), seed, 0, 999'999'999))
    Change(session, [&](SearchSettings& s) { s.seed = static_cast<std::uint32_t>(seed); });
  ui.Paragraph(Tr("The same seed finds the same motion on every machine."), Type::kNote);
  ui.Gap(7.0f);
  if (RefinesOne(search.algorithm)) DrawStart(ui, session);
  DrawAll(ui, session, ParametersOf(search.algorithm));
  const int most = std::max(1, session.Search().MaxWorkers());
  int workers = session.Search().Workers();
  if (ui.Number("search/workers", Tr("Workers"), workers, 1, most)) session.Search().SetWorkers(workers);
  ui.Paragraph(Tr("More workers finish sooner. The result stays the same."), Type::kNote);
  ui.Gap(4.0f);
  if (DrawFold(ui, "search/variation", Tr("Random variation"), "", state.variation)) {
    ui.Gap(4.0f);
    DrawAll(ui, session, VariationOf(search.algorithm));
  }
}

}  // namespace gaitsmith::shell
