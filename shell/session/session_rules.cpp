// SPDX-License-Identifier: MIT
// A session's controller, changed by hand.
#include "shell/session/session.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr std::string_view kEdited = ", edited";

void MarkEdited(std::string& words) {
  if (words.ends_with(kEdited)) return;
  words = Shortened(words, kMaxNameBytes - kEdited.size()) + std::string(kEdited);
}

}  // namespace

bool Session::ChangeController(const std::function<void(Controller&)>& edit) {
  if (ShownController() == nullptr) return false;
  const ControllerKind kind = ShownController()->kind;
  const SenseKind senses = ShownController()->senses.kind;
  if (Searching() && searched_clip_ == selected_clip_) AbandonSearch();
  // The end of a search shows its best, which may be of another kind than what the hand is at.
  if (ShownController()->kind != kind || ShownController()->senses.kind != senses) return false;
  return Change([&](Document& d) {
    const Clip& clip = d.timeline[static_cast<std::size_t>(selected_clip_)];
    Controller& controller = d.controllers[static_cast<std::size_t>(clip.controller)];
    const Controller before = controller;
    edit(controller);
    if (controller.rules == before.rules && controller.genes == before.genes) return;
    if (d.kind == controller.kind && d.rules == before.rules) d.rules = controller.rules;
    // A title that a search wrote names the seed that finds this controller, which it no longer does.
    const auto seed = before.name.rfind(", seed ");
    if (seed != std::string::npos && d.title.ends_with(before.name.substr(seed))) MarkEdited(d.title);
    MarkEdited(controller.name);
  });
}

}  // namespace gaitsmith::shell
