// SPDX-License-Identifier: MIT
#include "shell/panels/search/found_list.h"

#include <array>
#include <string>

#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

bool IsWanted(const FoundMotion& found, FoundListState::Filter filter, const Document& open) {
  switch (filter) {
    case FoundListState::Filter::kAll:
      return true;
    case FoundListState::Filter::kThisFigure:
      return SameTree(found.document.figure, open.figure);
    case FoundListState::Filter::kKept:
      return found.kept;
  }
  return true;
}

/// The last removed motion, with a button that restores it.
void DrawRemoved(Ui& ui, FoundMotions& found) {
  const FoundMotions::Entry* removed = found.Removed();
  if (removed == nullptr) return;
  const ImRect row = ui.ControlRow();
  const ImRect button({row.Max.x - 96.0f, row.Min.y}, row.Max);
  ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {row.Min.x, row.GetCenter().y}, row.GetWidth() - 104.0f,
                          ui.Ink().second_ink, Tr("Deleted: {1}", SceneText(removed->motion)));
  if (ui.Button("found/bring-back", button, Tr("Bring back"))) found.BringBack();
  ui.Gap(6.0f);
}

void DrawChoices(Ui& ui, FoundListState& state) {
  const std::array<std::string, 5> orders = {Tr("Newest first"), Tr("Best score first"), Tr("Highest first"),
                                             Tr("Most turns first"), Tr("Least slip first")};
  const std::array<std::string, 3> filters = {Tr("All"), Tr("Of this figure"), Tr("Saved")};
  int order = static_cast<int>(state.order);
  int filter = static_cast<int>(state.filter);
  if (ui.Combo("found/order", Tr("Order of the results"), orders, order))
    state.order = static_cast<FoundMotions::Order>(order);
  ui.Gap(4.0f);
  if (ui.Combo("found/filter", Tr("Which results"), filters, filter))
    state.filter = static_cast<FoundListState::Filter>(filter);
  ui.Gap(8.0f);
}

void Do(Session& session, CardAction action, const std::string& id) {
  const FoundMotions::Entry* entry = session.Results().Motions().Find(id);
  if (entry == nullptr) return;
  switch (action) {
    case CardAction::kNothing:
      return;
    case CardAction::kShow:
      session.ShowFound(id);
      return;
    case CardAction::kInsert:
      session.Timeline().InsertFound(id);
      return;
    case CardAction::kKeep:
      session.Results().Motions().Keep(id, !entry->motion.kept);
      return;
    case CardAction::kRename:
      session.Results().AskName(id);
      return;
    case CardAction::kAgain:
      session.Queue().Repeat(id);
      return;
    case CardAction::kMoreLike:
    case CardAction::kLessLike:
      session.Results().LearnFrom(id, action == CardAction::kMoreLike);
      return;
    case CardAction::kBrain:
      session.TryBrain(id);
      return;
    case CardAction::kDelete:
      session.Results().Motions().Remove(id);
      return;
  }
}

}  // namespace

void DrawFound(Ui& ui, Session& session, FoundListState& state) {
  state.strips.BeginFrame();
  DrawRemoved(ui, session.Results().Motions());
  if (session.Results().Motions().Empty()) {
    ui.Paragraph(Tr("Motions that searches find appear here, and motions that you save."), Type::kNote);
    return;
  }
  DrawChoices(ui, state);
  // Applied after the loop, since it changes the list.
  CardAction action = CardAction::kNothing;
  std::string id;
  bool any = false;
  for (const FoundMotions::Entry* entry : session.Results().Motions().Sorted(state.order)) {
    if (!IsWanted(entry->motion, state.filter, session.Doc())) continue;
    any = true;
    const CardAction here = DrawFoundCard(ui, session, *entry, state.strips);
    if (here == CardAction::kNothing) continue;
    action = here;
    id = entry->id;
  }
  if (!any) ui.Paragraph(Tr("No result matches this choice."), Type::kNote);
  ui.Paragraph(Tr("Click one to view it. Drag it to the timeline to chain it. Keeps 100 results. The oldest "
                  "unsaved ones are removed first."),
               Type::kNote);
  Do(session, action, id);
}

}  // namespace gaitsmith::shell
