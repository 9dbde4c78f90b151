// SPDX-License-Identifier: MIT
#include "shell/stage/felt_senses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/control/rule_edit.h"
#include "core/control/sense_table.h"
#include "core/numeric/scalar_math.h"
#include "core/world/ground_view.h"
#include "shell/body/figure_pose.h"
#include "shell/words/rule_words.h"

namespace gaitsmith::shell {
namespace {

constexpr float kGaugeWidth = 7.0f;
constexpr float kGaugeHeight = 46.0f;
constexpr float kBandHalf = 84.0f;  // of the height's band [points]
constexpr float kPi32 = static_cast<float>(kPi);

// A sense that the rule uses. low, high and now are normalised, cut to what can be drawn.
struct Felt {
  float low, high, now;
  SenseScale scale;
  bool holds;
};

struct Pens {
  ImU32 edge, back, line, ink;
};

Pens PensFor(const Scene& s, int rule, bool holds) {
  const Palette& p = s.ui.Ink();
  const ImU32 colour = s.ui.Look().Rule(rule);
  return {.edge = Fade(p.paper, 0.85f),
          .back = Mix(p.soft, p.line, 0.5f),
          .line = holds ? colour : Mix(p.paper, colour, 0.6f),
          .ink = p.ink};
}

// An upright gauge: 0 is at its foot, 1 at its top.
void DrawGauge(const Scene& s, ImVec2 centre, const Felt& felt, const Pens& pens) {
  const ImVec2 half(0.5f * kGaugeWidth, 0.5f * kGaugeHeight);
  const auto y_of = [&](float share) { return centre.y + half.y - share * kGaugeHeight; };
  const float radius = half.x;
  s.list->AddRectFilled({centre.x - half.x - 2.0f, centre.y - half.y - 2.0f},
                        {centre.x + half.x + 2.0f, centre.y + half.y + 2.0f}, pens.edge, radius + 2.0f);
  s.list->AddRectFilled({centre.x - half.x, centre.y - half.y}, {centre.x + half.x, centre.y + half.y},
                        pens.back, radius);
  s.list->AddRectFilled({centre.x - half.x, std::min(y_of(felt.high), y_of(felt.low) - 3.0f)},
                        {centre.x + half.x, y_of(felt.low)}, pens.line, radius);
  const float y = y_of(std::clamp(felt.now, 0.0f, 1.0f));
  s.list->AddLine({centre.x - half.x - 4.0f, y}, {centre.x + half.x + 4.0f, y}, pens.ink, 2.0f);
}

// A band around a joint: the limb's directions for which the rule is right. A needle marks the limb.
/// @param before  bands that were drawn before: several joints may be at one place
void DrawAngle(const Scene& s, ImVec2 joint, ImVec2 end, int before, const Felt& felt, const Pens& pens) {
  constexpr float kBand = 9.0f;
  const float length = std::hypot(end.x - joint.x, end.y - joint.y);
  const float radius = std::clamp(0.6f * length, 22.0f, 48.0f) + static_cast<float>(before) * (kBand + 5.0f);
  const float limb = std::atan2(end.y - joint.y, end.x - joint.x);
  // Angles grow counterclockwise, the canvas's own clockwise.
  const auto direction = [&](float share) { return limb - (felt.scale.Of(share) - felt.scale.Of(felt.now)); };
  const float from = direction(felt.high), to = std::max(direction(felt.low), from + 0.05f);
  const auto arc = [&](float width, ImU32 colour) {
    s.list->PathArcTo(joint, radius, from, to, 32);
    s.list->PathStroke(colour, 0, width);
  };
  arc(kBand + 4.0f, pens.edge);
  arc(kBand, pens.line);
  const auto along = [&](float far) {
    return ImVec2(joint.x + far * std::cos(limb), joint.y + far * std::sin(limb));
  };
  s.list->AddLine(along(radius - kBand), along(radius + kBand), pens.edge, 6.0f);
  s.list->AddLine(along(radius - kBand), along(radius + kBand), pens.ink, 2.5f);
}

// A band over the ground: the heights of the centre of mass for which the rule is right.
void DrawHeight(const Scene& s, const Playback::Point& centre, const Felt& felt, const Pens& pens) {
  const double half_m = static_cast<double>(kBandHalf / s.camera.scale);
  const auto ground = static_cast<float>(HeightBelow(s.player.Ground(), centre.x_m));
  const float least = std::max(0.0f, felt.scale.Of(felt.low)),
              most = std::max(least, felt.scale.Of(felt.high));
  const float low = ground + least, high = ground + most;
  const std::array<ImVec2, 4> band = {
      s.camera.ToScreen(centre.x_m - half_m, low), s.camera.ToScreen(centre.x_m + half_m, low),
      s.camera.ToScreen(centre.x_m + half_m, high), s.camera.ToScreen(centre.x_m - half_m, high)};
  s.list->AddConvexPolyFilled(band.data(), 4, Fade(pens.line, felt.holds ? 0.2f : 0.1f));
  s.list->AddLine(band[0], band[1], pens.line, 2.0f);
  s.list->AddLine(band[2], band[3], pens.line, 2.0f);
}

// What a controller with sight sees from below the centre of mass.
struct Gaze {
  double here_m, height_m;  // the ground below the centre of mass
  double sight_m;           // < 0: to the left
};

// A mark where the sight ends: the heights of the ground for which the rule is right.
void DrawAhead(const Scene& s, const Gaze& gaze, const Felt& felt, const Pens& pens) {
  const double x = gaze.here_m + gaze.sight_m;
  const auto at = [&](float share) {
    return s.camera.ToScreen(x, static_cast<float>(gaze.height_m) + felt.scale.Of(share));
  };
  const ImVec2 low = at(felt.low), high = at(felt.high), now = at(std::clamp(felt.now, 0.0f, 1.0f));
  s.list->AddLine(low, high, pens.edge, 9.0f);
  s.list->AddLine(low, high, pens.line, 5.0f);
  s.list->AddLine({now.x - 7.0f, now.y}, {now.x + 7.0f, now.y}, pens.ink, 2.5f);
}

// A band along the ground: where the next corner may be for the rule to be right.
void DrawCorner(const Scene& s, const Gaze& gaze, const Felt& felt, const Pens& pens) {
  const double side = gaze.sight_m < 0.0 ? -1.0 : 1.0;
  const auto at = [&](float share) {
    const double x = gaze.here_m + side * static_cast<double>(felt.scale.Of(share));
    return s.camera.ToScreen(x, static_cast<float>(HeightBelow(s.player.Ground(), x)));
  };
  constexpr float kBelow = 7.0f;
  const auto line = [&](float width, ImU32 colour) {
    constexpr int kPieces = 24;
    for (int i = 0; i <= kPieces; ++i) {
      const ImVec2 p = at(felt.low + (felt.high - felt.low) * static_cast<float>(i) / kPieces);
      s.list->PathLineTo({p.x, p.y + kBelow});
    }
    s.list->PathStroke(colour, 0, width);
  };
  line(9.0f, pens.edge);
  line(5.0f, pens.line);
  const ImVec2 now = at(std::clamp(felt.now, 0.0f, 1.0f));
  s.list->AddLine({now.x, now.y}, {now.x, now.y + 2.0f * kBelow}, pens.ink, 2.5f);
}

// A clock around the centre of mass: the part of the period in which the rule is right.
void DrawTimer(const Scene& s, ImVec2 centre, const Felt& felt, const Pens& pens) {
  constexpr float kRadius = 20.0f;
  constexpr float kTop = -0.5f * kPi32;
  const auto turn = [](float share) { return kTop + 2.0f * kPi32 * share; };
  s.list->AddCircleFilled(centre, kRadius + 5.0f, pens.edge);
  s.list->AddCircle(centre, kRadius, pens.back, 0, 5.0f);
  s.list->PathArcTo(centre, kRadius, turn(felt.low), std::max(turn(felt.high), turn(felt.low) + 0.05f), 32);
  s.list->PathStroke(pens.line, 0, 5.0f);
  const float now = turn(felt.now);
  s.list->AddLine(centre, {centre.x + kRadius * std::cos(now), centre.y + kRadius * std::sin(now)}, pens.ink,
                  2.5f);
}

}  // namespace

void DrawFeltSenses(const Scene& s, const Controller& controller, int rule,
                    std::span<const ImVec2> endpoints) {
  if (controller.kind != ControllerKind::kRules || rule < 0 || rule >= controller.rules) return;
  const Motion& motion = s.player.Shown();
  const Ports& ports = motion.Connections();
  const std::vector<Bar> moved = ActuatorBarsOf(s.player.ShownFigure());
  const auto moment = MomentOf(controller, motion, s.session.Timeline().Selected(), s.player.Frame());
  if (!moment || moment->begins) return;
  const Playback::Point centre = s.player.CentreAt(s.player.TimeS());
  const ImVec2 middle = s.camera.ToScreen(centre.x_m, centre.y_m);
  const ImVec2 raised = RaisedBySoles(s, s.player);
  const auto at = [&](int endpoint) {
    const ImVec2 point = endpoints[static_cast<std::size_t>(endpoint)];
    return ImVec2(point.x + raised.x, point.y + raised.y);
  };
  const float sight_m = SightOf(controller.senses, ports);
  const Gaze gaze{
      .here_m = centre.x_m,
      .height_m = HeightBelow(s.player.Ground(), centre.x_m),
      .sight_m = static_cast<double>(controller.senses.facing == Facing::kLeft ? -sight_m : sight_m)};
  bool centred = false;
  int angles = 0;
  for (int sense = 0; sense < static_cast<int>(moment->senses.size()); ++sense) {
    const Stimulus stimulus = StimulusOf(controller, ports.Count(), rule, sense);
    if (!stimulus.cares) continue;
    const float now = moment->senses[static_cast<std::size_t>(sense)];
    const Felt felt{.low = std::clamp(stimulus.low, 0.0f, 1.0f),
                    .high = std::clamp(stimulus.high, 0.0f, 1.0f),
                    .now = now,
                    .scale = ScaleOf(controller.senses, ports, sense),
                    .holds = now >= stimulus.low && now <= stimulus.high};
    const Pens pens = PensFor(s, rule, felt.holds);
    const SensePlace place = PlaceOf(controller.senses.kind, ports.Count(), sense);
    switch (felt.scale.quantity) {
      case SenseQuantity::kAngle: {
        const Bar& limb = moved[static_cast<std::size_t>(place.index)];
        DrawAngle(s, at(limb.from), at(limb.to), angles++, felt, pens);
        break;
      }
      case SenseQuantity::kLength: {
        const Bar& muscle = moved[static_cast<std::size_t>(place.index)];
        const ImVec2 from = at(muscle.from), to = at(muscle.to);
        DrawGauge(s, {0.5f * (from.x + to.x) + 8.0f, 0.5f * (from.y + to.y) - 0.5f * kGaugeHeight}, felt,
                  pens);
        break;
      }
      case SenseQuantity::kForce:
        DrawGauge(s, {at(place.index).x + 16.0f, at(place.index).y - 0.5f * kGaugeHeight}, felt, pens);
        break;
      case SenseQuantity::kHeight:
        DrawHeight(s, centre, felt, pens);
        centred = true;
        break;
      case SenseQuantity::kVelocity:
        DrawGauge(s, {middle.x + 22.0f, middle.y}, felt, pens);
        centred = true;
        break;
      case SenseQuantity::kAhead:
        DrawAhead(s, gaze, felt, pens);
        break;
      case SenseQuantity::kCorner:
        DrawCorner(s, gaze, felt, pens);
        break;
      case SenseQuantity::kTime:
        DrawTimer(s, middle, felt, pens);
        break;
    }
  }
  if (!centred) return;
  s.list->AddCircleFilled(middle, 6.0f, s.ui.Ink().paper);
  s.list->AddCircleFilled(middle, 4.5f, s.ui.Look().Rule(rule));
}

}  // namespace gaitsmith::shell
