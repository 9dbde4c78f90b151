// SPDX-License-Identifier: MIT
// Senses, period, number of rules, and the rule cards, the network or the curves.
#include "shell/panels/controller/controller_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shell/panels/controller/network_diagram.h"
#include "shell/panels/controller/rule_card.h"
#include "shell/words/control_modes.h"
#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

// Compares a timer's period with the motion's length: with a shorter period the motion repeats, with a longer
// one it does not.
const char* PeriodWords(int period_steps, int duration_steps) {
  const float ratio = static_cast<float>(period_steps) / static_cast<float>(duration_steps);
  if (ratio < 0.1f) return Tr("far below the motion's length: it repeats like a wind-up toy");
  if (ratio < 0.6f) return Tr("below the motion's length: it repeats a few times");
  if (ratio <= 1.0f) return Tr("about the motion's length: hardly repeats");
  return Tr("above the motion's length: it never repeats");
}

// Changes the senses of the next search. A controller of the same mode on the stage follows at once, with the
// same rules or knots.
template <class Edit>
void SetSenses(Session& session, Edit edit) {
  const Controller* shown = session.Timeline().ShownController();
  if (shown == nullptr || ControlModeOf(*shown).mode != ControlModeOf(session.Doc()).mode) {
    session.Set([&](Document& d) { edit(d.senses); });
    return;
  }
  session.Change([&](Document& d) {
    edit(d.senses);
    const auto clip = static_cast<std::size_t>(session.Timeline().Selected());
    edit(d.controllers[static_cast<std::size_t>(d.timeline[clip].controller)].senses);
  });
}

// How far a controller with sight sees. Rules know it in longest rods, people in metres.
void DrawSight(Ui& ui, Session& session) {
  const float rod_m = session.Player().Shown().Bones().longest_rod_m;
  double sight_m = static_cast<double>(session.Doc().senses.sight_rods * rod_m);
  const auto unit_m = static_cast<double>(rod_m);
  if (!ui.Slider("controller/sight", Tr("How far it sees"), sight_m,
                 {.low = 0.5 * unit_m, .high = 20.0 * unit_m, .step = 0.1 * unit_m, .logarithmic = true},
                 Fixed(sight_m, 1) + " m"))
    return;
  const float rods = std::clamp(static_cast<float>(sight_m / unit_m), 0.5f, 20.0f);
  SetSenses(session, [&](SenseSpec& senses) { senses.sight_rods = rods; });
}

// To which side it looks. Its own side is not that of its goal: a figure may back away from what it sees.
void DrawFacing(Ui& ui, Session& session) {
  static constexpr std::array<const char*, 2> kSides = {TrLater("To the right"), TrLater("To the left")};
  int side = static_cast<int>(session.Doc().senses.facing);
  if (ui.Segmented("controller/facing", ui.ControlRow(), Tr("It looks"), kSides, side))
    SetSenses(session, [&](SenseSpec& s) { s.facing = static_cast<Facing>(side); });
  ui.Gap(8.0f);
}

// What a trajectory does after its period.
void DrawAtEnd(Ui& ui, Session& session) {
  static constexpr std::array<const char*, 2> kEnds = {TrLater("Starts again"), TrLater("Rests")};
  int end = static_cast<int>(session.Doc().senses.at_end);
  if (ui.Segmented("controller/at-end", ui.ControlRow(), Tr("After its period"), kEnds, end))
    SetSenses(session, [&](SenseSpec& senses) { senses.at_end = static_cast<CurveEnd>(end); });
  ui.Gap(8.0f);
}

/// What decides. @return the mode that is chosen now
const ControlModeRow& DrawMode(Ui& ui, Session& session) {
  std::vector<const char*> labels;
  std::vector<const ControlModeRow*> modes;
  labels.reserve(kControlModes.size());
  modes.reserve(kControlModes.size());
  int chosen = 0;
  for (const ControlModeRow& mode : kControlModes) {
    if (!CanMove(mode, session.Doc().figure)) continue;
    if (mode.mode == ControlModeOf(session.Doc()).mode) chosen = static_cast<int>(modes.size());
    modes.push_back(&mode);
    labels.push_back(mode.label);
  }
  if (ui.Segmented("controller/senses", ui.Row(ui.Look().touch ? 44.0f : 34.0f), Tr("What decides"), labels,
                   chosen))
    session.Set([&](Document& d) { SetControlMode(d, *modes[static_cast<std::size_t>(chosen)]); });
  ui.Gap(8.0f);
  const ControlModeRow& now = *modes[static_cast<std::size_t>(chosen)];
  ui.Paragraph(Tr(now.explanation), Type::kNote);
  ui.Gap(10.0f);
  return now;
}

void DrawSettings(Ui& ui, Session& session) {
  const ControlModeRow& now = DrawMode(ui, session);
  const SenseSpec& senses = session.Doc().senses;
  if (now.senses == SenseKind::kTimer) {
    const float seconds = static_cast<float>(senses.period_steps) * kStep;
    double period = static_cast<double>(seconds);
    // From far below the motion's length to above it.
    const double length = static_cast<double>(session.Doc().task.duration_steps) * static_cast<double>(kStep);
    const double longest = std::min(std::max(30.0, 1.5 * length), kMaxSteps * static_cast<double>(kStep));
    if (ui.Slider("controller/period", Tr("Period"), period,
                  {.low = 0.1, .high = longest, .step = 0.01, .logarithmic = true},
                  Fixed(seconds, 2) + " s")) {
      const int steps = static_cast<int>(std::lround(period * 100.0));
      SetSenses(session, [&](SenseSpec& s) { s.period_steps = steps; });
    }
    const int motion = session.Doc().task.duration_steps;
    ui.Paragraph(PeriodWords(session.Doc().senses.period_steps, motion), Type::kNote);
    ui.Gap(8.0f);
  }
  if (now.senses == SenseKind::kSight) {
    DrawFacing(ui, session);
    DrawSight(ui, session);
  }
  if (now.mode == ControlMode::kCurves) DrawAtEnd(ui, session);
  double rules = session.Doc().rules;
  const double most = now.mode == ControlMode::kCurves ? kMaxRules : 20.0;
  if (ui.Slider("controller/rules", Tr(now.units), rules,
                {.low = 1.0, .high = std::max(most, rules), .step = 1.0},
                std::to_string(session.Doc().rules))) {
    session.Set([&](Document& d) { d.rules = static_cast<int>(rules); });
  }
  const float tau = session.Doc().senses.tau_min_s;
  double fastest = static_cast<double>(tau);
  if (ui.Slider("controller/tau", Tr("Fastest response τ"), fastest,
                {.low = 0.05, .high = 0.5, .step = 0.01, .logarithmic = true}, Fixed(tau, 2) + " s")) {
    session.Set([&](Document& d) {
      d.senses.tau_min_s = static_cast<float>(fastest);
      d.senses.tau_max_s = std::max(d.senses.tau_max_s, d.senses.tau_min_s);
    });
  }
}

// The cards, two in a row. The editor of an open card follows its row.
void DrawRules(Ui& ui, Session& session, ControllerPanelState& state) {
  // A copy, since an edit replaces the controller while the rest is being drawn.
  const Controller controller = *session.Timeline().ShownController();
  if (state.editor.rule >= controller.rules) state.editor = {};
  const ImRect why = RuleWhyRow(ui);
  ui.Gap(10.0f);
  state.why.pointed_at = -1;
  for (int first = 0; first < controller.rules; first += 2) {
    const ImRect row = ui.Row(kCardHeight);
    const float width = 0.5f * (row.GetWidth() - 8.0f);
    for (int rule = first; rule < std::min(first + 2, controller.rules); ++rule) {
      const float x = rule == first ? row.Min.x : row.Max.x - width;
      const bool open = state.editor.rule == rule;
      const Touch touch =
          DrawRuleCard(ui, session, controller, rule, open, {{x, row.Min.y}, {x + width, row.Max.y}});
      if (touch.hovered || (touch.focused && state.why.pointed_at < 0)) state.why.pointed_at = rule;
      if (!touch.pressed) continue;
      state.editor = open ? RuleEditorState{} : RuleEditorState{.rule = rule, .reveal = true};
    }
    ui.Gap(8.0f);
    if (state.editor.rule < first || state.editor.rule > first + 1) continue;
    if (state.editor.reveal) {
      // Scroll the opened row to the top. If the panel is low, scroll to the editor.
      const bool low = ImGui::GetWindowHeight() < 5.0f * kCardHeight;
      const float top = low ? ImGui::GetCursorScreenPos().y : row.Min.y - 10.0f;
      ImGui::SetScrollFromPosY(top - ImGui::GetWindowPos().y, 0.0f);
      state.editor.reveal = false;
    }
    DrawRuleEditor(ui, session, controller, state.editor);
  }
  // Drawn last, when the state of pointer and keyboard is known, since a paused page draws no further frame.
  // Uses the controller as it is after edits.
  DrawRuleWhy(ui, why, session, *session.Timeline().ShownController(), state.why);
}

// The same figure with a timer and with senses, or the same motion as curves, side by side.
// @return false: another controller is shown now
bool DrawOtherForms(Ui& ui, Session& session, const Controller& shown) {
  const ImRect row = ui.ControlRow();
  const bool records = shown.kind != ControllerKind::kTrajectory && !session.Doc().figure.HasSprings();
  const char* record = Tr("Record as curves");
  const float width = records ? ui.Letters().Width(Type::kBody, record) + 24.0f : 0.0f;
  const ImRect left(row.Min, {row.Max.x - (records ? width + 8.0f : 0.0f), row.Max.y});
  const bool with_timer = ContrastTo(shown).mode == ControlMode::kTimer;
  const bool beside = session.Comparison().Other().Beside();
  const bool awaits = !beside && session.Comparison().Awaits();
  const char* label = Tr(beside       ? "Stop comparing"
                         : with_timer ? "Compare with a timer"
                                      : "Compare with senses");
  if (ui.Button("controller/compare", left, label, ButtonLook::kOutlined, !awaits,
                awaits ? Tr("{1}: a search is running or queued", label) : "")) {
    if (beside) {
      session.Comparison().Stop();
    } else {
      session.Comparison().CompareControlModes();
    }
  }
  if (records && ui.Button("controller/record", {{row.Max.x - width, row.Min.y}, row.Max}, record,
                           ButtonLook::kOutlined)) {
    session.RecordAsCurves();
    return false;
  }
  if (awaits) {
    ui.Paragraph(
        Tr(with_timer ? "A search with a timer is running or queued. Its motion will appear beside this one."
                      : "A search with senses is running or queued. Its motion will appear beside this one."),
        Type::kNote);
  }
  ui.Gap(10.0f);
  return true;
}

}  // namespace

void DrawControllerPanel(Ui& ui, Session& session, ControllerPanelState& state) {
  DrawSettings(ui, session);
  ui.Gap(10.0f);
  const Controller* shown = session.Timeline().ShownController();
  const Document& d = session.Doc();
  const bool differs = shown != nullptr && (shown->senses.kind != d.senses.kind || shown->rules != d.rules ||
                                            shown->kind != d.kind);
  if (shown == nullptr || differs) {
    ui.Paragraph(shown == nullptr ? Tr("No controller yet. A search finds one with these settings.")
                                  : Tr("The next search uses these settings. On the stage: {1}.",
                                       ControllerWords(shown->kind, shown->senses, shown->rules)),
                 Type::kNote);
    ui.Gap(6.0f);
    if (!session.Search().Running() &&
        ui.Button("controller/start", ui.Row(ui.Look().MainHeight()), Tr("Synthesize"))) {
      session.Synthesize();
      return;
    }
    ui.Gap(12.0f);
  }
  if (shown == nullptr) return;
  if (!DrawOtherForms(ui, session, *shown)) return;
  switch (shown->kind) {  // each kind has a view of its own
    case ControllerKind::kRules:
      return DrawRules(ui, session, state);
    case ControllerKind::kNetwork:
      return DrawNetwork(ui, session, *shown);
    case ControllerKind::kTrajectory: {
      const Controller copy = *shown;
      return DrawCurveEditor(ui, session, copy, state.curves);
    }
  }
}

}  // namespace gaitsmith::shell
