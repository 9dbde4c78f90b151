// SPDX-License-Identifier: MIT
#include "core/document/timeline_edit.h"

#include <algorithm>

#include "core/rollout/mirror_image.h"

namespace gaitsmith {

namespace {

Result<void> CheckClip(const Document& d, int clip) {
  if (clip >= 0 && clip < static_cast<int>(d.timeline.size())) return {};
  return Fail(
      ErrorCode::kOutOfRange, "timeline",
      "there is no clip " + std::to_string(clip) + ", there are " + std::to_string(d.timeline.size()));
}

// Sets the timeline to clips one after another, if they fit the limits.
Result<void> Put(Document& d, const std::vector<Stretch>& stretches) {
  if (stretches.empty()) return Fail(ErrorCode::kStructure, "", "a timeline needs at least one clip");
  if (stretches.size() > static_cast<std::size_t>(kMaxClips)) {
    return Fail(ErrorCode::kTooMany, "",
                "at most " + std::to_string(kMaxClips) + " clips, there would be " +
                    std::to_string(stretches.size()));
  }
  std::int64_t all = 0;
  for (const Stretch& stretch : stretches) all += stretch.steps;
  if (all > kMaxSteps) {
    return Fail(ErrorCode::kTooMany, "",
                "at most " + std::to_string(kMaxSteps / 100) + " s, there would be " +
                    std::to_string(all / 100) + " s");
  }
  d.timeline.clear();
  int start = 0;
  for (const Stretch& stretch : stretches) {
    d.timeline.push_back({.controller = stretch.controller, .start_step = start});
    start += stretch.steps;
  }
  d.duration_steps = start;
  return {};
}

bool Same(const Controller& a, const Controller& b) {
  return a.name == b.name && a.kind == b.kind && a.rules == b.rules && a.senses == b.senses &&
         a.genes == b.genes;
}

}  // namespace

std::vector<Stretch> StretchesOf(const Document& d) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < d.timeline.size(); ++i) {
    const int steps = std::min(EndOf(d, i), d.duration_steps) - d.timeline[i].start_step;
    stretches.push_back({d.timeline[i].controller, steps > 0 ? steps : kShortestClip});
  }
  return stretches;
}

int ClipAt(const Document& d, int step) {
  const auto after = std::ranges::upper_bound(d.timeline, step, {}, &Clip::start_step);
  return std::max(0, static_cast<int>(after - d.timeline.begin()) - 1);
}

Result<void> MoveSwitch(Document& d, int clip, int step) {
  if (auto fine = CheckClip(d, clip); !fine) return fine;
  if (clip == 0) return Fail(ErrorCode::kOutOfRange, "", "the first clip begins with the motion");
  const auto i = static_cast<std::size_t>(clip);
  const int low = d.timeline[i - 1].start_step + kShortestClip;
  const int high = EndOf(d, i) - kShortestClip;
  if (low <= high) d.timeline[i].start_step = std::clamp(step, low, high);
  return {};
}

Result<void> SetClipLength(Document& d, int clip, int steps) {
  if (auto fine = CheckClip(d, clip); !fine) return fine;
  auto stretches = StretchesOf(d);
  stretches[static_cast<std::size_t>(clip)].steps = std::clamp(steps, kShortestClip, kMaxSteps);
  return Put(d, stretches);
}

Result<void> SplitClip(Document& d, int step) {
  if (d.timeline.empty()) return Fail(ErrorCode::kStructure, "", "there is no clip to split");
  const int clip = ClipAt(d, step);
  const auto i = static_cast<std::size_t>(clip);
  auto stretches = StretchesOf(d);
  const int before = step - d.timeline[i].start_step;
  const int behind = stretches[i].steps - before;
  if (before < kShortestClip || behind < kShortestClip) {
    return Fail(ErrorCode::kOutOfRange, "",
                "both parts of a clip must last at least 0.2 s, and this is too close to its end");
  }
  stretches[i].steps = before;
  stretches.insert(stretches.begin() + clip + 1, {d.timeline[i].controller, behind});
  return Put(d, stretches);
}

Result<void> RemoveClip(Document& d, int clip) {
  if (auto fine = CheckClip(d, clip); !fine) return fine;
  auto stretches = StretchesOf(d);
  stretches.erase(stretches.begin() + clip);
  return Put(d, stretches);
}

Result<void> DuplicateClip(Document& d, int clip) {
  if (auto fine = CheckClip(d, clip); !fine) return fine;
  auto stretches = StretchesOf(d);
  stretches.insert(stretches.begin() + clip, stretches[static_cast<std::size_t>(clip)]);
  return Put(d, stretches);
}

Result<void> ReorderClip(Document& d, int clip, int to) {
  if (auto fine = CheckClip(d, clip); !fine) return fine;
  auto stretches = StretchesOf(d);
  const int place = std::clamp(to, 0, static_cast<int>(stretches.size()) - 1);
  const Stretch taken = stretches[static_cast<std::size_t>(clip)];
  stretches.erase(stretches.begin() + clip);
  stretches.insert(stretches.begin() + place, taken);
  return Put(d, stretches);
}

Result<void> InsertClips(Document& d, const std::vector<Stretch>& given, int step) {
  std::vector<Stretch> inserted = given;
  for (Stretch& stretch : inserted) {
    if (stretch.controller < 0 || stretch.controller >= static_cast<int>(d.controllers.size())) {
      return Fail(ErrorCode::kOutOfRange, "timeline",
                  "there is no controller " + std::to_string(stretch.controller));
    }
    stretch.steps = std::clamp(stretch.steps, kShortestClip, kMaxSteps);
  }
  auto stretches = StretchesOf(d);
  if (stretches.empty()) return Put(d, inserted);
  const int clip = ClipAt(d, std::clamp(step, 0, d.duration_steps - 1));
  const auto i = static_cast<std::size_t>(clip);
  const int before = step - d.timeline[i].start_step;
  const int behind = stretches[i].steps - before;
  // A rest that is too short to be a clip stays with its clip.
  if (before < kShortestClip) {
    stretches.insert(stretches.begin() + clip, inserted.begin(), inserted.end());
  } else {
    if (behind >= kShortestClip) {
      stretches[i].steps = before;
      inserted.push_back({d.timeline[i].controller, behind});
    }
    stretches.insert(stretches.begin() + clip + 1, inserted.begin(), inserted.end());
  }
  return Put(d, stretches);
}

Result<void> LoopTimeline(Document& d, int times) {
  if (times < 2 || times > 100)
    return Fail(ErrorCode::kOutOfRange, "times", "must be from 2 to 100, is " + std::to_string(times));
  const auto once = StretchesOf(d);
  std::vector<Stretch> all;
  for (int i = 0; i < times; ++i) all.insert(all.end(), once.begin(), once.end());
  return Put(d, all);
}

Result<void> MirrorClip(Document& d, int clip) {
  if (auto fine = CheckClip(d, clip); !fine) return fine;
  Clip& mirrored = d.timeline[static_cast<std::size_t>(clip)];
  auto image = MirrorImageOf(d.controllers[static_cast<std::size_t>(mirrored.controller)], d.figure);
  if (!image) return std::unexpected(image.error());
  const auto added = AddController(d, *image);
  if (!added) return std::unexpected(added.error());
  mirrored.controller = *added;
  return {};
}

Result<int> AddController(Document& d, const Controller& controller) {
  const auto known =
      std::ranges::find_if(d.controllers, [&](const Controller& c) { return Same(c, controller); });
  if (known != d.controllers.end()) return static_cast<int>(known - d.controllers.begin());
  if (d.controllers.size() >= static_cast<std::size_t>(kMaxControllers)) {
    return Fail(ErrorCode::kTooMany, "",
                "at most " + std::to_string(kMaxControllers) + " controllers, and all are in use");
  }
  d.controllers.push_back(controller);
  return static_cast<int>(d.controllers.size()) - 1;
}

namespace {

bool IsUsed(const Document& d, int controller) {
  const auto names = [controller](const auto& one) { return one.controller == controller; };
  return std::ranges::any_of(d.timeline, names) || std::ranges::any_of(d.search.handovers, names) ||
         d.search.start == controller;
}

template <class MayGo>
void DropUnused(Document& d, MayGo may_go) {
  for (int c = static_cast<int>(d.controllers.size()) - 1; c >= 0; --c) {
    if (IsUsed(d, c) || !may_go(c)) continue;
    d.controllers.erase(d.controllers.begin() + c);
    const auto follow = [c](int& index) { index -= index > c ? 1 : 0; };
    for (Clip& clip : d.timeline) follow(clip.controller);
    for (Handover& handover : d.search.handovers) follow(handover.controller);
    follow(d.search.start);
  }
}

}  // namespace

void DropUnusedControllers(Document& d) {
  DropUnused(d, [](int) { return true; });
}

void DropUnusedControllers(Document& d, std::span<const Clip> before) {
  DropUnused(d, [before](int controller) {
    return std::ranges::any_of(before, [controller](const Clip& c) { return c.controller == controller; });
  });
}

}  // namespace gaitsmith
