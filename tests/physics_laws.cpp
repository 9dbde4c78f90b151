// SPDX-License-Identifier: MIT
#include "tests/physics_laws.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <vector>

#include "core/physics/limb_guard.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/models.h"
#include "core/world/environment.h"
#include "tests/limb_motion.h"
#include "tests/spring_laws.h"

namespace gaitsmith::test {

namespace {

constexpr std::array<LawLimit, kLaws> kLawLimits = {{
    {"finite", "numbers", 0.0},
    {"joint limits", "rad", 0.0},
    {"above ground", "reach", 2e-6},
    {"push", "m/s", 0.0},
    {"cone", "share", 1e-6},
    {"momentum", "share", 1e-6},
    {"flight", "share", 0.0},
    {"moment", "reach + way", 1.0},
    {"still energy", "M g l + E", 0.1},
    {"still gain", "(M g l + E)/s", 1.0},
    {"ground work", "M g l + E", 0.1},
    {"ground gain", "(M g l + E)/s", 1.0},
    {"lifting", "m/s", 2.0},
    {"limb work", "M g l + E", 0.0},
    {"limb gain", "(M g l + E)/s", 0.0},
    {"turning", "share", 0.0},
}};

/// What differs in model 2.
constexpr std::array<LawLimit, kLaws> LimbLawLimits() {
  std::array<LawLimit, kLaws> limits = kLawLimits;
  const auto set = [&](Law law, double most) { limits[static_cast<std::size_t>(law)].most = most; };
  set(Law::kJointLimits, static_cast<double>(kMaxStopSlack));  // stops give way, and a guard trips
  // The judge takes a figure for one rigid body. What a blow to an endpoint does to its limbs is not taken
  // off, so this is more than the ground really adds.
  set(Law::kGroundWork, 0.5);
  set(Law::kLimbWork, 0.1);
  set(Law::kLimbGain, 1.0);
  // All of it, so nothing is promised: a step whose rounds run out (docs/physics.md) may end with other
  // momenta than its limbs' motion has. The worst is measured all the same.
  set(Law::kTurning, 1.0);
  return limits;
}
constexpr std::array<LawLimit, kLaws> kLimbLawLimits = LimbLawLimits();

/// What differs in model 3. Momenta of single nodes may be far greater than their sum.
constexpr std::array<LawLimit, kLaws> SpringLawLimits() {
  std::array<LawLimit, kLaws> limits = kLawLimits;
  limits[static_cast<std::size_t>(Law::kMomentum)].most = 1e-4;
  limits[static_cast<std::size_t>(Law::kCone)].most = 1e-5;
  return limits;
}
constexpr std::array<LawLimit, kLaws> kSpringLawLimits = SpringLawLimits();

/// Rounding error of a sum of single-precision numbers, as a share of the summands.
constexpr double kRounding = 4.8e-7;  // 2^-21

struct Vector {
  double x = 0.0, y = 0.0;
  Vector operator+(Vector other) const { return {x + other.x, y + other.y}; }
  Vector operator-(Vector other) const { return {x - other.x, y - other.y}; }
  Vector operator*(double by) const { return {x * by, y * by}; }
  [[nodiscard]] double Dot(Vector other) const { return x * other.x + y * other.y; }
  [[nodiscard]] double Cross(Vector other) const { return x * other.y - y * other.x; }
  [[nodiscard]] double Length() const { return std::sqrt(x * x + y * y); }
};
Vector Wide(Motion::Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// Judges one motion.
class Trial {
 public:
  Trial(const Document& document, const Motion& motion)
      : document_(document),
        motion_(motion),
        limbs_(document, motion),
        step_s_(static_cast<double>(motion.StepS())) {
    offences_.model = document.model;
    const Skeleton& bones = motion.Bones();
    mass_kg_ = static_cast<double>(bones.mass_kg);
    for (int rod = 0; rod < bones.rods; ++rod)
      reach_m_ += static_cast<double>(bones.limbs[static_cast<std::size_t>(rod)].length_m);
    unit_j_ = EnergyUnit(bones);
  }

  Offences Judge() {
    JudgeFrame(0);
    for (frame_ = 1; frame_ < motion_.Frames() && !motion_.TermsAt(frame_).broke_physics; ++frame_) {
      JudgeFrame(frame_);
      JudgeStep();
    }
    offences_.judged = frame_;
    // Rates are judged over at least one second, so that one bad step does not count as a bad second.
    const double seconds = std::max(1.0, (frame_ - 1) * step_s_);
    Offend(Law::kStillGain, still_gain_ / seconds);
    Offend(Law::kGroundGain, ground_gain_ / seconds);
    Offend(Law::kLifting, lifted_m_ / seconds);
    Offend(Law::kLimbGain, limb_gain_ / seconds);
    return offences_;
  }

 private:
  void Offend(Law law, double by) {
    Offence& worst = offences_.of[static_cast<std::size_t>(law)];
    if (std::isnan(by)) by = std::numeric_limits<double>::infinity();
    if (by > worst.by) worst = {by, frame_};
  }

  [[nodiscard]] Vector Middle(int frame) const {
    const Motion::Frame& f = motion_.At(frame);
    return {f.x_m, static_cast<double>(f.y_m)};
  }
  [[nodiscard]] Vector Velocity(int frame) const {
    const Motion::Frame& f = motion_.At(frame);
    return {static_cast<double>(f.velocity_x_mps), static_cast<double>(f.velocity_y_mps)};
  }
  [[nodiscard]] Vector Impulse(int endpoint) const { return Wide(motion_.Force(frame_, endpoint)) * step_s_; }

  void JudgeFrame(int frame) {
    const Motion::Frame& f = motion_.At(frame);
    double infinite = 0.0;
    const auto count = [&](double number) { infinite += std::isfinite(number) ? 0.0 : 1.0; };
    for (const double number :
         {f.x_m, f.turn_rad, static_cast<double>(f.y_m), static_cast<double>(f.velocity_x_mps),
          static_cast<double>(f.velocity_y_mps), static_cast<double>(f.angular_momentum)})
      count(number);
    for (int k = 0; k < motion_.Bones().endpoints; ++k) {
      const Vector place = Wide(motion_.Endpoint(frame, k)), force = Wide(motion_.Force(frame, k));
      for (const double number : {place.x, place.y, force.x, force.y}) count(number);
      Offend(Law::kAboveGround, -(static_cast<double>(f.y_m) + place.y) / reach_m_);
      Offend(Law::kPush, -force.y * step_s_ / mass_kg_);
      const double most = static_cast<double>(document_.environment.friction) * force.y;
      // Impulses below the least normal float have too few digits for a relative comparison.
      const double least = static_cast<double>(std::numeric_limits<float>::min()) / step_s_;
      Offend(Law::kCone, (std::abs(force.x) - most) / std::max(std::abs(force.x), least));
    }
    for (int j = 0; j < motion_.Bones().joints; ++j) {
      const Skeleton::Limb& limb = motion_.Bones().limbs[static_cast<std::size_t>(j) + 1];
      const float angle = motion_.AngleRad(frame, j);
      count(static_cast<double>(angle));
      count(static_cast<double>(motion_.RateRadps(frame, j)));
      Offend(Law::kJointLimits, static_cast<double>(std::max(limb.min_rad - angle, angle - limb.max_rad)));
    }
    Offend(Law::kFinite, infinite);
  }

  void JudgeStep() {
    const int last = frame_ - 1;
    const float time_s = static_cast<float>(last) * motion_.StepS();
    const auto slope = static_cast<double>(GroundAngle(document_.environment, time_s));
    const Vector gravity =
        Vector{-std::sin(slope), -std::cos(slope)} * static_cast<double>(document_.environment.gravity_mps2);

    Vector given{};
    double given_sum = 0.0, given_moment = 0.0;
    bool pushed = false;
    for (const Push& push : document_.pushes) {
      if (push.step != last) continue;
      const Vector impulse = {static_cast<double>(push.impulse_x_ns), static_cast<double>(push.impulse_y_ns)};
      pushed = true;
      given = given + impulse;
      given_sum += impulse.Length();
      if (push.endpoint != kCentreOfMass)
        given_moment += Wide(motion_.Endpoint(last, push.endpoint)).Cross(impulse);
    }

    Vector ground{};
    double ground_sum = 0.0, ground_moment = 0.0, ground_work = 0.0;
    const auto lift_j = static_cast<double>(motion_.At(frame_).lifting_work_j);
    const double lift_m = Lift();
    for (int k = 0; k < motion_.Bones().endpoints; ++k) {
      const Vector impulse = Impulse(k);
      const Vector before = Wide(motion_.Endpoint(last, k)), after = Wide(motion_.Endpoint(frame_, k));
      const Vector way = Middle(frame_) + after - Middle(last) - before - Vector{0.0, lift_m};
      ground = ground + impulse;
      ground_sum += impulse.Length();
      ground_moment += ((before + after) * 0.5).Cross(impulse);
      ground_work += impulse.Dot(way) / step_s_;
    }

    const Vector change = (Velocity(frame_) - Velocity(last)) * mass_kg_;
    const double took_part =
        mass_kg_ * (Velocity(last).Length() + Velocity(frame_).Length() + gravity.Length() * step_s_) +
        ground_sum + given_sum;
    if (took_part > 0.0) {
      // The impulses of model 2 may end in numbers with too few digits for a relative comparison.
      const double least =
          document_.model > 1 ? static_cast<double>(std::numeric_limits<float>::min()) : took_part;
      Offend(Law::kMomentum, (change - gravity * (mass_kg_ * step_s_) - ground - given).Length() /
                                 std::max(took_part, least));
    }

    const auto spin_before = static_cast<double>(motion_.At(last).angular_momentum);
    const auto spin_after = static_cast<double>(motion_.At(frame_).angular_momentum);
    if (ground_sum == 0.0 && !pushed && spin_after != spin_before)
      Offend(Law::kFlight, std::abs(spin_after - spin_before) / std::abs(spin_before));
    if (ground_sum > 0.0) {
      const double missing = std::abs(spin_after - spin_before - ground_moment - given_moment);
      const double rounding = kRounding * (std::abs(spin_after) + std::abs(spin_before) +
                                           std::abs(given_moment) + given_sum * reach_m_);
      const double way_m = std::max(Velocity(last).Length(), Velocity(frame_).Length()) * step_s_;
      Offend(Law::kMoment, (missing - rounding) / (ground_sum * (reach_m_ + way_m)));
    }

    // Rounding errors of great heights and speeds do not count as work.
    const double rounding_j = kRounding * mass_kg_ *
                              (Velocity(last).Dot(Velocity(last)) + Velocity(frame_).Dot(Velocity(frame_)) +
                               gravity.Length() * (std::abs(Middle(frame_).y) + reach_m_));
    if (ground_sum > 0.0) {
      // The mean of the velocities before and after: the velocities after, less half of what the ground
      // changed.
      const Vector kick = ground + gravity * (mass_kg_ * step_s_);
      const double turned = spin_after - spin_before - given_moment;
      const double taken = 0.5 * kick.Dot(kick) / mass_kg_ + 0.5 * turned * turned / MiddleInertia();
      const double slack = kRounding * ground_sum / step_s_ * (std::abs(Middle(frame_).y) + reach_m_);
      // Angular momentum without an impulse on an endpoint counts as the ground's too.
      const double spin = (motion_.At(frame_).turn_rad - motion_.At(last).turn_rad) / step_s_;
      const double astray = spin * (turned - ground_moment);
      const double gained = ground_work + astray + lift_j - taken - rounding_j - slack;
      Offend(Law::kGroundWork, gained / Scale());
      ground_gain_ += std::max(0.0, gained / Scale());
    }
    lifted_m_ += lift_m;
    if (!pushed && Still()) JudgeStill(gravity, rounding_j);
    if (Concerns(Law::kTurning, document_.model)) JudgeLimbs(ground_sum + given_sum);
  }

  /// @param struck impulses of the ground and of pushes in this step, all as if they acted the same way [N s]
  void JudgeLimbs(double struck) {
    const LimbMotion::Turning now = limbs_.InStep(frame_);
    const auto spin = static_cast<double>(motion_.At(frame_).angular_momentum);
    // Of figures that hardly turn, the angular momentum is mostly rounding error.
    constexpr double kAtRest = 0.1;  // [rad/s]
    const double rounding = kRounding * struck * reach_m_;
    Offend(Law::kTurning, (std::abs(spin - now.angular_momentum) - rounding) /
                              (std::abs(spin) + now.of_all + kAtRest * limbs_.WholeInertia()));
    const bool free = struck == 0.0;
    if (free && was_free_) {
      // From the middle of the step before to the middle of this one.
      const double gained =
          (now.energy_j - before_.energy_j - limbs_.MostWork(frame_)) / (Scale() + before_.energy_j);
      Offend(Law::kLimbWork, gained);
      limb_gain_ += std::max(0.0, gained);
    }
    was_free_ = free;
    before_ = now;
  }

  void JudgeStill(Vector gravity, double rounding_j) {
    const double inertia = MiddleInertia();
    const auto kinetic = [&](int frame) {
      const auto spin = static_cast<double>(motion_.At(frame).angular_momentum);
      return 0.5 * mass_kg_ * Velocity(frame).Dot(Velocity(frame)) + 0.5 * spin * spin / inertia;
    };
    const double before = kinetic(frame_ - 1), after = kinetic(frame_);
    const double gained = after - before - mass_kg_ * gravity.Dot(Middle(frame_) - Middle(frame_ - 1)) -
                          rounding_j - kRounding * (before + after);
    Offend(Law::kStillEnergy, gained / Scale());
    still_gain_ += std::max(0.0, gained / Scale());
  }

  /// Distance that the figure was lifted out of the ground in this step [m].
  [[nodiscard]] double Lift() const {
    const auto gravity = static_cast<double>(document_.environment.gravity_mps2);
    if (gravity > 1e-3) {
      const double slope = std::cos(static_cast<double>(document_.environment.slope_rad));
      return static_cast<double>(motion_.At(frame_).lifting_work_j) / (mass_kg_ * gravity * slope);
    }
    // Without gravity lifting does no work, but it is visible: every other displacement comes from the
    // velocity.
    const double lift = Middle(frame_).y - Middle(frame_ - 1).y -
                        static_cast<double>(motion_.At(frame_).velocity_y_mps) * step_s_;
    const double rounding = kRounding * (std::abs(Middle(frame_).y) + reach_m_) + 1e-3 * step_s_ * step_s_;
    return lift > rounding ? lift : 0.0;
  }

  /// Whether no joint moves in this step.
  [[nodiscard]] bool Still() const {
    for (int j = 0; j < motion_.Bones().joints; ++j) {
      if (motion_.AngleRad(frame_, j) != motion_.AngleRad(frame_ - 1, j)) return false;
      if (motion_.RateRadps(frame_, j) != 0.0f || motion_.RateRadps(frame_ - 1, j) != 0.0f) return false;
    }
    return true;
  }

  /// The scale for a gain of energy: M g l plus the figure's energy before the step [J].
  [[nodiscard]] double Scale() const {
    const Vector velocity = Velocity(frame_ - 1);
    const double spin = frame_ < 2
                            ? static_cast<double>(document_.start.spin_radps)
                            : (motion_.At(frame_ - 1).turn_rad - motion_.At(frame_ - 2).turn_rad) / step_s_;
    return unit_j_ + 0.5 * mass_kg_ * velocity.Dot(velocity) + 0.5 * MiddleInertia() * spin * spin;
  }

  /// An endpoint in the root frame, relative to the centre of mass [m].
  [[nodiscard]] Vector Seen(int frame, int endpoint) const {
    const double turn = motion_.At(frame).turn_rad;
    const Vector place = Wide(motion_.Endpoint(frame, endpoint));
    return {std::cos(turn) * place.x + std::sin(turn) * place.y,
            std::cos(turn) * place.y - std::sin(turn) * place.x};
  }
  /// Inertia about the centre of mass, of the shape in the middle of the step [kg m^2].
  [[nodiscard]] double MiddleInertia() const {
    double inertia = 0.0;
    for (int rod = 0; rod < motion_.Bones().rods; ++rod) {
      const Skeleton::Limb& limb = motion_.Bones().limbs[static_cast<std::size_t>(rod)];
      Vector middle{};
      for (const int frame : {frame_ - 1, frame_})
        middle = middle + (Seen(frame, limb.start) + Seen(frame, rod + 1)) * 0.25;
      inertia +=
          static_cast<double>(limb.mass_kg) * middle.Dot(middle) + static_cast<double>(limb.inertia_kgm2);
    }
    return inertia;
  }

  const Document& document_;
  const Motion& motion_;
  LimbMotion limbs_;
  double step_s_;
  double mass_kg_ = 0.0, reach_m_ = 0.0, unit_j_ = 0.0;
  int frame_ = 0;
  double still_gain_ = 0.0, ground_gain_ = 0.0;
  double lifted_m_ = 0.0;
  bool was_free_ = false;         // neither ground nor a push acted in the step before
  LimbMotion::Turning before_{};  // in that step
  double limb_gain_ = 0.0;
  Offences offences_;
};

}  // namespace

int Offences::FirstBroken() const {
  for (int law = 0; law < kLaws; ++law) {
    const auto i = static_cast<std::size_t>(law);
    if (!(of[i].by <= LawLimits(model)[i].most)) return law;
  }
  return kLaws;
}

std::string Offences::Sentence() const {
  const int law = FirstBroken();
  if (law == kLaws) return "";
  const LawLimit& limit = LawLimits(model)[static_cast<std::size_t>(law)];
  const Offence& offence = of[static_cast<std::size_t>(law)];
  std::ostringstream words;
  words << limit.name << ": " << offence.by << " " << limit.unit << " in frame " << offence.frame;
  return words.str();
}

const std::array<LawLimit, kLaws>& LawLimits(int model) {
  return model == kSpringModel ? kSpringLawLimits : model > 1 ? kLimbLawLimits : kLawLimits;
}

double EnergyUnit(const Skeleton& bones) {
  return static_cast<double>(bones.mass_kg) * static_cast<double>(kStandardGravity) *
         static_cast<double>(bones.longest_rod_m);
}

Offences Judge(const Document& document, const Motion& motion) {
  return document.figure.HasSprings() ? JudgeSprings(document, motion) : Trial(document, motion).Judge();
}

int DifferingBits(const Document& document, const Motion& motion) {
  int differing = Simulate(document).Hash() == motion.Hash() ? 0 : 1;
  const Controller& controller = document.controllers.front();
  const Problem problem = ReplayProblem(document, controller);
  for (const int lanes : Evaluator::kLaneCounts) {
    const auto count = static_cast<std::size_t>(lanes);
    std::vector<Genome> genomes(count);
    for (std::size_t lane = 0; lane < count; ++lane) {
      RandomStream random(lane, static_cast<std::uint32_t>(lanes), 0);
      genomes[lane] = RandomGenome(controller.Shape(CountPorts(document.model, document.figure)),
                                   controller.senses, Variation{}, random);
    }
    const std::size_t own = static_cast<std::size_t>(motion.Hash() % count);
    genomes[own] = controller.genes;
    const auto found = Evaluator(problem, lanes, true).Evaluate(genomes);
    differing += found[own].trajectory_hash == motion.Hash() ? 0 : 1;
  }
  return differing;
}

}  // namespace gaitsmith::test
