// SPDX-License-Identifier: MIT
// A session's past and future: New, Undo and Redo. Every one of them can itself be taken back.
#include <utility>

#include "core/document/binary.h"
#include "core/document/parts.h"
#include "shell/session/session.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr const char* kFigureWords = TrLater("the figure");

// What a step changed, in a few words. The first of these that differs is what a person did; the rest
// follows.
const char* ChangeWords(const Document& a, const Document& b) {
  const Parts changed = DifferingParts(a, b);
  const bool clips = changed.HasAny({Part::kTimeline, Part::kDuration});
  if (changed.HasAny(Part::kFigure)) return kFigureWords;
  if (a.controllers.size() == b.controllers.size() && clips) return TrLater("the timeline");
  if (changed.HasAny({Part::kControllers, Part::kTimeline})) return TrLater("the motion");
  if (changed.HasAny(kTask)) return TrLater("the task and its weights");
  if (changed.HasAny({Part::kEnvironment, Part::kStart, Part::kPushes})) return TrLater("the surroundings");
  if (changed.HasAny(Part::kSought)) return TrLater("the senses of the next search");
  return TrLater("settings of the next search");
}

}  // namespace

void Session::Remember(int occasion) { history_.Keep(document_, occasion); }

bool Session::FoundNothingYet() const {
  if (!Searching() || queued_ || !searched_ || !improvement_.empty()) return false;
  Document begun = earlier_;
  begun.view = document_.view;
  return EncodeBinary(begun) == EncodeBinary(document_);
}

void Session::Undo() {
  // A search that has found nothing yet is all there is to take back.
  const bool only_search = FoundNothingYet();
  AbandonSearch();
  if (only_search) return Say(Tr("The search is stopped; the motion is as it was."));
  if (const auto before = history_.Back(document_)) {
    Return(*before, TrLater("Undone: {1}."));
  } else {
    host_.Status(Tr("There is nothing to undo."));
  }
}

void Session::Redo() {
  if (CanRedo())
    AbandonSearch();  // what it found last is a step of its own, and then nothing is left to redo
  if (const auto after = history_.Forward(document_)) {
    Return(*after, TrLater("Done again: {1}."));
  } else {
    host_.Status(Tr("There is nothing to redo."));
  }
}

void Session::Return(const Document& document, const char* words) {
  const std::string what = ChangeWords(document_, document);
  BeginGesture();
  notice.clear();
  Show(document, what == kFigureWords);
  host_.Status(Tr(words, Tr(what.c_str())));
}

void Session::ForgetPast() {
  history_.Clear();
  host_.DocumentChanged(document_.title);
}

void Session::New() {
  // The first problem's figure and senses are those that the paper's standard figure learns most with.
  Document next;
  next.figure = StandardFigure();
  next.title = next.figure.name;
  for (const Document& problem : problems_) {
    if (problem.title.starts_with(next.figure.name)) next = problem;
  }
  next.hash.reset();
  if (!Replace(std::move(next))) return;
  Say(Tr("A new document. {1} cannot move yet: press Synthesize. Undo brings back what was here.",
         TrTitle(document_.figure.name)));
}

}  // namespace gaitsmith::shell
