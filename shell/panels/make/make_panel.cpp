// SPDX-License-Identifier: MIT
#include "shell/panels/make/make_panel.h"

#include <algorithm>
#include <array>

#include "core/document/standing.h"
#include "shell/panels/make/goal_chips.h"
#include "shell/stage/live_switch.h"
#include "shell/words/control_modes.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

/// A choice with a line that explains it.
struct Card {
  const char* id;
  const char* label;
  std::string line;
};

/// Cards side by side. @return the pressed one, or -1
int DrawCards(Ui& ui, std::string_view id, const char* label, std::span<const Card> cards, int chosen) {
  const PartScope group = ui.Part(id, "radiogroup", label);
  const ImRect row = ui.Row(ui.Look().touch ? 50.0f : 46.0f);
  constexpr float kBetween = 8.0f;
  const auto count = static_cast<float>(cards.size());
  const float width = (row.GetWidth() - (count - 1.0f) * kBetween) / count;
  const Palette& p = ui.Ink();
  int pressed = -1;
  float x = row.Min.x;
  for (int i = 0; i < static_cast<int>(cards.size()); ++i) {
    const Card& card = cards[static_cast<std::size_t>(i)];
    const ImRect rect({x, row.Min.y}, {x + width, row.Max.y});
    x += width + kBetween;
    const bool on = i == chosen;
    const Touch touch = ui.Area(
        card.id, rect, Grab::kPress,
        {.label = std::string(Tr(card.label)) + ", " + card.line, .role = "radio", .state = {.checked = on}});
    if (touch.pressed && !on) pressed = i;
    ui.CardFrame(rect, on, touch.hovered);
    const float left = rect.Min.x + 10.0f, room = width - 14.0f, y = rect.GetCenter().y;
    ui.Letters().DrawElided(ui.Canvas(), on ? Type::kStrong : Type::kBody, {left, y - 8.0f}, room, p.ink,
                            Tr(card.label));
    ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {left, y + 9.0f}, room, p.second_ink, card.line);
    ui.DrawFocus(touch, rect, 9.0f);
  }
  return pressed;
}

void DrawSenses(Ui& ui, Session& session) {
  ui.Heading(Tr("Senses"));
  ui.Gap(4.0f);
  const std::array<Card, 2> cards = {
      Card{"make/timer", TrLater("Timer"), Tr("keeps a beat")},
      Card{"make/senses", TrLater("Physical senses"), Tr("feels the ground")},
  };
  static constexpr std::array<ControlMode, 2> kModes = {ControlMode::kTimer, ControlMode::kSenses};
  const auto now = std::ranges::find(kModes, ControlModeOf(session.Doc()).mode);
  const int chosen = now == kModes.end() ? -1 : static_cast<int>(now - kModes.begin());
  const int pressed = DrawCards(ui, "make/control", Tr("Senses"), cards, chosen);
  if (pressed < 0) return;
  const ControlMode mode = kModes[static_cast<std::size_t>(pressed)];
  session.Set([&](Document& d) { SetControlMode(d, kControlModes[static_cast<std::size_t>(mode)]); });
}

/// A fixed number of tries, so that every machine finds the same motion.
constexpr std::array<int, 3> kTries = {kQuickEvaluations, 16000, 64000};

void DrawEffort(Ui& ui, Session& session) {
  ui.Heading(Tr("Effort"));
  ui.Gap(4.0f);
  const auto tries = [](int effort) {
    return Tr("{1} tries", Grouped(kTries[static_cast<std::size_t>(effort)]));
  };
  const std::array<Card, 3> cards = {Card{"make/quick", TrLater("Quick"), tries(0)},
                                     Card{"make/good", TrLater("Good"), tries(1)},
                                     Card{"make/best", TrLater("Best"), tries(2)}};
  const auto now = std::ranges::find(kTries, session.Doc().search.evaluations);
  const int chosen = now == kTries.end() ? -1 : static_cast<int>(now - kTries.begin());
  const int pressed = DrawCards(ui, "make/effort", Tr("Effort"), cards, chosen);
  if (pressed >= 0)
    session.Set([&](Document& d) { d.search.evaluations = kTries[static_cast<std::size_t>(pressed)]; });
}

}  // namespace

void DrawMakePanel(Ui& ui, Session& session) {
  ui.Heading(Tr("Goal"));
  ui.Gap(4.0f);
  DrawGoalChips(ui, session);
  ui.Gap(12.0f);
  DrawSenses(ui, session);
  ui.Gap(14.0f);
  DrawEffort(ui, session);
  ui.Gap(14.0f);
  DrawLiveSwitch(ui, session, "make/live");
  if (ui.Button("make/advanced", ui.ControlRow(), Tr("Advanced: all settings"))) session.ShowAll();
}

}  // namespace gaitsmith::shell
