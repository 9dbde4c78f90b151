// SPDX-License-Identifier: MIT
#include "core/gait/document_loop.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/hundredths.h"

namespace gaitsmith {

namespace {

/// How long a controller runs on, and how much of that is looked at, as it needs a while to settle [steps].
constexpr int kRunOn = 4000, kLookedAt = 3000;
/// The part of a clip in which its motion may settle.
constexpr int kSettling = 4;

/// Where a clip ends within the motion: later clips may begin after its end.
int EndWithin(const Document& document, int clip) {
  return std::min(EndOf(document, static_cast<std::size_t>(clip)), document.duration_steps);
}

int LongestClip(const Document& document) {
  int longest = -1, steps = 0;
  for (std::size_t clip = 0; clip < document.timeline.size(); ++clip) {
    const int lasts = EndWithin(document, static_cast<int>(clip)) - document.timeline[clip].start_step;
    if (lasts <= steps) continue;
    steps = lasts;
    longest = static_cast<int>(clip);
  }
  return longest;
}

/// The last push between two steps; the first of them if there is none.
int LastPush(const Document& document, int from, int to) {
  int last = from;
  for (const Push& push : document.pushes) {
    if (push.step >= from && push.step < to) last = push.step;
  }
  return last;
}

Result<ClosedLoop> LoopIn(const Document& document, const Motion& motion, int first, int last, bool halves) {
  const auto cycle = FindCycle(motion, std::max(first, 1), last, halves);
  if (!cycle) return std::unexpected(cycle.error());
  ClosedLoop loop = CloseLoop(motion, *cycle);
  if (!document.environment.ground.empty() &&
      std::abs(loop.distance_m) > kMostSeam * static_cast<double>(motion.Bones().longest_rod_m)) {
    return Fail(ErrorCode::kMissing, "", "the ground is drawn, so what is under the figure does not repeat");
  }
  if (loop.slide_rods > kMostSeam) {
    return Fail(
        ErrorCode::kMissing, "",
        "its cycles differ: closing one would slide a standing foot by " +
            InHundredths(100.0 * loop.slide_rods) +
            (document.figure.HasSprings() ? " % of the longest spring (" : " % of the longest rod (") +
            InHundredths(100.0 * kMostSeam) + " % at most)");
  }
  return loop;
}

}  // namespace

Result<DocumentLoop> ShownLoopOf(const Document& document, const Motion& motion, bool halves) {
  const int clip = LongestClip(document);
  if (clip < 0) return Fail(ErrorCode::kMissing, "", "the document has no controller");
  const int start = document.timeline[static_cast<std::size_t>(clip)].start_step;
  const int end = EndWithin(document, clip);
  const int pushed = LastPush(document, start, end);
  auto loop = LoopIn(document, motion, pushed + (end - pushed) / kSettling, end, halves);
  if (!loop) return std::unexpected(loop.error());
  return DocumentLoop{.loop = std::move(*loop)};
}

Result<DocumentLoop> LoopOf(const Document& document, const Motion& motion, bool halves) {
  auto shown = ShownLoopOf(document, motion, halves);
  const int clip = LongestClip(document);
  if (shown || clip < 0) return shown;
  const int end = EndWithin(document, clip);
  if (motion.TermsAt(end).broke_physics) return shown;

  Document longer = document;
  longer.timeline.resize(static_cast<std::size_t>(clip) + 1);
  longer.duration_steps = std::min(end + kRunOn, kMaxSteps);
  std::erase_if(longer.pushes, [end](const Push& push) { return push.step >= end; });
  const Motion on = Simulate(longer);
  auto later =
      LoopIn(longer, on, std::max(end, longer.duration_steps - kLookedAt), longer.duration_steps, halves);
  if (!later) return std::unexpected(later.error());
  return DocumentLoop{.loop = std::move(*later), .ran_on = true};
}

Motion RecordLoop(const Document& document, const ClosedLoop& loop, bool in_place) {
  std::vector<KinematicFrame> frames = loop.frames;
  const double begins_m = frames.front().posture.x_m;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    double way_m = document.environment.ground.empty() ? begins_m : 0.0;
    if (in_place) way_m += loop.distance_m * static_cast<double>(i) / loop.Steps();
    frames[i].posture.x_m -= way_m;
  }
  return RecordKinematic(ScriptOf(document), frames);
}

}  // namespace gaitsmith
