// SPDX-License-Identifier: MIT
#include "shell/panels/controller/rule_editor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/control/rule_edit.h"
#include "core/control/sense_table.h"
#include "shell/panels/controller/rule_card.h"
#include "shell/words/language.h"
#include "shell/words/rule_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

struct OpenRule {
  Ui& ui;
  Session& session;
  const Controller& controller;
  const Skeleton& bones;
  const Ports& ports;
  int rule;
  ImU32 colour;

  // The edit stops a running search, whose result may have fewer rules.
  void Edit(const std::function<void(RuleEdit)>& edit) const {
    session.Timeline().ChangeController([&, count = ports.Count()](Controller& c) {
      if (rule < c.rules) edit(RuleEdit(c, count, rule));
    });
  }
  void SetTarget(const PoseEdit& edit) const {
    const auto [least, most] = ports.actuator_range[static_cast<std::size_t>(edit.joint)];
    Edit([&, low = least, high = most](RuleEdit one) {
      one.SetTarget(edit.joint, edit.angle_rad, low, high);
    });
  }
  [[nodiscard]] std::string Named(int sense) const {
    std::string name = TrSentence(SenseName(controller.senses.kind, ports.Count(), sense));
    if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
  }
};

// @return false if the rule was deleted
bool DrawHeader(const OpenRule& open, RuleEditorState& state) {
  Ui& ui = open.ui;
  const ImRect row = ui.ControlRow();
  const float y = row.GetCenter().y;
  ui.Canvas()->AddCircleFilled({row.Min.x + 6.0f, y}, 6.0f, open.colour);
  ui.Letters().Draw(ui.Canvas(), Type::kHeading, {row.Min.x + 20.0f, y}, ui.Ink().ink,
                    Tr("Rule {1}", open.rule + 1));
  const float close = row.GetHeight();
  float x = row.Max.x - close - 134.0f;
  const auto box = [&](float width) {
    const ImRect area({x, row.Min.y}, {x + width, row.Max.y});
    x += width + 6.0f;
    return area;
  };
  const PortCount count = open.ports.Count();
  const int rule = open.rule;
  if (ui.Button("rule-edit/copy", box(58.0f), Tr("Copy"), ButtonLook::kOutlined,
                open.controller.rules < kMaxRules, Tr("Copy the rule"))) {
    const bool copied = open.session.Timeline().ChangeController([&](Controller& c) {
      if (rule < c.rules && c.rules < kMaxRules) CopyRule(c, count, rule);
    });
    if (copied) state = {.rule = rule + 1, .reveal = true};
    return false;
  }
  if (ui.Button("rule-edit/delete", box(64.0f), Tr("Delete"), ButtonLook::kOutlined,
                open.controller.rules > 1, Tr("Delete the rule"))) {
    open.session.Timeline().ChangeController([&](Controller& c) {
      if (rule < c.rules && c.rules > 1) DeleteRule(c, count, rule);
    });
    state = {};
    return false;
  }
  if (ui.IconButton("rule-edit/close", {{row.Max.x - close, row.Min.y}, row.Max}, Icon::kClose,
                    Tr("Close the editor"))) {
    state = {};
    return false;
  }
  return true;
}

void DrawPose(const OpenRule& open, RuleEditorState& state) {
  const Playback& player = open.session.Player();
  std::vector<float> present;
  if (player.Shown().At(player.Frame()).clip == open.session.Timeline().Selected()) {
    for (int joint = 0; joint < open.bones.joints; ++joint) {
      present.push_back(player.Shown().AngleRad(player.Frame(), joint));
    }
  }
  const std::vector<float> target = TargetPose(open.controller, open.ports, open.rule);
  const auto edit =
      DrawPoseBoard(open.ui, "rule-edit/pose", Tr("Target pose of rule {1}: drag a limb", open.rule + 1),
                    open.colour, open.bones, target, present, state.drag);
  if (!edit) return;
  open.SetTarget(*edit);
}

void DrawTau(const OpenRule& open) {
  const SenseSpec& senses = open.controller.senses;
  const float tau = TauOf(open.controller, open.ports.Count(), open.rule);
  double wanted = static_cast<double>(tau);
  const SliderRange range{.low = static_cast<double>(senses.tau_min_s),
                          .high = static_cast<double>(senses.tau_max_s),
                          .step = 0.01,
                          .logarithmic = true};
  if (senses.tau_max_s <= senses.tau_min_s) {
    open.ui.Fact(Tr("Time constant τ"), Fixed(tau, 2) + " s");
  } else if (open.ui.Slider("rule-edit/tau", Tr("Time constant τ"), wanted, range, Fixed(tau, 2) + " s")) {
    open.Edit([&](RuleEdit rule) { rule.SetTau(static_cast<float>(wanted)); });
  }
}

void DrawHeeded(const OpenRule& open, int sense) {
  Ui& ui = open.ui;
  const Motion& motion = open.session.Player().Shown();
  const int frame = open.session.Player().Frame();
  const SenseSpec& spec = open.controller.senses;
  const Stimulus stimulus = StimulusOf(open.controller, open.ports.Count(), open.rule, sense);
  const SenseScale scale = ScaleOf(spec, open.ports, sense);
  const std::string id = "rule-edit/sense/" + std::to_string(sense + 1);
  const bool felt = frame > 0 && motion.At(frame).clip == open.session.Timeline().Selected();
  const auto words = [&](float value) { return QuantityWords(scale.quantity, scale.Of(value)); };
  SliderInterval interval{ShareOnBar(spec, stimulus.low), ShareOnBar(spec, stimulus.high),
                          words(stimulus.low), words(stimulus.high),
                          felt ? ShareOnBar(spec, motion.Sense(frame, sense)) : -1.0f};

  const ImVec2 at = ImGui::GetCursorScreenPos();
  bool cares = true;
  if (ui.Switch(id, open.Named(sense), cares)) {
    open.Edit([&](RuleEdit rule) { rule.SetCares(sense, false); });
  }
  const ImRect row(at, {at.x + ui.Row(0.0f).GetWidth(), at.y + ui.Look().ControlHeight()});
  ui.Letters().Draw(ui.Canvas(), Type::kNote, {row.Max.x - 44.0f, row.GetCenter().y}, ui.Ink().second_ink,
                    Tr("{1} to {2}", interval.low_text, interval.high_text), Align::kRight);
  if (cares && ui.IntervalSlider(id, open.Named(sense), interval, open.colour)) {
    const auto [low, high] = EdgesOf(spec.kind);
    open.Edit([&](RuleEdit rule) {
      rule.SetInterval(sense, low + interval.low * (high - low), low + interval.high * (high - low));
    });
  }
  ui.Gap(4.0f);
}

// Ignored senses as small switches side by side.
void DrawIgnored(const OpenRule& open, const std::vector<int>& senses) {
  Ui& ui = open.ui;
  const float height = ui.Look().touch ? 34.0f : 26.0f;
  const int columns = 4;
  const Palette& p = ui.Ink();
  for (std::size_t i = 0; i < senses.size(); i += columns) {
    const ImRect row = ui.Row(height);
    const float width = (row.GetWidth() - 6.0f * (columns - 1)) / columns;
    for (std::size_t k = i; k < std::min(senses.size(), i + columns); ++k) {
      const int sense = senses[k];
      const float x = row.Min.x + static_cast<float>(k - i) * (width + 6.0f);
      const ImRect chip({x, row.Min.y}, {x + width, row.Max.y});
      const Touch touch = ui.Area(
          "rule-edit/sense/" + std::to_string(sense + 1), chip, Grab::kPress,
          {.label = open.Named(sense), .role = "switch", .value = Tr("off"), .state = {.checked = false}});
      if (touch.pressed) open.Edit([&](RuleEdit rule) { rule.SetCares(sense, true); });
      if (!touch.visible) continue;
      ui.Frame(chip, Mix(p.panel, p.ink, touch.hovered ? 0.05f : 0.0f), p.line);
      ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {chip.Min.x + 8.0f, chip.GetCenter().y},
                              width - 12.0f, p.second_ink, open.Named(sense));
      ui.DrawFocus(touch, chip);
    }
    ui.Gap(6.0f);
  }
}

void DrawStimulus(const OpenRule& open) {
  std::vector<int> ignored;
  open.ui.Heading(Tr("Active when"));
  for (int sense = 0; sense < SenseCount(open.controller.senses.kind, open.ports.Count()); ++sense) {
    if (StimulusOf(open.controller, open.ports.Count(), open.rule, sense).cares) {
      DrawHeeded(open, sense);
    } else {
      ignored.push_back(sense);
    }
  }
  if (ignored.empty()) return;
  open.ui.Paragraph(
      Tr(static_cast<int>(ignored.size()) == SenseCount(open.controller.senses.kind, open.ports.Count())
             ? "It uses no sense, so it always matches. Click one to use it:"
             : "Unused senses. Click one to use it:"),
      Type::kNote);
  open.ui.Gap(4.0f);
  DrawIgnored(open, ignored);
}

void DrawJoints(const OpenRule& open) {
  open.ui.Heading(open.ports.muscles ? Tr("Target lengths") : Tr("Target angles"));
  const auto edit = DrawAngleSliders(open.ui, "rule-edit/angle", open.ports,
                                     TargetPose(open.controller, open.ports, open.rule),
                                     std::vector<ImU32>(open.ports.actuator_range.size(), open.colour));
  if (edit) open.SetTarget(*edit);
}

}  // namespace

void DrawRuleEditor(Ui& ui, Session& session, const Controller& controller, RuleEditorState& state) {
  // Copies, since an edit replaces the motion while the rest is being drawn.
  const Skeleton bones = session.Player().Shown().Bones();
  const Ports ports = session.Player().Shown().Connections();
  const OpenRule open{ui, session, controller, bones, ports, state.rule, ui.Look().Rule(state.rule)};
  const PartScope part = ui.Part("rule-edit", "group", Tr("Editor of rule {1}", state.rule + 1));
  const float top = ImGui::GetCursorScreenPos().y;
  if (!DrawHeader(open, state)) return;
  ui.Gap(4.0f);
  if (!ports.muscles) {
    DrawPose(open, state);
    ui.Gap(2.0f);
    ui.Paragraph(Tr("Drag a limb to turn it within its limits. Grey: the pose now."), Type::kNote);
    ui.Gap(8.0f);
  }
  DrawTau(open);
  ui.Gap(8.0f);
  DrawStimulus(open);
  ui.Gap(6.0f);
  DrawJoints(open);
  // A line in the rule's colour marks the editor's extent.
  const ImVec2 end = ImGui::GetCursorScreenPos();
  ui.Canvas()->AddRectFilled({end.x - 9.0f, top}, {end.x - 6.0f, end.y}, open.colour, 1.5f);
  ui.Gap(12.0f);
}

}  // namespace gaitsmith::shell
