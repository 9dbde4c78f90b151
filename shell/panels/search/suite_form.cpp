// SPDX-License-Identifier: MIT
#include "shell/panels/search/suite_form.h"

#include <string>

#include "shell/words/language.h"
#include "shell/words/style_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr std::array<const char*, kSuiteSenses.size()> kSenseNames = {TrLater("Physical senses"),
                                                                      TrLater("Timer")};

}  // namespace

void DrawSuiteForm(Ui& ui, Session& session, SuiteChoice& choice) {
  ui.Paragraph(Tr("One search for each combination, in the queue. The results can be chained. Runs in the "
                  "background."),
               Type::kNote);
  ui.Gap(4.0f);
  for (std::size_t i = 0; i < kSenseNames.size(); ++i)
    ui.Switch("suite/senses/" + std::to_string(i), Tr(kSenseNames[i]), choice.senses[i]);
  for (std::size_t i = 0; i < kSuiteTasks.size(); ++i)
    ui.Switch("suite/task/" + std::to_string(i), PrimaryLabel(kSuiteTasks[i]), choice.tasks[i]);
  for (std::size_t i = 0; i < kSuiteStyles.size(); ++i)
    ui.Switch("suite/style/" + std::to_string(i), Tr(kSuiteStyles[i].name), choice.styles[i]);
  ui.Gap(4.0f);
  const int searches = choice.Searches();
  const auto room = static_cast<int>(SearchQueue::kMax - session.Queue().List().Waiting().size());
  const bool possible = searches > 0 && searches <= room;
  ui.Paragraph(searches == 0 ? Tr("Choose at least one kind of senses, one goal and one style.")
               : searches > room
                   ? Tr("{1} searches, and the queue has room for {2}.", std::to_string(searches),
                        std::to_string(room))
                   : Tr("{1} of {2} evaluations each, with the settings above.",
                        Tr(searches == 1 ? "{1} search" : "{1} searches", std::to_string(searches)),
                        Grouped(session.Doc().search.evaluations)),
               Type::kNote);
  ui.Gap(4.0f);
  if (ui.Button("suite/make", ui.Row(34.0f), Tr("Make the suite"), ButtonLook::kOutlined, possible))
    session.Queue().AddSuite(choice);
  ui.Gap(6.0f);
}

}  // namespace gaitsmith::shell
