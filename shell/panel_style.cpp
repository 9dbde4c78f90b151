// SPDX-License-Identifier: MIT
// Task, duration, weights, and the live score term by term.
#include "shell/panel_style.h"

#include <array>
#include <cmath>

#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

struct TermWords {
  const char* id;
  const char* label;
  const char* hint;
  const char* unit;
};
constexpr std::array<TermWords, kStyleTerms> kTerms = {
    {{"style/height", "Height", "peak of the centre of mass", " m"},
     {"style/slip", "Slip", "how far the feet slide", " m"},
     {"style/rotations", "Rotations", "whole turns", ""}}};

void DrawScore(Ui& ui, const Session& session) {
  const Task& task = session.Doc().task;
  const Terms& terms = session.player.TermsNow();
  const Palette& p = ui.Ink();
  ui.Heading("Score now");
  const auto line = [&](std::string_view name, const std::string& sum, float value, bool strong) {
    const ImRect row = ui.Row(22.0f);
    const float y = row.GetCenter().y;
    const Type type = strong ? Type::kStrong : Type::kBody;
    ui.Letters().Draw(ui.Canvas(), type, {row.Min.x, y}, p.ink, name);
    ui.Letters().Draw(ui.Canvas(), Type::kBody, {row.Max.x - 70.0f, y}, p.second_ink, sum, Align::kRight);
    ui.Letters().Draw(ui.Canvas(), type, {row.Max.x, y}, strong ? p.good : p.ink, Fixed(value, 2),
                      Align::kRight);
  };
  const std::string words = TaskWords(task.kind);
  line(static_cast<char>(words[0] - 'a' + 'A') + words.substr(1), "", Primary(task, terms), false);
  for (std::size_t i = 0; i < kStyleTerms; ++i) {
    const float value = terms.Style(static_cast<StyleTerm>(i));
    line(kTerms[i].label, Fixed(task.weights[i], 1) + " × " + Fixed(value, 2) + kTerms[i].unit,
         task.weights[i] * value, false);
  }
  ui.Gap(4.0f);
  const ImRect rule = ui.Row(5.0f);
  ui.HorizontalLine(rule.Min.x, rule.Max.x, rule.Min.y);
  const float fitness = Fitness(task, terms);
  if (fitness <= kVoidScore) {
    ui.Paragraph("Void: this motion breaks physics.", p.bad);
  } else {
    line("Score", "", fitness, true);
  }
}

}  // namespace

void DrawStylePanel(Ui& ui, Session& session) {
  const Task& task = session.Doc().task;
  static const std::array<std::string, 4> kTasks = {"Travel, either way", "Travel to the right",
                                                    "Travel to the left", "Jump"};
  int kind = static_cast<int>(task.kind);
  if (ui.Combo("style/task", "Goal", kTasks, kind)) {
    session.Set([&](Document& d) { d.task.kind = static_cast<TaskKind>(kind); });
  }
  ui.Gap(8.0f);
  const float seconds = static_cast<float>(task.duration_steps) * kStep;
  double duration = static_cast<double>(seconds);
  if (ui.Slider("style/duration", "Duration", duration, {.low = 1.0, .high = 30.0, .step = 0.5},
                Fixed(seconds, 1) + " s")) {
    session.SetDuration(static_cast<int>(std::lround(duration * 100.0)));
  }
  ui.Gap(12.0f);
  ui.Heading("Style");
  ui.Paragraph("A weight above 0 asks for more of it, below 0 for less.", Type::kNote);
  ui.Gap(6.0f);
  for (std::size_t i = 0; i < kStyleTerms; ++i) {
    double weight = static_cast<double>(task.weights[i]);
    const std::string label = std::string(kTerms[i].label) + "  (" + kTerms[i].hint + ")";
    if (ui.Slider(kTerms[i].id, label, weight, {.low = -10.0, .high = 10.0, .step = 0.1}, Fixed(weight, 1))) {
      session.Set([&](Document& d) { d.task.weights[i] = static_cast<float>(weight); });
    }
    ui.Gap(4.0f);
  }
  ui.Gap(12.0f);
  DrawScore(ui, session);
  ui.Gap(12.0f);
  if (!session.Searching() &&
      ui.Button("style/start", ui.Row(38.0f), "Synthesize in this style", ButtonLook::kOutlined)) {
    session.Synthesize();
  }
  ui.Gap(14.0f);
  ui.Heading("Shown on the stage");
  bool poses = session.Doc().view.poses;
  bool trail = session.Doc().view.trail;
  bool forces = session.Doc().view.forces;
  if (ui.Switch("view/poses", "Past poses", poses)) session.SetView([&](View& v) { v.poses = poses; });
  if (ui.Switch("view/trail", "Path of the centre of mass", trail))
    session.SetView([&](View& v) { v.trail = trail; });
  if (ui.Switch("view/forces", "Contact forces", forces))
    session.SetView([&](View& v) { v.forces = forces; });
}

}  // namespace gaitsmith::shell
