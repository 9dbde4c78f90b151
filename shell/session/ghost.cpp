// SPDX-License-Identifier: MIT
#include "shell/session/ghost.h"

#include "shell/words/language.h"
#include "shell/words/search_words.h"

namespace gaitsmith::shell {

void Ghost::SetSource(Kind kind, int controller, const Documents& documents) {
  kind_ = kind;
  controller_ = controller;
  Load(documents);
}

void Ghost::SetSource(const std::string& id, const Document& found, const Documents& documents) {
  kind_ = Kind::kFound;
  found_id_ = id;
  found_ = found;
  Load(documents);
}

void Ghost::SetPlanned(const Document& planned, const Documents& documents) {
  kind_ = Kind::kPlanned;
  planned_ = planned;
  Load(documents);
}

bool Ghost::Fits(const Documents& documents) const {
  const Figure& figure = documents.shown.figure;
  switch (kind_) {
    case Kind::kNone:
      return false;
    case Kind::kEarlier:
      return SameTree(documents.earlier.figure, figure);
    case Kind::kAsOpened:
      return true;
    case Kind::kController:
      return controller_ >= 0 && controller_ < static_cast<int>(documents.shown.controllers.size());
    case Kind::kFound:
      return SameTree(found_.figure, figure);
    case Kind::kPlanned:
      return SameTree(planned_.figure, figure);
  }
  return false;
}

void Ghost::Load(const Documents& documents) {
  if (!Fits(documents)) kind_ = Kind::kNone;
  if (kind_ == Kind::kNone) return;
  if (kind_ == Kind::kPlanned) {
    planned_.duration_steps = documents.shown.duration_steps;
    return player_.LoadPlanned(planned_);
  }
  Document document = kind_ == Kind::kEarlier ? documents.earlier : documents.shown;
  if (kind_ == Kind::kFound) {
    document.figure = found_.figure;
    document.controllers = found_.controllers;
    document.timeline = found_.timeline;
  } else if (kind_ == Kind::kController) {
    document.timeline = {{.controller = controller_, .start_step = 0}};
  }
  const Document& world = kind_ == Kind::kAsOpened ? documents.as_opened : documents.shown;
  document.model = world.model;
  SetFigure(Figure(document.figure), document);  // which may be of another kind than the world's
  document.environment = world.environment;
  document.pushes = world.pushes;
  player_.Load(document, false);
}

std::optional<int> Ghost::ControllerIndex() const {
  return kind_ == Kind::kController ? std::optional(controller_) : std::nullopt;
}

std::string Ghost::Words(const Document& shown) const {
  switch (kind_) {
    case Kind::kNone:
      return "";
    case Kind::kEarlier:
      return Tr("before the last search");
    case Kind::kAsOpened:
      return Tr("without your changes");
    case Kind::kPlanned:
      return Tr("as planned");
    case Kind::kController:
    case Kind::kFound:
      break;
  }
  const Controller& controller = kind_ == Kind::kFound
                                     ? found_.controllers.back()
                                     : shown.controllers[static_cast<std::size_t>(controller_)];
  return ControlModeWords(controller.kind, controller.senses);
}

void Ghost::Seek(double time_s) {
  if (kind_ != Kind::kNone) player_.Seek(time_s);
}

}  // namespace gaitsmith::shell
