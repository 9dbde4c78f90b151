// SPDX-License-Identifier: MIT
// Replacing one document by another. Undo is in session_history.cpp.
#include "shell/session/session.h"

#include <utility>

#include "core/document/json.h"
#include "core/document/link.h"
#include "core/document/parts.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/workspace/panels.h"

namespace gaitsmith::shell {
namespace {

// Removes what was made for another figure.
void Strip(Document& document) {
  document.controllers.clear();
  document.timeline.clear();
  document.pushes.clear();
  document.duration_steps = document.task.duration_steps;
}

}  // namespace

Session::Session(Host& host)
    : workspace_(host),
      results_(workspace_),
      lab_(workspace_, search_),
      search_(workspace_, lab_.Trials(), results_),
      queue_(workspace_, lab_.Trials(), search_, results_),
      world_(workspace_),
      comparison_(workspace_, world_, search_, queue_, results_),
      timeline_(workspace_, search_, comparison_, results_) {
  workspace_.SetFollowers({.motion =
                               [this](bool opened) {
                                 world_.Follow(opened);
                                 comparison_.Follow();
                                 timeline_.Transitions().Follow();
                               },
                           .settings = [this] { timeline_.Transitions().Follow(); }});
  search_.SetFollowers({.found = [this](const std::string& id) { comparison_.ShowIfRequested(id); },
                        .ended = [this] { queue_.RunNext(); }});
  workspace_.Show(shipped_.FirstMotion(), true);
}

Result<void> Session::Open(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && text[first] == '{';
  auto document = json ? DecodeJson(text) : DecodeLink(text);
  if (!document) return std::unexpected(document.error());
  search_.Abandon();
  BeginGesture();
  workspace_.Remember();
  BeginGesture();
  search_.ForgetProgress();
  workspace_.SelectClip(0);
  Player().speed = static_cast<double>(document->view.speed);
  workspace_.Show(std::move(*document), true);
  workspace_.Report(DiffersFromMaker()
                        ? Tr("This motion differs from the one its maker saw: hash {1} here, {2} there.",
                             HashText(Player().Shown().Hash()), HashText(*Doc().hash))
                        : Tr("Opened {1}.", TrTitle(Doc().title)));
  return {};
}

bool Session::Replace(Document document, bool same_problem) {
  Arrangement locks = Layout();
  for (const LockedPart part : {LockedPart::kController, LockedPart::kSearch, LockedPart::kTimeline})
    locks.locked[static_cast<std::size_t>(part)] &= !same_problem;
  if (workspace_.Refuses(locks, document)) return false;
  search_.Abandon();
  workspace_.Remember();
  CopyParts(Doc(), Part::kView, document);
  workspace_.SelectClip(0);
  search_.ForgetProgress();
  workspace_.Show(std::move(document), true);
  return true;
}

void Session::New() {
  if (!Replace(shipped_.FirstProblem())) return;
  SetView([](View& view) { view.panel = static_cast<int>(Panel::kSearch); });
  workspace_.Say(
      Tr("A new document. {1} cannot move yet: press Synthesize. Undo restores the previous version.",
         TrTitle(Doc().figure.name)));
}

bool Session::ReplaceFigure(const Figure& figure) {
  const bool fits = SameTree(figure, Doc().figure);
  const Edit edit = [&](Document& d) {
    d.figure = figure;
    if (fits) return;
    Strip(d);
    d.title = figure.name;
  };
  const auto next = workspace_.Edited(edit);
  if (!next || workspace_.Refuses(Layout(), *next)) return false;
  if (DifferingParts(*next, Doc()).Empty()) return true;
  search_.Abandon();  // the search is for the figure before the change
  const bool loses = !fits && !Doc().controllers.empty();
  const bool changed = Change(edit);
  if (changed && loses) {
    search_.ForgetProgress();
    workspace_.Say(
        Tr("The controllers were made for the figure as it was, so they are gone. Undo brings them back."));
  }
  return changed;
}

void Session::ChooseFigure(int index) {
  const Figure& figure = shipped_.Figures()[static_cast<std::size_t>(index)];
  // Prefer a shipped motion of this figure to a figure that stands still.
  if (auto document = shipped_.MotionOf(figure)) {
    if (!Replace(std::move(*document))) return;
    workspace_.Say(Tr("{1} with a shipped motion. Undo brings the last figure back.", TrTitle(figure.name)));
    return;
  }
  const Edit edit = [&](Document& d) {
    d.figure = figure;
    d.title = figure.name;
    Strip(d);
    BeginWithQuickSearch(d.search);
  };
  if (const auto next = workspace_.Edited(edit); !next || workspace_.Refuses(Layout(), *next)) return;
  search_.Abandon();
  if (!Change(edit)) return;
  search_.ForgetProgress();
  Player().Seek(0.0);
  workspace_.Say(
      Tr("{1} cannot move yet: press Synthesize. Undo brings the last figure back.", TrTitle(figure.name)));
}

void Session::ChooseProblem(int index) {
  if (!Replace(shipped_.Problems()[static_cast<std::size_t>(index)])) return;
  workspace_.Say(Tr("{1}: press Synthesize. Undo restores the previous version.", TrTitle(Doc().title)));
}

void Session::ChooseExample(const Document& example) {
  if (!Replace(example)) return;
  workspace_.Say(Tr("{1}. Undo restores the previous version.", TrTitle(Doc().title)));
}

bool Session::ShowFound(const std::string& id) {
  const FoundMotions::Entry* entry = results_.Motions().Find(id);
  if (entry == nullptr) return false;
  Document document = entry->motion.document;
  if (const std::string& name = entry->motion.name; !name.empty()) {
    document.title = name;
    if (document.timeline.size() == 1)
      document.controllers[static_cast<std::size_t>(document.timeline[0].controller)].name = name;
  }
  const bool moves = entry->motion.Moves();
  if (!Replace(document, true)) return true;  // Replace explains the refusal
  if (DiffersFromMaker()) return true;        // the stage reports it
  workspace_.Say(Tr(moves ? "{1}. Undo restores the previous version."
                          : "{1}: this search failed. Undo restores the previous version.",
                    TrTitle(Doc().title)));
  return true;
}

void Session::ShowElite(Document motion) {
  BeginGesture();
  if (!Replace(std::move(motion), true)) return;
  workspace_.Say(
      Tr("{1}. “Save to results” keeps it. Undo restores the previous version.", TrTitle(Doc().title)));
}

void Session::Synthesize() {
  if (!lab_.Running() && search_.WouldRepeat() && !Layout().Locks(LockedPart::kSearch)) {
    std::vector<Document> others = {Doc()};
    for (const FoundMotions::Entry* entry : results_.Motions().Sorted(FoundMotions::Order::kNewest))
      others.push_back(entry->motion.document);
    for (const std::uint32_t seed : FreeSeeds(Doc(), others, 1))
      Set([seed](Document& d) { d.search.seed = seed; });
  }
  search_.Synthesize();
}

void Session::TryStyle() {
  if (search_.TryStyle()) comparison_.Choose(Ghost::Kind::kEarlier);
}

void Session::Stop() {
  lab_.Stop();
  if (!search_.Running()) return;
  search_.Stop();
  if (const std::size_t count = queue_.List().Waiting().size(); count > 0)
    workspace_.Say(Tr("Stopped. {1} until you press Run queue.", WaitingWords(count)));
}

void Session::OnSearchProgress(SearchProgress progress) {
  if (lab_.Running()) return lab_.OnProgress(progress);
  search_.OnProgress(std::move(progress));
}

}  // namespace gaitsmith::shell
