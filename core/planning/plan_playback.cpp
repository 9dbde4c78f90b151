// SPDX-License-Identifier: MIT
#include "core/planning/plan_playback.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/document/recording.h"
#include "core/planning/plan_flight.h"

namespace gaitsmith {

namespace {

constexpr int kMostCorrections = 16, kMostFineCorrections = 10;
/// Of the solver, for all corrections: what is so hard to plan again is not worth more.
constexpr int kMostIterations = 800;
/// A miss with which one trajectory is enough; else several, one after another, with more knots [m].
constexpr double kGoodM = 0.01;
constexpr int kClipSteps = 50;
/// A miss that is as good as none [m].
constexpr double kCloseM = 0.002;
/// A flight that differs more from the planned one is corrected alone [m].
constexpr double kAstrayM = 0.02;
/// A little less than the whole miss, so that corrections do not swing around the mark.
constexpr double kShare = 0.9;

/// A trajectory after a planned motion, and where it gets.
struct Played {
  Document document;
  std::vector<PlannedMotion::Vector> misses;  // of every place of every keyframe [m]
  std::vector<Course> courses;                // by how much each flight differs from the planned one
  double astray_m = 0.0;                      // the greatest of these differences
  double worst_m = 0.0;                       // see PlanPlayback
};

/// What is wished for in place of what was asked for.
struct Wishes {
  Plan plan;
  std::vector<Course> courses;  // of its flights
  std::vector<double> aims_m;   // by how much farther than planned each flight shall be in its middle
};

/// Plays what is asked for.
class Player {
 public:
  /// @param planned as it was asked for
  /// @param clips   number of trajectories, one after another
  /// @param flights whose courses are corrected, too; none: only marks are
  Player(const Document& document, const PlannedMotion& planned, int clips, std::vector<Flight> flights)
      : document_(document), planned_(planned), clips_(clips), flights_(std::move(flights)) {
    for (const Flight& flight : flights_) courses_.push_back(CourseOf(flight, planned));
  }

  /// @param planned with these wishes
  [[nodiscard]] Played Play(const PlannedMotion& planned, const Wishes& wishes) const {
    Played played{
        WithTrajectories(document_, "planned", AnglesOf(planned), kMaxRules, clips_).document, {}, {}};
    Document shown = played.document;
    shown.duration_steps = std::max(document_.duration_steps, document_.plan.steps);
    const Motion motion = Simulate(shown);
    const auto length_m = static_cast<double>(PortsOf(motion.Bones()).length_m);
    const auto turned = [&](int step) {
      return motion.At(step).turn_rad - static_cast<double>(motion.Bones().start_angle_rad);
    };
    for (const Keyframe& keyframe : document_.plan.keyframes) {
      if (keyframe.turned)
        played.worst_m =
            std::max(played.worst_m,
                     length_m * std::abs(turned(keyframe.step) - static_cast<double>(keyframe.turn_rad)));
      for (const Mark& mark : keyframe.marks) {
        const PlannedMotion::Vector miss = MissOf(motion, keyframe.step, mark);
        played.misses.push_back(miss);
        played.worst_m = std::max(played.worst_m, std::sqrt(miss.x * miss.x + miss.y * miss.y));
      }
    }
    for (std::size_t i = 0; i < flights_.size(); ++i) {
      const Motion::Frame& middle = motion.At(flights_[i].middle);
      const Course missed{{middle.x_m - courses_[i].middle.x - wishes.aims_m[i],
                           static_cast<double>(middle.y_m) - courses_[i].middle.y},
                          flights_[i].lies ? 0.0 : turned(flights_[i].landing) - courses_[i].turn};
      played.courses.push_back(missed);
      played.astray_m = std::max({played.astray_m, std::abs(missed.middle.x), std::abs(missed.middle.y),
                                  length_m * std::abs(missed.turn)});
    }
    return played;
  }

  /// Moves wishes against what was missed: while it flies astray, only those for flights.
  void Correct(const Played& missed, double share, Wishes& wishes) const {
    for (std::size_t i = 0; i < flights_.size(); ++i) {
      wishes.courses[i].middle.x -= share * missed.courses[i].middle.x;
      wishes.courses[i].middle.y -= share * missed.courses[i].middle.y;
      wishes.courses[i].turn -= share * missed.courses[i].turn;
    }
    if (Astray(missed)) return;
    std::size_t at = 0;
    for (Keyframe& keyframe : wishes.plan.keyframes) {
      std::size_t flown = 0;  // flights before it
      while (flown < flights_.size() && flights_[flown].landing <= keyframe.step) ++flown;
      for (Mark& mark : keyframe.marks) {
        const PlannedMotion::Vector& miss = missed.misses[at++];
        if (flown == 0) {
          mark.x_m -= static_cast<float>(share * miss.x);
          mark.y_m -= static_cast<float>(share * miss.y);
          continue;
        }
        // Where it stands after a flight was decided when that began; in the middle it is half as far.
        wishes.aims_m[flown - 1] -= 0.5 * share * miss.x;
        wishes.courses[flown - 1].middle.x -= 0.5 * share * miss.x;
      }
    }
  }
  /// Whether its marks say nothing yet.
  [[nodiscard]] static bool Astray(const Played& played) { return played.astray_m > kAstrayM; }
  [[nodiscard]] static bool Better(const Played& now, const Played& before) {
    if (Astray(before)) return now.astray_m < before.astray_m;
    return !Astray(now) && now.worst_m < before.worst_m;
  }

  [[nodiscard]] PlanScene SceneOf(const Wishes& wishes) const {
    PlanScene scene = planned_.Scene();
    scene.plan = wishes.plan;
    std::vector<Keyframe>& keyframes = scene.plan.keyframes;
    const auto add = [&](const Keyframe& keyframe) {
      keyframes.insert(std::ranges::upper_bound(keyframes, keyframe.step, {}, &Keyframe::step), keyframe);
    };
    for (std::size_t i = 0; i < flights_.size(); ++i) {
      const Course& course = wishes.courses[i];
      add({.step = flights_[i].middle,
           .marks = {
               {.x_m = static_cast<float>(course.middle.x), .y_m = static_cast<float>(course.middle.y)}}});
      if (!flights_[i].lies)
        add({.step = flights_[i].landing, .turned = true, .turn_rad = static_cast<float>(course.turn)});
    }
    return scene;
  }
  [[nodiscard]] Wishes Asked() const { return {document_.plan, courses_, std::vector(flights_.size(), 0.0)}; }

 private:
  /// Of all joints at all steps. What corrects a flight must not change how it lands: the joints go over to
  /// the motion that was asked for while the figure flies, and back where it stands before the next flight.
  [[nodiscard]] std::vector<float> AnglesOf(const PlannedMotion& corrected) const {
    std::vector<float> angles;
    for (int step = 0; step <= planned_.Scene().plan.steps; ++step) {
      const double time_s = step * static_cast<double>(kStep), share = ShareOfAsked(step);
      const PlannedMotion::Instant asked = planned_.At(time_s), other = corrected.At(time_s);
      for (std::size_t j = 0; j < asked.angle_rad.size(); ++j)
        angles.push_back(
            static_cast<float>(other.angle_rad[j] + share * (asked.angle_rad[j] - other.angle_rad[j])));
    }
    return angles;
  }
  [[nodiscard]] double ShareOfAsked(int step) const {
    const auto ease = [](int now, int from, int to) {
      const double t = std::clamp(static_cast<double>(now - from) / std::max(1, to - from), 0.0, 1.0);
      return t * t * (3.0 - 2.0 * t);
    };
    double share = 0.0;
    for (std::size_t i = 0; i < flights_.size(); ++i) {
      if (step > flights_[i].start) share = ease(step, flights_[i].start, flights_[i].landing);
      if (i + 1 < flights_.size() && step > flights_[i].landing)
        share = 1.0 - ease(step, flights_[i].landing, flights_[i + 1].start);
    }
    return share;
  }
  static PlannedMotion::Vector MissOf(const Motion& motion, int step, const Mark& mark) {
    const Motion::Frame& frame = motion.At(step);
    double x = frame.x_m, y = static_cast<double>(frame.y_m);
    if (mark.endpoint != kCentreOfMass) {
      const Motion::Point arm = motion.Endpoint(step, mark.endpoint);
      x += static_cast<double>(arm.x);
      y += static_cast<double>(arm.y);
    }
    return {mark.axes == MarkAxes::kUp ? 0.0 : x - static_cast<double>(mark.x_m),
            mark.axes == MarkAxes::kAlong ? 0.0 : y - static_cast<double>(mark.y_m)};
  }

  const Document& document_;
  const PlannedMotion& planned_;
  int clips_;
  std::vector<Flight> flights_;
  std::vector<Course> courses_;  // as planned
};

/// Plays a motion, and plans it again against what was missed.
PlanPlayback Follow(const Player& player, const PlannedMotion& planned, int most, const PlanWatch& watch) {
  Wishes nearest = player.Asked();  // whose motion is played best
  Played best = player.Play(planned, nearest);
  PlanPlayback playback;
  playback.first_m = best.worst_m;
  double share = kShare;
  int iterations = 0;
  std::optional<PlannedMotion> from;
  for (int i = 0; i < most && best.worst_m > kCloseM && iterations < kMostIterations; ++i) {
    Wishes wishes = nearest;
    player.Correct(best, share, wishes);
    PlanAnswer answer = SolvePlan(player.SceneOf(wishes), planned.Grid(), from ? &*from : &planned, watch);
    if (answer.cancelled) break;
    iterations += answer.iterations;
    Played played = answer.motion ? player.Play(*answer.motion, wishes) : Played{};
    if (!answer.motion || !Player::Better(played, best)) {
      share *= 0.5;  // too far
      continue;
    }
    share = kShare;
    nearest = std::move(wishes);
    best = std::move(played);
    from = std::move(answer.motion);
    playback.corrections = i + 1;
  }
  playback.miss_m = best.worst_m;
  playback.document = WithSolution(best.document, planned);
  return playback;
}

}  // namespace

PlanPlayback PlayPlan(const Document& document, const PlannedMotion& planned, const PlanWatch& watch) {
  PlanPlayback played = Follow({document, planned, 1, {}}, planned, kMostCorrections, watch);
  if (played.miss_m <= kGoodM) return played;
  const int clips = 1 + document.plan.steps / kClipSteps;
  PlanPlayback finer =
      Follow({document, planned, clips, FlightsOf(planned.Scene())}, planned, kMostFineCorrections, watch);
  finer.first_m = played.first_m;
  return finer.miss_m < played.miss_m ? finer : played;
}

Document WithSolution(const Document& document, const PlannedMotion& planned) {
  Document solved = document;
  solved.plan.solved = {planned.Grid().degree, planned.Grid().pieces_per_second, {}};
  for (const double value : planned.Unknowns())
    solved.plan.solved.unknowns.push_back(static_cast<float>(value));
  return solved;
}

PlannedMotion SolvedMotion(const Document& document) {
  const PlanSolution& solved = document.plan.solved;
  const std::vector<double> unknowns(solved.unknowns.begin(), solved.unknowns.end());
  return {SceneOf(document), {solved.degree, solved.pieces_per_second}, unknowns};
}

}  // namespace gaitsmith
