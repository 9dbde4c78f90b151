// SPDX-License-Identifier: MIT
// Senses, period, number of rules, and the rule cards or the network: a learner can read why the figure does
// what it does.
#include "shell/panel_controller.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shell/figure_drawing.h"
#include "shell/network_diagram.h"
#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kCardHeight = 70.0f;
constexpr std::size_t kBarsShown = 4;

// How a timer compares with the length of the motion: below it the motion repeats, above it never does.
std::string PeriodWords(int period_steps, int duration_steps) {
  const float ratio = static_cast<float>(period_steps) / static_cast<float>(duration_steps);
  if (ratio < 0.1f) return "far below the motion's length: it repeats like a wind-up toy";
  if (ratio < 0.6f) return "below the motion's length: it repeats a few times";
  if (ratio <= 1.0f) return "about the motion's length: hardly repeats";
  return "above the motion's length: it never repeats";
}

void DrawSettings(Ui& ui, Session& session) {
  const SenseSpec& senses = session.Doc().senses;
  static constexpr std::array<std::string_view, 3> kKinds = {"Timer", "Senses", "Network"};
  const bool network = session.Doc().kind == ControllerKind::kNetwork;
  int kind = static_cast<int>(DeciderOf(session.Doc()));
  if (ui.Segmented("controller/senses", ui.Row(ui.Look().touch ? 42.0f : 34.0f), kKinds, kind)) {
    session.Set([&](Document& d) { Decide(d, static_cast<Decider>(kind)); });
  }
  ui.Gap(8.0f);
  ui.Paragraph(kind == 0   ? "Rules that follow a clock: a wind-up toy."
               : kind == 1 ? "Rules that feel angles, contacts, height and rise."
                           : "Touch and angle sensors, hidden nodes and actuators, all connected.",
               Type::kNote);
  ui.Gap(10.0f);
  if (kind == 0) {
    const float seconds = static_cast<float>(senses.period_steps) * kStep;
    double period = static_cast<double>(seconds);
    if (ui.Slider("controller/period", "Period", period,
                  {.low = 0.1, .high = 30.0, .step = 0.01, .logarithmic = true}, Fixed(seconds, 2) + " s")) {
      const int steps = static_cast<int>(std::lround(period * 100.0));
      // A timer controller on the stage follows at once: the same rules, wound faster or slower.
      const Controller* shown = session.ShownController();
      const bool live = shown != nullptr && shown->senses.kind == SenseKind::kTimer;
      const auto edit = [&](Document& d) {
        d.senses.period_steps = steps;
        if (!live) return;
        const auto clip = static_cast<std::size_t>(session.SelectedClip());
        d.controllers[static_cast<std::size_t>(d.timeline[clip].controller)].senses.period_steps = steps;
      };
      if (live) {
        session.Change(edit);
      } else {
        session.Set(edit);
      }
    }
    const int motion = session.Doc().task.duration_steps;
    ui.Paragraph(PeriodWords(session.Doc().senses.period_steps, motion), Type::kNote);
    ui.Gap(8.0f);
  }
  double rules = session.Doc().rules;
  if (ui.Slider("controller/rules", network ? "Hidden nodes" : "Rules", rules,
                {.low = 1.0, .high = 20.0, .step = 1.0}, std::to_string(session.Doc().rules))) {
    session.Set([&](Document& d) { d.rules = static_cast<int>(rules); });
  }
  const float tau = session.Doc().senses.tau_min_s;
  double fastest = static_cast<double>(tau);
  if (ui.Slider("controller/tau", "Fastest response τ", fastest,
                {.low = 0.05, .high = 0.5, .step = 0.01, .logarithmic = true}, Fixed(tau, 2) + " s")) {
    session.Set([&](Document& d) {
      d.senses.tau_min_s = static_cast<float>(fastest);
      d.senses.tau_max_s = std::max(d.senses.tau_max_s, d.senses.tau_min_s);
    });
  }
}

// Where the interval lies on the bar, and the present value in it.
struct Bar {
  float low, high, value;
};

std::vector<Bar> BarsOf(const Controller& controller, const BankShape& shape, int rule, const Motion& motion,
                        int frame, bool in_charge) {
  std::vector<Bar> bars;
  const bool timer = controller.senses.kind == SenseKind::kTimer;
  // Physical intervals may end a quarter outside of [0, 1]; the bar shows all of it.
  const auto on_bar = [timer](float sense) {
    return timer ? sense : (sense - kEdgeLow) / (kEdgeHigh - kEdgeLow);
  };
  for (int sense = 0; sense < shape.senses; ++sense) {
    if (!shape.Cares(controller.genes, rule, sense)) continue;
    const float low = Decode(controller.genes[shape.Low(rule, sense)], 0.0f, 1.0f);
    const float high = Decode(controller.genes[shape.High(rule, sense)], 0.0f, 1.0f);
    const float value = in_charge ? std::clamp(on_bar(motion.Sense(frame, sense)), 0.0f, 1.0f) : -1.0f;
    bars.push_back({low, high, value});
  }
  return bars;
}

std::string CaresWords(const Controller& controller, const BankShape& shape, int rule, int rods) {
  std::string words;
  for (int sense = 0; sense < shape.senses; ++sense) {
    if (!shape.Cares(controller.genes, rule, sense)) continue;
    words += (words.empty() ? "" : ", ") + SenseName(controller.senses.kind, rods, sense);
  }
  return words.empty() ? "heeds no sense" : "heeds " + words;
}

void DrawCard(Ui& ui, const Session& session, const Controller& controller, int rule, const ImRect& rect) {
  const Motion& motion = session.player.Shown();
  const Skeleton& bones = motion.Bones();
  const Motion::Frame& now = motion.At(session.player.Frame());
  const BankShape shape(controller.rules, controller.senses.kind, bones.rods);
  const bool in_charge = now.clip == session.SelectedClip();
  const bool active = in_charge && now.rule == rule;
  const float tau = DecodeTau(controller.genes[shape.Tau(rule)], controller.senses);
  const std::string title = std::to_string(rule + 1) + " · τ " + Fixed(tau, 2) + " s";
  const Touch touch =
      ui.Area("controller/rule/" + std::to_string(rule + 1), rect, Grab::kPress,
              {.label = "Rule " + std::to_string(rule + 1),
               .role = "img",
               .value = "τ " + Fixed(tau, 2) + " s, " + CaresWords(controller, shape, rule, bones.rods),
               .state = {.selected = active}});
  if (!touch.visible) return;

  const Palette& p = ui.Ink();
  const ImU32 colour = ui.Look().Rule(rule);
  ImDrawList* list = ui.Canvas();
  if (active) {
    ImRect halo = rect;
    halo.Expand(2.0f);
    list->AddRectFilled(halo.Min, halo.Max, Mix(p.panel, colour, 0.25f), 11.0f);
  }
  ui.Frame(rect, p.panel, active ? colour : p.line, 9.0f);

  // The pose this rule pulls the joints to.
  std::array<float, kMaxJoints> angles{};
  for (int joint = 0; joint < bones.joints; ++joint) {
    const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(joint) + 1];
    angles[static_cast<std::size_t>(joint)] =
        Decode(controller.genes[shape.Target(rule, joint)], limb.min_rad, limb.max_rad);
  }
  const std::vector<ImVec2> pose =
      PoseOf(bones, std::span(angles).first(static_cast<std::size_t>(bones.joints)));
  float low_x = 0.0f, high_x = 0.0f, low_y = 0.0f, high_y = 0.0f;
  for (const ImVec2& point : pose) {
    low_x = std::min(low_x, point.x);
    high_x = std::max(high_x, point.x);
    low_y = std::min(low_y, point.y);
    high_y = std::max(high_y, point.y);
  }
  const float scale = 46.0f / std::max({high_x - low_x, high_y - low_y, session.player.ReachM()});
  const ImVec2 middle(rect.Min.x + 34.0f, rect.GetCenter().y);
  std::vector<ImVec2> points;
  points.reserve(pose.size());
  for (const ImVec2& point : pose) {
    points.emplace_back(middle.x + (point.x - 0.5f * (low_x + high_x)) * scale,
                        middle.y - (point.y - 0.5f * (low_y + high_y)) * scale);
  }
  DrawFigure(list, bones, points,
             {.rods = active ? colour : Mix(p.panel, p.ink, 0.82f),
              .width = std::clamp(RodWidth(bones, scale), 2.5f, 5.0f)});

  const float left = rect.Min.x + 66.0f;
  const float right = rect.Max.x - 10.0f;
  std::vector<Bar> bars = BarsOf(controller, shape, rule, motion, session.player.Frame(), in_charge);
  float title_right = right;
  if (bars.size() > kBarsShown) {
    // The card has no room for the rest, but it must not hide that there is one.
    const std::string more = "+" + std::to_string(bars.size() - kBarsShown);
    bars.resize(kBarsShown);
    ui.Letters().Draw(list, Type::kSmall, {right, rect.Min.y + 15.0f}, p.second_ink, more, Align::kRight);
    title_right -= ui.Letters().Width(Type::kSmall, more) + 6.0f;
  }
  ui.Letters().DrawElided(list, Type::kSmall, {left, rect.Min.y + 15.0f}, title_right - left,
                          active ? p.ink : p.second_ink, title);
  if (bars.empty())
    ui.Letters().DrawElided(list, Type::kSmall, {left, rect.Min.y + 34.0f}, right - left, p.second_ink,
                            "at any time");
  float y = rect.Min.y + 28.0f;
  for (const Bar& bar : bars) {
    const auto x_of = [&](float share) { return left + share * (right - left); };
    list->AddRectFilled({left, y}, {right, y + 5.0f}, p.soft, 2.5f);
    list->AddRectFilled({x_of(bar.low), y}, {std::max(x_of(bar.high), x_of(bar.low) + 2.0f), y + 5.0f},
                        Mix(p.panel, colour, active ? 0.75f : 0.5f), 2.5f);
    if (bar.value >= 0.0f)
      list->AddRectFilled({x_of(bar.value) - 1.0f, y - 2.0f}, {x_of(bar.value) + 1.0f, y + 7.0f}, p.ink);
    y += 10.0f;
  }
  ui.DrawFocus(touch, rect, 9.0f);
}

}  // namespace

void DrawControllerPanel(Ui& ui, Session& session) {
  DrawSettings(ui, session);
  ui.Gap(10.0f);
  const Controller* shown = session.ShownController();
  const Document& d = session.Doc();
  const bool differs = shown != nullptr && (shown->senses.kind != d.senses.kind || shown->rules != d.rules ||
                                            shown->kind != d.kind);
  if (shown == nullptr || differs) {
    ui.Paragraph(shown == nullptr ? "No controller yet. A search finds one with these settings."
                                  : "The next search uses these settings. On the stage: " +
                                        ControllerWords(shown->kind, shown->senses, shown->rules) + ".",
                 Type::kNote);
    ui.Gap(6.0f);
    if (!session.Searching() &&
        ui.Button("controller/start", ui.Row(38.0f), "Synthesize", ButtonLook::kPrimary)) {
      session.Synthesize();
      return;
    }
    ui.Gap(12.0f);
  }
  if (shown == nullptr) return;
  if (shown->kind == ControllerKind::kNetwork) return DrawNetwork(ui, session, *shown);
  for (int rule = 0; rule < shown->rules; rule += 2) {
    const ImRect row = ui.Row(kCardHeight);
    const float width = 0.5f * (row.GetWidth() - 8.0f);
    DrawCard(ui, session, *shown, rule, {row.Min, {row.Min.x + width, row.Max.y}});
    if (rule + 1 < shown->rules)
      DrawCard(ui, session, *shown, rule + 1, {{row.Max.x - width, row.Min.y}, row.Max});
    ui.Gap(8.0f);
  }
}

}  // namespace gaitsmith::shell
