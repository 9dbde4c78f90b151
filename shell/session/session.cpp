// SPDX-License-Identifier: MIT
// Opening and changing. Undoing is in session_history.cpp, the search's part in session_search.cpp.
#include "shell/session/session.h"

#include <algorithm>
#include <cmath>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/link.h"
#include "core/numeric/scalar_math.h"
#include "shell/embedded/embedded.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

// The same figure may come with several examples, so names decide.
std::vector<Figure> ShippedFigures() {
  std::vector<Figure> figures;
  const auto add = [&](const Figure& figure) {
    const bool known = std::ranges::any_of(figures, [&](const Figure& f) { return f.name == figure.name; });
    if (!known) figures.push_back(figure);
  };
  for (const Example& example : ExampleFigures()) {
    if (const auto figure = DecodeFigureJson(example.json)) add(*figure);
  }
  for (const Example& example : ExampleDocuments()) {
    if (const auto document = DecodeJson(example.json)) add(document->figure);
  }
  add(StandardFigure());
  return figures;
}

std::vector<Document> ShippedProblems() {
  std::vector<Document> problems;
  for (const Example& example : ExampleProblems()) {
    if (auto document = DecodeJson(example.json)) problems.push_back(std::move(*document));
  }
  return problems;
}

// Takes away what was made for another figure.
void Strip(Document& document) {
  document.controllers.clear();
  document.timeline.clear();
  document.pushes.clear();
  document.duration_steps = document.task.duration_steps;
}

std::string LockedWords(LockedPart part) {
  switch (part) {
    case LockedPart::kFigure:
      return Tr("the figure is locked here");
    case LockedPart::kController:
      return Tr("the controller is locked here");
    case LockedPart::kStyle:
      return Tr("the style is locked here");
    case LockedPart::kSearch:
      return Tr("the search's settings are locked here");
    case LockedPart::kTimeline:
      return Tr("the timeline is locked here");
    case LockedPart::kWorld:
      return Tr("the world is locked here");
  }
  return "";
}

bool Same(const Document& a, const Document& b) { return EncodeBinary(a) == EncodeBinary(b); }

double PeriodS(const SenseSpec& senses) {
  return static_cast<double>(static_cast<float>(senses.period_steps) * kStep);
}

// For its number of rules or nodes, and the timer's period.
const char* ControllerPattern(ControllerKind kind, const SenseSpec& senses, int rules) {
  const bool one = rules == 1;
  if (kind == ControllerKind::kNetwork) {
    return one ? TrLater("a network of {1} hidden node") : TrLater("a network of {1} hidden nodes");
  }
  if (senses.kind == SenseKind::kPhysical)
    return one ? TrLater("{1} rule with physical senses") : TrLater("{1} rules with physical senses");
  return one ? TrLater("{1} rule with timer {2} s") : TrLater("{1} rules with timer {2} s");
}

}  // namespace

Figure StandardFigure() {
  Figure figure{.name = "Mr. Star-Man", .rods = {}};
  for (int i = 0; i < 5; ++i) {
    Rod rod;
    if (i > 0) {
      rod.parent = 0;
      rod.parent_end = RodEnd::kStart;
    }
    rod.rest_rad = i == 0 ? static_cast<float>(kPi / 2) : static_cast<float>(0.4 * kPi * i);
    if (rod.rest_rad > static_cast<float>(kPi)) rod.rest_rad -= static_cast<float>(2 * kPi);
    figure.rods.push_back(rod);
  }
  return figure;
}

Decider DeciderOf(const Document& d) {
  if (d.kind == ControllerKind::kNetwork) return Decider::kNetwork;
  return d.senses.kind == SenseKind::kTimer ? Decider::kTimer : Decider::kSenses;
}

void Decide(Document& d, Decider decider) {
  d.kind = decider == Decider::kNetwork ? ControllerKind::kNetwork : ControllerKind::kRules;
  d.senses.kind = decider == Decider::kTimer ? SenseKind::kTimer : SenseKind::kPhysical;
}

std::string ControllerWords(ControllerKind kind, const SenseSpec& senses, int rules) {
  return Tr(ControllerPattern(kind, senses, rules), rules, Fixed(PeriodS(senses), 2));
}

std::string ControllerName(ControllerKind kind, const SenseSpec& senses, int rules) {
  return Fill(ControllerPattern(kind, senses, rules), {rules, PlainFixed(PeriodS(senses), 2)});
}

std::string TaskWords(TaskKind kind) { return Tr(TaskName(kind)); }

const char* TaskName(TaskKind kind) {
  switch (kind) {
    case TaskKind::kTravel:
      return TrLater("travel");
    case TaskKind::kTravelRight:
      return TrLater("travel to the right");
    case TaskKind::kTravelLeft:
      return TrLater("travel to the left");
    case TaskKind::kJump:
      return TrLater("jump");
  }
  return "";
}

Session::Session(Host& host)
    : workers(host.MaxWorkers()), host_(host), figures_(ShippedFigures()), problems_(ShippedProblems()) {
  found.on_change = [this](const std::string& id, const std::string& text) { host_.StoreFound(id, text); };
  Document document;
  document.title = "Mr. Star-Man";
  document.figure = StandardFigure();
  for (const Example& example : ExampleDocuments()) {
    if (example.name != "star-man-shuffle") continue;
    if (auto shipped = DecodeJson(example.json)) document = std::move(*shipped);
  }
  Show(std::move(document), true);
}

Result<void> Session::Open(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && text[first] == '{';
  auto document = json ? DecodeJson(text) : DecodeLink(text);
  if (!document) return std::unexpected(document.error());
  AbandonSearch();
  BeginGesture();
  Remember();
  BeginGesture();
  ForgetProgress();
  selected_clip_ = 0;
  player.speed = static_cast<double>(document->view.speed);
  Show(std::move(*document), true);
  notice.clear();
  host_.Status(differs_from_maker_
                   ? Tr("This motion differs from the one its maker saw: hash {1} here, {2} there.",
                        HashText(player.Shown().Hash()), HashText(*document_.hash))
                   : Tr("Opened {1}.", TrTitle(document_.title)));
  return {};
}

Document Session::WithHash() const {
  Document document = document_;
  document.hash = player.Shown().Hash();
  return document;
}

void Session::Say(std::string sentence) {
  notice = std::move(sentence);
  host_.Status(notice);
}

void Session::Show(Document document, bool start_over) {
  document_ = std::move(document);
  // Where a search takes over is chosen anew with each one, and so it is nothing to open or to keep.
  document_.search.in_place_of = -1;
  document_.search.handovers.clear();
  selected_clip_ =
      std::clamp(selected_clip_, 0, std::max(0, static_cast<int>(document_.timeline.size()) - 1));
  player.Load(document_, start_over);
  // What was done to the world of another figure has no meaning for this one.
  if (start_over || !SameTree(calm_.figure, document_.figure)) calm_ = document_;
  ghost_.Load(GhostDocuments());
  differs_from_maker_ = document_.hash && *document_.hash != player.Shown().Hash();
  CheckTransitions();
  host_.DocumentChanged(document_.title);
}

std::optional<Document> Session::Edited(const Edit& edit) {
  Document next = document_;
  edit(next);
  // A start that has gone, or does not fit other senses, is no start any more.
  if (int& start = next.search.start; start >= 0) {
    const auto index = static_cast<std::size_t>(start);
    const bool fits = index < next.controllers.size() && SuitsSearch(next, next.controllers[index]);
    if (!fits) start = -1;
  }
  if (const auto valid = Validate(next); !valid) {
    Say(Tr("Not possible: {1}.", TrError(valid.error())));
    return std::nullopt;
  }
  return next;
}

bool Session::Refuses(const Arrangement& locks, const Document& next) {
  const auto part = LockedDifference(locks, document_, next);
  if (!part) return false;
  Say(Tr("Not possible: {1}.", LockedWords(*part)));
  return true;
}

bool Session::Change(const Edit& edit) {
  auto next = Edited(edit);
  if (!next || Refuses(arrangement, *next)) return false;
  notice.clear();
  if (Same(*next, document_)) return true;
  Remember();
  next->hash.reset();
  Show(std::move(*next), false);
  return true;
}

bool Session::Set(const Edit& edit) {
  auto next = Edited(edit);
  if (!next || Refuses(arrangement, *next)) return false;
  if (Same(*next, document_)) return true;
  Remember();
  document_ = std::move(*next);
  CheckTransitions();
  host_.DocumentChanged(document_.title);
  return true;
}

void Session::SetView(const std::function<void(View&)>& edit) {
  auto next = Edited([&](Document& d) { edit(d.view); });
  if (!next) return;
  document_ = std::move(*next);
  host_.DocumentChanged(document_.title);
}

bool Session::ReplaceFigure(const Figure& figure) {
  const bool fits = SameTree(figure, document_.figure);
  const Edit edit = [&](Document& d) {
    d.figure = figure;
    if (fits) return;
    Strip(d);
    d.title = figure.name;
  };
  const auto next = Edited(edit);
  if (!next || Refuses(arrangement, *next)) return false;
  if (Same(*next, document_)) return true;
  AbandonSearch();  // it looks for motions of the figure as it was
  const bool loses = !fits && !document_.controllers.empty();
  const bool changed = Change(edit);
  if (changed && loses) {
    ForgetProgress();
    Say(Tr("The controllers were made for the figure as it was, so they are gone. Undo brings them back."));
  }
  return changed;
}

void Session::ChooseFigure(int index) {
  const Figure& figure = figures_[static_cast<std::size_t>(index)];
  // A shipped motion of this figure is better than one that stands still.
  for (const Example& example : ExampleDocuments()) {
    auto document = DecodeJson(example.json);
    if (!document || document->figure.name != figure.name || document->controllers.empty()) continue;
    if (!Replace(std::move(*document))) return;
    Say(Tr("{1} with a shipped motion. Undo brings the last figure back.", TrTitle(figure.name)));
    return;
  }
  const Edit edit = [&](Document& d) {
    d.figure = figure;
    d.title = figure.name;
    Strip(d);
  };
  if (const auto next = Edited(edit); !next || Refuses(arrangement, *next)) return;
  AbandonSearch();
  if (!Change(edit)) return;
  ForgetProgress();
  player.Seek(0.0);
  Say(Tr("{1} cannot move yet: press Synthesize. Undo brings the last figure back.", TrTitle(figure.name)));
}

bool Session::Replace(Document document, bool same_problem) {
  Arrangement locks = arrangement;
  for (const LockedPart part : {LockedPart::kController, LockedPart::kSearch, LockedPart::kTimeline})
    locks.locked[static_cast<std::size_t>(part)] &= !same_problem;
  if (Refuses(locks, document)) return false;
  AbandonSearch();
  Remember();
  document.view = document_.view;
  selected_clip_ = 0;
  ForgetProgress();
  Show(std::move(document), true);
  return true;
}

void Session::ChooseProblem(int index) {
  if (!Replace(problems_[static_cast<std::size_t>(index)])) return;
  Say(Tr("{1}: press Synthesize. Undo brings back what was here.", TrTitle(document_.title)));
}

void Session::ChooseExample(const Document& example) {
  if (!Replace(example)) return;
  Say(Tr("{1}. Undo brings back what was here.", TrTitle(document_.title)));
}

void Session::SelectClip(int clip) {
  selected_clip_ = std::clamp(clip, 0, std::max(0, static_cast<int>(document_.timeline.size()) - 1));
  CheckTransitions();
}

const Controller* Session::ShownController() const {
  if (document_.timeline.empty()) return nullptr;
  const Clip& clip = document_.timeline[static_cast<std::size_t>(selected_clip_)];
  return &document_.controllers[static_cast<std::size_t>(clip.controller)];
}

void Session::SetDuration(int steps) {
  Change([&](Document& d) {
    d.task.duration_steps = steps;
    if (d.timeline.size() < 2) d.duration_steps = steps;
  });
}

}  // namespace gaitsmith::shell
