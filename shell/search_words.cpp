// SPDX-License-Identifier: MIT
#include "shell/search_words.h"

#include "shell/algorithm_words.h"
#include "shell/session.h"
#include "shell/wording.h"

namespace gaitsmith::shell {

std::string SearchTitle(const Document& d) {
  return (d.figure.name.empty() ? "A figure" : d.figure.name) + " · " + TaskWords(d.task.kind);
}

std::string SearchLine(const Document& d) {
  return WordsOf(d.search.algorithm).name + " · seed " + std::to_string(d.search.seed) + " · " +
         Grouped(d.search.evaluations) + " evaluations";
}

std::string DeciderWords(ControllerKind kind, const SenseSpec& senses) {
  if (kind == ControllerKind::kNetwork) return "network";
  if (senses.kind == SenseKind::kPhysical) return "physical";
  return "timer " + Fixed(static_cast<float>(senses.period_steps) * kStep, 2) + " s";
}

std::string WaitingWords(std::size_t count) {
  return Grouped(static_cast<long long>(count)) + (count == 1 ? " search waits" : " searches wait");
}

std::string FoundTitle(const std::string& figure, const Document& d) {
  const std::string how = " · " + TaskWords(d.task.kind) + ", " + ControllerWords(d.kind, d.senses, d.rules) +
                          ", seed " + std::to_string(d.search.seed);
  return Shortened(figure, kMaxNameBytes - how.size()) + how;
}

}  // namespace gaitsmith::shell
