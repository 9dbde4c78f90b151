// SPDX-License-Identifier: MIT
#include "shell/panels/controller/rule_why.h"

#include <algorithm>

#include "core/control/rule_edit.h"
#include "shell/panels/controller/rule_card.h"
#include "shell/words/language.h"
#include "shell/words/rule_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr double kReadingTimeS = 0.6;
constexpr int kBoxRows = 6;  // rows in the box: the sentence, then senses
constexpr int kLines = 4;    // most lines of the sentence
constexpr float kSenseHeight = 17.0f;
constexpr float kPadding = 10.0f;

// @return the number of lines used
int DrawSentence(Ui& ui, const ImRect& box, std::string_view sentence) {
  const float height = Fonts::LineHeight(Type::kNote);
  float y = box.Min.y + 0.5f * height;
  int line = 0;
  for (; line < kLines && !sentence.empty(); ++line, y += height) {
    const std::size_t length = ui.Letters().FitLine(Type::kNote, sentence, box.GetWidth());
    if (line + 1 == kLines && length < sentence.size()) {
      ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {box.Min.x, y}, box.GetWidth(), ui.Ink().ink,
                              sentence);
      return kLines;
    }
    ui.Letters().Draw(ui.Canvas(), Type::kNote, {box.Min.x, y}, ui.Ink().ink, sentence.substr(0, length));
    sentence.remove_prefix(length);
    while (!sentence.empty() && sentence.front() == ' ') sentence.remove_prefix(1);
  }
  return line;
}

// The decisive sense comes first, since the sentence is about it.
void DrawSenses(Ui& ui, const RuleMoment& moment, int rule, int most, ImRect row) {
  const Controller& controller = moment.controller;
  const RuleStanding& standing = moment.choice.standings[static_cast<std::size_t>(rule)];
  std::vector<int> used;
  for (int sense = 0; sense < static_cast<int>(moment.senses.size()); ++sense) {
    if (StimulusOf(controller, moment.ports.Count(), rule, sense).cares) used.push_back(sense);
  }
  const auto decisive = std::ranges::find(used, standing.decisive_sense);
  if (decisive != used.end()) std::rotate(used.begin(), decisive, decisive + 1);
  const Palette& p = ui.Ink();
  for (int i = 0; i < std::min(static_cast<int>(used.size()), most); ++i) {
    const int sense = used[static_cast<std::size_t>(i)];
    const float y = row.Min.y + 0.5f * kSenseHeight;
    const Stimulus stimulus = StimulusOf(controller, moment.ports.Count(), rule, sense);
    const SenseScale scale = ScaleOf(controller.senses, moment.ports, sense);
    const float felt = moment.senses[static_cast<std::size_t>(sense)];
    const StimulusBar bar{ShareOnBar(controller.senses, stimulus.low),
                          ShareOnBar(controller.senses, stimulus.high),
                          moment.begins ? -1.0f : ShareOnBar(controller.senses, felt)};
    ui.Letters().Draw(ui.Canvas(), Type::kNote, {row.Min.x, y}, p.second_ink,
                      TrSentence(SenseName(controller.senses.kind, moment.ports.Count(), sense)));
    DrawStimulusBar(ui, {{row.Min.x + 56.0f, y - 3.0f}, {row.Max.x - 70.0f, y + 3.0f}}, bar,
                    ui.Look().Rule(rule));
    ui.Letters().Draw(ui.Canvas(), Type::kNote, {row.Max.x, y}, bar.Holds() ? p.ink : p.second_ink,
                      moment.begins ? "" : QuantityWords(scale.quantity, scale.Of(felt)), Align::kRight);
    row.Min.y += kSenseHeight;
  }
}

}  // namespace

ImRect RuleWhyRow(Ui& ui) {
  return ui.Row(2.0f * kPadding + kBoxRows * Fonts::LineHeight(Type::kNote) + 4.0f);
}

void DrawRuleWhy(Ui& ui, const ImRect& box, const Session& session, const Controller& controller,
                 RuleWhyState& state) {
  const Playback& player = session.Player();
  const Motion& motion = player.Shown();
  const double now_s = ImGui::GetTime();
  const bool old = now_s - state.since_s > kReadingTimeS || state.hash != motion.Hash();
  if (!player.Playing() || old) {
    state.frame = player.Frame();
    state.since_s = now_s;
    state.hash = motion.Hash();
  }
  state.frame = std::min(state.frame, motion.Frames() - 1);
  const auto moment = MomentOf(controller, motion, session.Timeline().Selected(), state.frame);
  const float line_height = Fonts::LineHeight(Type::kNote);
  ImRect inner = box;
  inner.Expand(-kPadding);

  int rule = state.pointed_at;
  if (moment && (rule < 0 || rule >= controller.rules)) rule = motion.At(state.frame).rule;
  const std::string sentence =
      moment ? Tr("At {1} s: {2}", Fixed(state.frame * static_cast<double>(motion.StepS()), 2),
                  WhyWords(*moment, rule))
             : Tr("Another clip is active now. Press Play, or move the time to this clip.");
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav | ImGuiItemFlags_NoTabStop, true);
  const Touch touch =
      ui.Area("controller/why", box, Grab::kNothing, {.label = sentence, .role = "note", .value = ""});
  ImGui::PopItemFlag();
  if (!touch.visible) return;
  const ImU32 colour = moment ? ui.Look().Rule(rule) : ui.Ink().line;
  ui.Frame(box, Mix(ui.Ink().panel, colour, 0.06f), Mix(ui.Ink().line, colour, 0.35f), 9.0f);
  const int lines = DrawSentence(ui, inner, sentence);
  if (!moment) return;
  inner.Min.y += static_cast<float>(lines) * line_height + 4.0f;
  DrawSenses(ui, *moment, rule, kBoxRows - lines, inner);
}

}  // namespace gaitsmith::shell
