// SPDX-License-Identifier: MIT
#include "shell/panels/search/queue_list.h"

#include <string>

#include "shell/words/algorithm_words.h"
#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

enum class QueueAction { kNothing, kUp, kRemove };

QueueAction DrawEntry(Ui& ui, const SearchQueue::Entry& entry, std::size_t place) {
  const Document& d = entry.document;
  const std::string id = "queue/" + std::to_string(entry.number);
  const std::string title = SearchTitle(d);
  const std::string with = ControllerWords(d.kind, d.senses, d.rules);
  const float size = ui.Look().ControlHeight();
  const ImRect row = ui.Row(size + 12.0f);
  const ImRect words(row.Min, {row.Max.x - 2.0f * size - 4.0f, row.Max.y});
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav | ImGuiItemFlags_NoTabStop, true);
  const Touch touch = ui.Area(id, words, Grab::kNothing,
                              {.label = std::to_string(place + 1) + ". " + title,
                               .role = "listitem",
                               .value = with + " · " + SearchLine(d)});
  ImGui::PopItemFlag();
  if (touch.visible) {
    const Fonts& letters = ui.Letters();
    const float y = row.GetCenter().y;
    letters.DrawElided(ui.Canvas(), Type::kBody, {words.Min.x, y - 8.0f}, words.GetWidth(), ui.Ink().ink,
                       title);
    letters.DrawElided(
        ui.Canvas(), Type::kNote, {words.Min.x, y + 9.0f}, words.GetWidth(), ui.Ink().second_ink,
        Tr("{1} · seed {2} · {3} · {4}", AlgorithmName(d.search.algorithm), std::to_string(d.search.seed),
           Grouped(d.search.evaluations), ControlModeWords(d.kind, d.senses)));
  }
  const float top = row.GetCenter().y - 0.5f * size;
  const ImRect remove({row.Max.x - size, top}, {row.Max.x, top + size});
  const ImRect up({remove.Min.x - size, top}, {remove.Min.x, top + size});
  QueueAction action = QueueAction::kNothing;
  if (place > 0 && ui.IconButton(id + "/up", up, Icon::kChevronUp, Tr("Move up: {1}", title)))
    action = QueueAction::kUp;
  if (ui.IconButton(id + "/remove", remove, Icon::kClose, Tr("Remove: {1}", title)))
    action = QueueAction::kRemove;
  return action;
}

}  // namespace

void DrawQueue(Ui& ui, Session& session) {
  SearchQueue& queue = session.Queue().List();
  const std::size_t count = queue.Waiting().size();
  const bool busy = session.Search().Running() || session.Lab().Running();
  if (count == 0) {
    ui.Paragraph(Tr("The queue is empty. “Add to queue” adds this search. Up to {1} searches fit.",
                    std::to_string(SearchQueue::kMax)),
                 Type::kNote);
  } else if (busy) {
    ui.Paragraph(Tr(session.Lab().Running() ? "The lab is running. Press Run queue when it is done."
                                            : "Searches run one after another. After Stop, the rest wait."),
                 Type::kNote);
  } else {
    ui.Gap(2.0f);
    if (ui.Button("queue/run", ui.ControlRow(), Tr("Run queue"), ButtonLook::kPrimary)) session.Queue().Run();
  }
  ui.Gap(4.0f);
  // Applied after the loop, since it changes the list.
  QueueAction action = QueueAction::kNothing;
  int number = 0;
  for (std::size_t place = 0; place < queue.Waiting().size(); ++place) {
    const SearchQueue::Entry& entry = queue.Waiting()[place];
    const QueueAction here = DrawEntry(ui, entry, place);
    if (here == QueueAction::kNothing) continue;
    action = here;
    number = entry.number;
  }
  if (count > 1) {
    ui.Gap(4.0f);
    if (ui.Button("queue/clear", ui.ControlRow(), Tr("Clear queue"))) queue.Clear();
  }
  if (queue.Removed() > 0) {
    ui.Gap(4.0f);
    const std::string words =
        queue.Removed() == 1 ? Tr("Bring back the removed search")
                             : Tr("Bring back all {1}", Grouped(static_cast<long long>(queue.Removed())));
    if (ui.Button("queue/bring-back", ui.ControlRow(), words)) queue.BringBack();
  }
  if (action == QueueAction::kUp) queue.MoveUp(number);
  if (action == QueueAction::kRemove) queue.Remove(number);
}

}  // namespace gaitsmith::shell
