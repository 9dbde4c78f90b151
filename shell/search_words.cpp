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

std::string FoundTitle(const std::string& figure, const Document& d) {
  const std::string how = " · " + TaskWords(d.task.kind) + ", " + ControllerWords(d.kind, d.senses, d.rules) +
                          ", seed " + std::to_string(d.search.seed);
  return Shortened(figure, kMaxNameBytes - how.size()) + how;
}

}  // namespace gaitsmith::shell
