// SPDX-License-Identifier: MIT
#include "shell/workspace/workspace.h"

#include <algorithm>
#include <utility>

#include "core/document/parts.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

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

int LastClip(const Document& d) { return std::max(0, static_cast<int>(d.timeline.size()) - 1); }

}  // namespace

Document Workspace::WithHash() const {
  Document document = document_;
  document.hash = Previews() ? Simulate(document_).Hash() : player_.Shown().Hash();
  return document;
}

Document Workspace::Played() const {
  Document played = document_;
  if (Previews()) {
    const Clip& clip = played.timeline[static_cast<std::size_t>(selected_clip_)];
    played.controllers[static_cast<std::size_t>(clip.controller)].genes = previewed_;
  }
  return played;
}

bool Workspace::Preview(Genome genes) {
  const Controller* shown = ShownController();
  if (shown == nullptr || shown->genes.size() != genes.size()) return false;
  previewed_ = std::move(genes);
  player_.Load(Played(), false);
  return true;
}

void Workspace::EndPreview() {
  if (!Previews()) return;
  previewed_.clear();
  player_.Load(document_, false);
}

void Workspace::SelectClip(int clip) {
  selected_clip_ = std::clamp(clip, 0, LastClip(document_));
  followers_.settings();
}

const Controller* Workspace::ShownController() const {
  if (document_.timeline.empty()) return nullptr;
  const Clip& clip = document_.timeline[static_cast<std::size_t>(selected_clip_)];
  return &document_.controllers[static_cast<std::size_t>(clip.controller)];
}

void Workspace::Say(std::string sentence) {
  notice_ = std::move(sentence);
  said_ = gesture_;
  host_.Status(notice_);
}

void Workspace::Report(const std::string& sentence) {
  notice_.clear();
  said_ = gesture_;
  host_.Status(sentence);
}

void Workspace::Show(Document document, bool opened) {
  document_ = std::move(document);
  // Each search chooses its own takeover, so the takeover is neither opened nor saved.
  CopyParts(Document{}, Part::kTakeover, document_);
  selected_clip_ = std::min(selected_clip_, LastClip(document_));
  const Controller* shown = ShownController();
  if (opened || shown == nullptr || shown->genes.size() != previewed_.size()) previewed_.clear();
  player_.Load(Played(), opened);
  differs_from_maker_ = document_.hash && *document_.hash != player_.Shown().Hash();
  followers_.motion(opened);
  Redraw();
}

std::optional<Document> Workspace::Edited(const Edit& edit) {
  Document next = document_;
  edit(next);
  // Clears the start if its controller is gone or does not fit the senses.
  if (int& start = next.search.start; start >= 0) {
    const auto index = static_cast<std::size_t>(start);
    const bool fits = index < next.controllers.size() && FitsSearch(next, next.controllers[index]);
    if (!fits) start = -1;
  }
  // Its children would not be the same ones any more.
  if (!next.lineage.rounds.empty() && !SameParts(next, document_, kScene)) next.lineage = {};
  if (const auto valid = Validate(next); !valid) {
    Say(Tr("Not possible: {1}.", TrError(valid.error())));
    return std::nullopt;
  }
  return next;
}

bool Workspace::Refuses(const Arrangement& locks, const Document& next) {
  const auto part = LockedDifference(locks, document_, next);
  if (!part) return false;
  Say(Tr("Not possible: {1}.", LockedWords(*part)));
  return true;
}

bool Workspace::Change(const Edit& edit) {
  auto next = Edited(edit);
  if (!next || Refuses(layout_, *next)) return false;
  notice_.clear();
  const Parts changed = DifferingParts(*next, document_);
  if (changed.Empty()) return true;
  Report("");
  Remember();
  next->hash.reset();
  Show(std::move(*next), false);
  followers_.edited(changed);
  return true;
}

bool Workspace::Set(const Edit& edit) {
  auto next = Edited(edit);
  if (!next || Refuses(layout_, *next)) return false;
  const Parts changed = DifferingParts(*next, document_);
  if (changed.Empty()) return true;
  Report("");
  Remember();
  if (next->task.shown != document_.task.shown) player_.MeasureAgainst(next->task.shown);
  document_ = std::move(*next);
  followers_.settings();
  Redraw();
  followers_.edited(changed);
  return true;
}

void Workspace::SetView(const std::function<void(View&)>& edit) {
  auto next = Edited([&](Document& d) { edit(d.view); });
  if (!next) return;
  document_ = std::move(*next);
  Redraw();
}

}  // namespace gaitsmith::shell
