// SPDX-License-Identifier: MIT
#include "shell/words/search_words.h"

#include "shell/words/algorithm_words.h"
#include "shell/words/control_modes.h"
#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/style_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

std::string SearchTitle(const Document& d) {
  std::string title =
      (d.figure.name.empty() ? Tr("A figure") : TrTitle(d.figure.name)) + " · " + TaskWords(d.task.kind);
  for (std::size_t i = 0; i < kStyleTerms; ++i) {
    const float weight = d.task.weights[i];
    if (weight != 0.0f && CanMeasure(d.task, static_cast<StyleTerm>(i)))
      title += ", " + Tr(weight > 0.0f ? "more {1}" : "less {1}", Tr(TermTexts()[i].word));
  }
  return title;
}

std::string SearchName(const Document& d) {
  return (d.figure.name.empty() ? "A figure" : d.figure.name) + " · " + TaskName(d.task.kind);
}

std::string SearchLine(const Document& d) {
  std::string line = Tr("{1} · seed {2} · {3} evaluations", AlgorithmName(d.search.algorithm),
                        std::to_string(d.search.seed), Grouped(d.search.evaluations));
  if (d.search.body == BodyFreedom::kNone) return line;
  return line + " · " +
         Tr(d.search.body == BodyFreedom::kLittle ? "body may change a little" : "body may change a lot");
}

std::string ControlModeWords(ControllerKind kind, const SenseSpec& senses) {
  return Tr(ControlModeOf(kind, senses.kind).short_words,
            Fixed(static_cast<float>(senses.period_steps) * kStep, 2));
}

std::string WaitingWords(std::size_t count) {
  return Tr(count == 1 ? "{1} search waits" : "{1} searches wait", Grouped(static_cast<long long>(count)));
}

std::string FoundTitle(const std::string& figure, const Document& d) {
  const std::string how = std::string(" · ") + TaskName(d.task.kind) + ", " +
                          ControllerName(d.kind, d.senses, d.rules) + ", seed " +
                          std::to_string(d.search.seed);
  return Shortened(figure, kMaxNameBytes - how.size()) + how;
}

}  // namespace gaitsmith::shell
