// SPDX-License-Identifier: MIT
// The height shows the score, the colour the verdict: a single hue, pale, middling or strong, readable for
// people who cannot distinguish hues.
#include "shell/timeline/transition_strip.h"

#include <algorithm>
#include <cmath>

#include "shell/timeline/timeline.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kStripHeight = 22.0f;
constexpr float kAbove = 4.0f;  // gap between clips and strip
constexpr float kStepS = kStep;

/// Maps steps and shares to the canvas.
struct Strip {
  ImRect rect;  // area of the whole motion
  float steps;
  [[nodiscard]] float XOf(float step) const {
    return rect.Min.x + std::clamp(step / steps, 0.0f, 1.0f) * rect.GetWidth();
  }
  [[nodiscard]] float YOf(float share) const {
    return rect.Max.y - 1.0f - std::clamp(share, 0.0f, 1.0f) * (rect.GetHeight() - 5.0f);
  }
  /// Extends halfway to the previous and the next moment.
  [[nodiscard]] ImRect CellOf(int step) const {
    constexpr float kHalf = 0.5f * kMomentSpacing;
    const auto middle = static_cast<float>(step);
    return {{XOf(middle - kHalf), rect.Min.y}, {XOf(middle + kHalf), rect.Max.y}};
  }
};

std::string SecondsOf(int step) { return Fixed(static_cast<float>(step) * kStepS, 2); }

std::string TransitionWords(const Session& session) {
  const TransitionScores& map = session.Timeline().Transitions().Scores();
  const int best = map.Best();
  if (best < 0) return map.Failed() ? Tr("no data") : Tr("not computed yet");
  const std::string when = SecondsOf(map.Steps()[static_cast<std::size_t>(best)]);
  const int percent = PercentOf(map.Share(best).value_or(0.0f));
  const auto count = static_cast<int>(map.Steps().size());
  if (map.Known() < count) {
    return Tr("{1} of {2} moments tried, best so far at {3} s: {4} % of its usual score", map.Known(), count,
              when, percent);
  }
  const float now = session.Timeline().Transitions().ShareAtStart().value_or(0.0f);
  return Tr("best at {1} s: {2} % of its usual score, now {3} % ({4})", when, percent, PercentOf(now),
            VerdictWords(now));
}

/// Hatching over moments whose score is not known yet.
void DrawHatch(const Ui& ui, const ImRect& area) {
  constexpr float kSpacing = 6.0f;
  ImDrawList* list = ui.Canvas();
  list->PushClipRect(area.Min, area.Max, true);
  const float height = area.GetHeight();
  const ImU32 colour = Mix(ui.Ink().soft, ui.Ink().second_ink, 0.4f);
  // The lines' positions do not depend on the area, so that neighbouring areas match.
  for (float x = std::floor((area.Min.x - height) / kSpacing) * kSpacing; x < area.Max.x; x += kSpacing)
    list->AddLine({x, area.Max.y}, {x + height, area.Min.y}, colour);
  list->PopClipRect();
}

void DrawShares(const Ui& ui, const TransitionScores& map, const Strip& strip) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  const auto count = static_cast<int>(map.Steps().size());
  for (int i = 0; i < count; ++i) {
    ImRect cell = strip.CellOf(map.Steps()[static_cast<std::size_t>(i)]);
    const auto share = map.Share(i);
    if (!share) {
      for (; i + 1 < count && !map.Share(i + 1); ++i)
        cell.Add(strip.CellOf(map.Steps()[static_cast<std::size_t>(i) + 1]));
      DrawHatch(ui, cell);
      continue;
    }
    cell.Min.x = ui.Look().Snap(cell.Min.x);  // avoids seams
    cell.Max.x = ui.Look().Snap(cell.Max.x);
    const float top = strip.YOf(*share);
    const Takeover verdict = VerdictOn(*share);
    const float tint = verdict == Takeover::kGood ? 0.9f : verdict == Takeover::kFair ? 0.5f : 0.22f;
    const ImU32 fill = Mix(p.soft, p.accent, tint);
    list->AddRectFilled({cell.Min.x, top}, cell.Max, fill);
    list->AddRectFilled({cell.Min.x, top - 0.5f}, {cell.Max.x, top + 1.0f}, p.accent);
  }
}

/// A line at the clip's present start and a dot at the best moment.
void DrawMarks(const Ui& ui, const Session& session, const Strip& strip) {
  const TransitionScores& map = session.Timeline().Transitions().Scores();
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  const auto selected = static_cast<std::size_t>(session.Timeline().Selected());
  const float now =
      ui.Look().Snap(strip.XOf(static_cast<float>(session.Doc().timeline[selected].start_step)));
  list->AddRectFilled({now - 2.0f, strip.rect.Min.y}, {now + 2.0f, strip.rect.Max.y}, p.panel);
  list->AddRectFilled({now - 1.0f, strip.rect.Min.y}, {now + 1.0f, strip.rect.Max.y}, p.ink);
  if (map.Best() < 0) return;
  const float best = strip.XOf(static_cast<float>(map.Steps()[static_cast<std::size_t>(map.Best())]));
  const ImVec2 centre(best, strip.rect.Min.y + 6.0f);
  list->AddCircleFilled(centre, 6.0f, p.panel);
  list->AddCircleFilled(centre, 4.0f, p.ink);
}

}  // namespace

std::string VerdictWords(float share) {
  switch (VerdictOn(share)) {
    case Takeover::kGood:
      return Tr("good");
    case Takeover::kFair:
      return Tr("fair");
    case Takeover::kPoor:
      return Tr("poor");
  }
  return {};
}

// Clamps the share: near a usual score of 0, shares are meaninglessly large.
int PercentOf(float share) { return static_cast<int>(std::lround(100.0f * std::clamp(share, 0.0f, 9.99f))); }

float TransitionStripHeight(const Session& session) {
  // Reserve the space before the strip appears, so that nothing moves under the pointer.
  return session.Doc().timeline.size() > 1 ? kAbove + kStripHeight : 0.0f;
}

void DrawTransitionStrip(Ui& ui, const Session& session, const ImRect& clips) {
  const TransitionScores& map = session.Timeline().Transitions().Scores();
  if (!map.Any()) return;
  const float top = clips.Max.y + kAbove;
  const Strip strip{.rect = {{clips.Min.x, top}, {clips.Max.x, top + kStripHeight}},
                    .steps = static_cast<float>(session.Doc().duration_steps)};
  const ImRect area(strip.CellOf(map.Steps().front()).Min, strip.CellOf(map.Steps().back()).Max);
  const Touch touch = ui.Area("timeline/transitions", area, Grab::kDrag,
                              {.label = Tr("Transition map of clip {1}", session.Timeline().Selected() + 1),
                               .role = "img",
                               .value = TransitionWords(session)});
  ui.Canvas()->AddRectFilled(area.Min, area.Max, ui.Ink().soft);
  DrawShares(ui, map, strip);
  DrawMarks(ui, session, strip);
  ui.DrawFocus(touch, area, 2.0f);
  if (!touch.hovered && !touch.held) return;
  const float x = std::clamp(ImGui::GetIO().MousePos.x, area.Min.x, area.Max.x);
  const int index =
      map.Nearest(static_cast<int>((x - strip.rect.Min.x) / strip.rect.GetWidth() * strip.steps));
  if (const auto share = map.Share(index)) {
    const std::string when = SecondsOf(map.Steps()[static_cast<std::size_t>(index)]);
    DrawBubble(ui, x, clips, top, Tr("{1} s: {2} %, {3}", when, PercentOf(*share), VerdictWords(*share)));
  }
}

}  // namespace gaitsmith::shell
