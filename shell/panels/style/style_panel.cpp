// SPDX-License-Identifier: MIT
// Task, duration, weights, the measures, and folded away the score term by term.
#include "shell/panels/style/style_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/document/joints.h"
#include "core/document/style_weights.h"
#include "shell/stage/live_switch.h"
#include "shell/widgets/fold.h"
#include "shell/words/language.h"
#include "shell/words/style_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

/// The score of the motion so far as a sum: one line per term, with measured value, weight and their product.
/// Terms without weight are listed too.
class ScoreTable {
 public:
  ScoreTable(Ui& ui, int lines)
      : ui_(ui),
        line_height_(ui.Look().touch ? 24.0f : 20.0f),
        whole_(ui.Row(line_height_ * static_cast<float>(lines) + kRuleGap)),
        y_(whole_.Min.y) {}

  void Head() {
    const float y = Next();
    Put(Type::kNote, y, kMeasured, ui_.Ink().second_ink, Tr("measured"));
    Put(Type::kNote, y, kWeight, ui_.Ink().second_ink, Tr("weight"));
    Put(Type::kNote, y, kAdds, ui_.Ink().second_ink, Tr("adds"));
  }
  /// @param weight empty: the term has none
  void Line(std::string_view name, const std::string& measured, const std::string& weight,
            const std::string& adds) {
    const float y = Next();
    const bool counts = !adds.empty();
    const ImU32 ink = counts ? ui_.Ink().ink : ui_.Ink().second_ink;
    ui_.Letters().Draw(ui_.Canvas(), Type::kBody, {whole_.Min.x, y}, ink, name);
    Put(Type::kBody, y, kMeasured, ui_.Ink().second_ink, measured);
    if (!weight.empty()) Put(Type::kBody, y, kWeight, ui_.Ink().second_ink, "× " + weight);
    if (counts) Put(Type::kBody, y, kAdds, ink, adds);
  }
  /// @param sum empty: the name explains why there is no sum
  void Sum(std::string_view name, const std::string& sum, ImU32 colour) {
    y_ += kRuleGap;
    ui_.HorizontalLine(whole_.Min.x, whole_.Max.x, y_ - 0.5f * kRuleGap);
    const float y = Next();
    ui_.Letters().Draw(ui_.Canvas(), Type::kStrong, {whole_.Min.x, y}, sum.empty() ? colour : ui_.Ink().ink,
                       name);
    Put(Type::kStrong, y, kAdds, colour, sum);
  }
  [[nodiscard]] const ImRect& Whole() const { return whole_; }

 private:
  // Right edges of the right-aligned columns, as shares of the width.
  static constexpr float kMeasured = 0.58f;
  static constexpr float kWeight = 0.78f;
  static constexpr float kAdds = 1.0f;
  static constexpr float kRuleGap = 7.0f;

  float Next() {
    y_ += line_height_;
    return y_ - 0.5f * line_height_;
  }
  void Put(Type type, float y, float column, ImU32 colour, std::string_view text) const {
    ui_.Letters().Draw(ui_.Canvas(), type, {whole_.Min.x + column * whole_.GetWidth(), y}, colour, text,
                       Align::kRight);
  }

  Ui& ui_;
  float line_height_;
  ImRect whole_;
  float y_;  // top of the next line
};

/// The task's measure, those of the paper, and whatever has a weight. All others stand in the score, because
/// a list of every measure would push the sliders out of the panel.
void DrawMeasures(Ui& ui, const Session& session) {
  const Terms& terms = session.Player().TermsNow();
  const TaskKind kind = session.Doc().task.kind;
  const ImRect head = ui.Row(Fonts::LineHeight(Type::kStrong) + 4.0f);
  const float y = head.GetCenter().y;
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {head.Min.x, y}, ui.Ink().ink, Tr("So far"));
  ui.Letters().Draw(ui.Canvas(), Type::kNote, {head.Max.x, y}, ui.Ink().second_ink,
                    Tr("at {1} s", Fixed(session.Player().TimeS(), 2)), Align::kRight);
  ui.Fact(PrimaryLabel(kind), AmountText(Primary(session.Doc().task, terms), 2) + " m");
  for (std::size_t i = 0; i < kStyleTerms; ++i) {
    if (!CanMeasure(session.Doc().task, static_cast<StyleTerm>(i))) continue;
    if (i >= kPaperTerms && session.Doc().task.weights[i] == 0.0f) continue;
    const TermWords words = TermTextFor(session.Doc().figure, i);
    ui.Fact(Tr(words.label), ValueText(words, terms.Style(static_cast<StyleTerm>(i))));
  }
}

void DrawScore(Ui& ui, const Session& session) {
  const Task& task = session.Doc().task;
  const Terms& terms = session.Player().TermsNow();
  const float fitness = Fitness(task, terms);
  int lines = 4;  // head, primary term, sum and end
  for (int term = 0; term < kStyleTerms; ++term)
    lines += CanMeasure(task, static_cast<StyleTerm>(term)) ? 1 : 0;
  ScoreTable table(ui, lines);
  // The whole sum as one note for screen readers.
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav | ImGuiItemFlags_NoTabStop, true);
  ui.Area("style/score", table.Whole(), Grab::kNothing,
          {.label = Tr("Score so far"), .role = "note", .value = ScoreWords(session.Doc(), terms)});
  ImGui::PopItemFlag();
  table.Head();
  const float primary = Primary(task, terms);
  table.Line(PrimaryLabel(task.kind), AmountText(primary, 2) + " m", "", AmountText(primary, 2));
  for (std::size_t i = 0; i < kStyleTerms; ++i) {
    if (!CanMeasure(task, static_cast<StyleTerm>(i))) continue;
    const TermWords words = TermTextFor(session.Doc().figure, i);
    const float value = terms.Style(static_cast<StyleTerm>(i));
    const float weight = task.weights[i];
    const bool weighed = weight != 0.0f;
    table.Line(Tr(words.label), ValueText(words, value), weighed ? WeightText(weight) : "",
               weighed ? AmountText(weight * value, 2) : "");
  }
  if (fitness <= kVoidScore) {
    table.Sum(Tr("Void: the simulation failed"), "", ui.Ink().bad);
  } else {
    table.Sum(Tr("Score"), AmountText(fitness, 2), ui.Ink().ScoreInk(fitness));
  }
  const Motion& motion = session.Player().Shown();
  const float whole = Fitness(task, motion.TermsAt(motion.Frames() - 1));
  table.Line(Tr("At the end, {1} s", Fixed(session.Player().DurationS(), 2)), "", "",
             whole <= kVoidScore ? Tr("void") : AmountText(whole, 2));
}

// Limit and step of a weight's slider, in usual weights. The step is less than every gentle weight.
constexpr double kMaxUnits = 3.0;
constexpr double kUnitStep = 0.05;

/// "0.50 · 15.0 per turn · strong"
std::string SliderText(const TermWords& words, float weight, float usual, float gentle) {
  if (weight == 0.0f) return "0";
  std::string text = AmountText(weight / usual, 2) + " · " + WeightText(weight);
  if (*words.per != '\0') text += std::string(" ") + Tr(words.per);
  return text + " · " + (std::abs(weight) <= gentle ? Tr("gentle") : Tr("strong"));
}

/// The sliders of the terms from `first` to before `end` that can be measured.
void DrawSliders(Ui& ui, Session& session, std::size_t first, std::size_t end) {
  const Task& task = session.Doc().task;
  const StyleWeights usual = UsualWeights(session.Doc()), gentle = GentleWeights(session.Doc());
  for (std::size_t i = first; i < end; ++i) {
    if (!CanMeasure(task, static_cast<StyleTerm>(i))) continue;
    const TermWords words = TermTextFor(session.Doc().figure, i);
    const auto unit = static_cast<double>(usual[i]);
    double units = static_cast<double>(task.weights[i]) / unit;
    if (ui.Slider(words.id, Tr(words.label), units, {.low = -kMaxUnits, .high = kMaxUnits, .step = kUnitStep},
                  SliderText(words, task.weights[i], usual[i], gentle[i]))) {
      // Round to the slider's grid: keyboard steps would accumulate rounding errors.
      const auto chosen = static_cast<float>(std::round(units / kUnitStep) * kUnitStep * unit);
      session.Set([&](Document& d) { d.task.weights[i] = chosen; });
    }
    ui.Paragraph(Tr(words.line), Type::kNote);
    ui.Gap(8.0f);
  }
}

void DrawWeights(Ui& ui, Session& session, StylePanelState& state) {
  const Task& task = session.Doc().task;
  const bool any = std::ranges::any_of(task.weights, [](float weight) { return weight != 0.0f; });
  ui.Heading(Tr("Style"));
  ui.Paragraph(Tr("Right asks for more, left for less. 1 is typical."), Type::kNote);
  ui.Paragraph(Tr("Gentle weights usually leave the goal the larger part of the score. Strong ones may not."),
               Type::kNote);
  ui.Gap(8.0f);
  DrawLiveSwitch(ui, session, "style/live");
  DrawSliders(ui, session, 0, kFreeTerms);
  DrawSliders(ui, session, kWorkTerms, kStyleTerms);
  // Terms of what is shown come below its form, so that showing something moves nothing above.
  DrawExampleForm(ui, session, state.example);
  DrawSliders(ui, session, kFreeTerms, kWorkTerms);
  ui.Gap(8.0f);
  if (ui.Button("style/reset", ui.ControlRow(), Tr("Reset all weights to 0"), ButtonLook::kOutlined, any)) {
    session.Set([](Document& d) { d.task.weights = {}; });
  }
}

}  // namespace

void DrawStylePanel(Ui& ui, Session& session, StylePanelState& state) {
  const Task& task = session.Doc().task;
  const std::array<std::string, 4> tasks = {Tr("Travel, either way"), Tr("Travel to the right"),
                                            Tr("Travel to the left"), Tr("Jump")};
  int kind = static_cast<int>(task.kind);
  if (ui.Combo("style/task", Tr("Goal"), tasks, kind)) {
    session.ChangeGoal([&](Document& d) { d.task.kind = static_cast<TaskKind>(kind); });
  }
  ui.Paragraph(PrimaryLine(task.kind), Type::kNote);
  ui.Gap(8.0f);
  const float seconds = static_cast<float>(task.duration_steps) * kStep;
  double duration = static_cast<double>(seconds);
  if (ui.Slider("style/duration", Tr("Duration"), duration, {.low = 1.0, .high = 30.0, .step = 0.5},
                Fixed(seconds, 1) + " s")) {
    session.Timeline().SetDuration(static_cast<int>(std::lround(duration * 100.0)));
  }
  ui.Gap(10.0f);
  DrawMeasures(ui, session);
  if (DrawFold(ui, "style/sum", Tr("How it is scored"), "", state.sum)) DrawScore(ui, session);
  ui.Gap(14.0f);
  DrawWeights(ui, session, state);
  ui.Gap(8.0f);
  if (!session.Search().Running()) {
    if (ui.Button("style/try", ui.Row(ui.Look().MainHeight()), Tr("Quick try from this motion"),
                  ButtonLook::kOutlined, session.Timeline().ShownController() != nullptr)) {
      session.TryStyle();
    }
    ui.Gap(8.0f);
    if (ui.Button("style/start", ui.Row(ui.Look().MainHeight()), Tr("Synthesize in this style"),
                  ButtonLook::kOutlined))
      session.Synthesize();
  }
  ui.Gap(14.0f);
  ui.Heading(Tr("Shown on the stage"));
  bool poses = session.Doc().view.poses;
  bool trail = session.Doc().view.trail;
  bool forces = session.Doc().view.forces;
  if (ui.Switch("view/poses", Tr("Past poses"), poses)) session.SetView([&](View& v) { v.poses = poses; });
  if (ui.Switch("view/trail", Tr("Path of the centre of mass"), trail))
    session.SetView([&](View& v) { v.trail = trail; });
  if (ui.Switch("view/forces", Tr("Contact forces"), forces))
    session.SetView([&](View& v) { v.forces = forces; });
  bool torques = session.Doc().view.torques;
  if (HasLimitedJoints(session.Doc()) && ui.Switch("view/torques", Tr("Torques of the joints"), torques))
    session.SetView([&](View& v) { v.torques = torques; });
  ui.Gap(14.0f);
  if (ui.Button("style/simple", ui.ControlRow(), Tr("Show only goal, senses and effort")))
    session.ShowAll(false);
}

}  // namespace gaitsmith::shell
