// SPDX-License-Identifier: MIT
#include "core/spacetime/plan_conditions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();
/// Directions change by at most this in a step of the solver [rad].
constexpr double kMostTurn = 1.0;
/// How far the middle of a rod that lies may be below the cover of drawn ground [longest rods].
constexpr double kSunk = 0.02;

/// Gauss's points in [-1, 1] and their weights, exact for polynomials up to the ninth degree.
struct GaussPoint {
  double at, weight;
};
constexpr std::array kGauss = {
    GaussPoint{-0.9061798459386640, 0.2369268850561891}, GaussPoint{-0.5384693101056831, 0.4786286704993665},
    GaussPoint{0.0, 0.5688888888888889}, GaussPoint{0.5384693101056831, 0.4786286704993665},
    GaussPoint{0.9061798459386640, 0.2369268850561891}};
constexpr std::array kCoarseGauss = {GaussPoint{-0.7745966692414834, 0.5555555555555556},
                                     GaussPoint{0.0, 0.8888888888888888},
                                     GaussPoint{0.7745966692414834, 0.5555555555555556}};

/// Centres of the coefficients of a spline that starts and ends with the phase.
std::vector<double> CentresOf(const PlanLayout& layout, const PlanLayout::Phase& phase, int degree) {
  const auto first = layout.breaks.begin() + phase.first_piece;
  const std::vector<double> breaks(first, first + phase.pieces + 1);
  const SplineSpace space(degree, breaks, std::vector<int>(breaks.size() - 1, degree));
  std::vector<double> centres;
  centres.reserve(static_cast<std::size_t>(space.Size()));
  for (int i = 0; i < space.Size(); ++i) centres.push_back(space.Centre(i));
  return centres;
}

/// The piece of a phase in which an instant is; at its end the last one.
int PieceWithin(const PlanLayout& layout, const PlanLayout::Phase& phase, double time) {
  return std::clamp(layout.PieceAt(time), phase.first_piece, phase.first_piece + phase.pieces - 1);
}

}  // namespace

int PlanConditions::AddVariable(double least, double most, double step) {
  lower.push_back(least);
  upper.push_back(most);
  reach.push_back(step);
  return static_cast<int>(lower.size()) - 1;
}

int PlanConditions::AddGive(PlanPart part) {
  if (!elastic_) return -1;
  const int first = AddVariable(0.0, kNoBound, kNoBound);
  AddVariable(0.0, kNoBound, kNoBound);
  gives.push_back({part, first});
  return first;
}

PlanConditions::PlanConditions(const PlanScene& scene, const PlanLayout& layout, const Eigen::VectorXd& guess,
                               bool elastic)
    : scene_(scene), layout_(layout), elastic_(elastic) {
  const int curves = layout.Curves() * layout.positions.Size();
  for (int i = 0; i < curves; ++i)
    AddVariable(-kNoBound, kNoBound, i < layout.Curve(2) ? kNoBound : kMostTurn);
  const auto places =
      static_cast<int>(std::ranges::count_if(layout.stance_place, [](int at) { return at >= 0; }));
  for (int i = curves; i < layout.unknowns - places; ++i) AddVariable(0.0, kNoBound, kNoBound);
  for (int i = 0; i < places; ++i) AddVariable(-kNoBound, kNoBound, kNoBound);
  for (std::size_t s = 0; s < layout.stance_place.size(); ++s) {
    const int index = static_cast<int>(s);
    stance_give.push_back(AddGive({PlanPart::Kind::kStanceX, index}));
    AddGive({PlanPart::Kind::kStanceY, index});
  }
  AddStart();
  for (std::size_t i = 0; i < layout.phases.size(); ++i) AddPhase(guess, i);
  for (std::size_t i = 0; i < scene.plan.keyframes.size(); ++i) AddKeyframe(i);
  AddLimits();
}

void PlanConditions::AddStart() {
  const SplineShares value = layout_.positions.At(0, 0.0, 0), rate = layout_.positions.At(0, 0.0, 1);
  for (int curve = 0; curve < layout_.Curves(); ++curve) {
    const double place = curve == 0   ? layout_.start_x
                         : curve == 1 ? layout_.start_y
                                      : layout_.start_direction[static_cast<std::size_t>(curve) - 2];
    const double speed = curve == 0   ? layout_.start_rate_x
                         : curve == 1 ? layout_.start_rate_y
                                      : layout_.start_spin;
    lines.push_back({curve, -1, value, place});
    lines.push_back({curve, -1, rate, speed});
  }
}

bool PlanConditions::Stands(std::size_t phase, int endpoint) const {
  if (phase >= layout_.phases.size()) return false;
  const std::vector<int>& contacts = layout_.phases[phase].contacts;
  return std::ranges::find(contacts, endpoint) != contacts.end();
}

void PlanConditions::AddPhase(const Eigen::VectorXd& guess, std::size_t index) {
  AddEquations(index);
  const std::vector<double> centres = CentresOf(layout_, layout_.phases[index], layout_.positions.Degree());
  AddPins(guess, index, centres);
  AddClearances(index, centres);
}

void PlanConditions::AddEquations(std::size_t index) {
  const PlanLayout::Phase& phase = layout_.phases[index];
  const int degree = layout_.positions.Degree();
  for (const double time : CentresOf(layout_, phase, degree - 2))
    newton.push_back(layout_.At(PieceWithin(layout_, phase, time), time));
  if (phase.lands) {
    PlanInstant landing = layout_.Landing(static_cast<int>(index));
    newton.push_back(landing);
    landing.weight = 1.0;
    quadrature.push_back(landing);
    // Joints keep their rates in a landing, as in the simulator.
    for (int j = 1; j < layout_.model.rods; ++j) lines.push_back({2 + j, 2, landing.position[2], 0.0});
  }
  const auto integrate = [&](const auto& points) {
    for (int piece = phase.first_piece; piece < phase.first_piece + phase.pieces; ++piece) {
      const double from = layout_.breaks[static_cast<std::size_t>(piece)],
                   to = layout_.breaks[static_cast<std::size_t>(piece) + 1];
      for (const GaussPoint& point : points) {
        PlanInstant& at =
            quadrature.emplace_back(layout_.At(piece, 0.5 * (from + to + point.at * (to - from))));
        at.weight = 0.5 * point.weight * (to - from);
      }
    }
  };
  if (degree > 3)
    integrate(kGauss);
  else
    integrate(kCoarseGauss);
}

void PlanConditions::AddPins(const Eigen::VectorXd& guess, std::size_t index,
                             const std::vector<double>& centres) {
  const PlanLayout::Phase& phase = layout_.phases[index];
  // What the phase before already says of the place and speed of an endpoint that goes on standing.
  const std::size_t known = phase.lands ? 1 : 2;
  for (std::size_t c = 0; c < phase.contacts.size(); ++c) {
    const int endpoint = phase.contacts[c];
    const bool stood = index == 0 || Stands(index - 1, endpoint);
    // A rod that lies on the ground: one of its ends keeps its place, and the rod its direction. Two heights
    // would also let it lie the other way round.
    bool drawn = false;  // both ends have stood since the start
    const int rod = [&] {
      for (std::size_t other = 0; other < c; ++other) {
        const int outer = std::max(endpoint, phase.contacts[other]),
                  inner = std::min(endpoint, phase.contacts[other]);
        if (scene_.skeleton.limbs[static_cast<std::size_t>(outer) - 1].start != inner) continue;
        const auto since_start = [&](std::size_t at) {
          return scene_.plan.stances[static_cast<std::size_t>(phase.stances[at])].first_step == 0;
        };
        drawn = since_start(c) && since_start(other);
        return outer - 1;
      }
      return -1;
    }();
    double direction = 0.0;
    if (rod >= 0) {
      // As it is drawn, or as it is nearest to.
      const PlanInstant end =
          layout_.At(phase.first_piece + phase.pieces - 1, layout_.TimeOf(phase.last_step));
      direction = drawn ? layout_.start_direction[static_cast<std::size_t>(rod)]
                        : kPi * std::round(layout_.ValueOf(guess, 2 + rod, end.position[0]) / kPi);
    }
    const int give = stance_give[static_cast<std::size_t>(phase.stances[c])];
    for (std::size_t i = stood ? known : 0; i < centres.size(); ++i) {
      const PlanInstant at = layout_.At(PieceWithin(layout_, phase, centres[i]), centres[i]);
      if (rod < 0 || !layout_.ground.Level())  // drawn ground says how the rod lies
        pins.push_back({at, phase.stances[c], rod < 0});
      else
        lines.push_back({2 + rod, -1, at.position[0], direction, give < 0 ? -1 : give + 2});
    }
  }
}

void PlanConditions::AddClearances(std::size_t index, const std::vector<double>& centres) {
  const PlanLayout::Phase& phase = layout_.phases[index];
  const int endpoints = layout_.model.rods + 1;
  // Drawn ground may also touch rods between their ends.
  const int points = layout_.ground.Level() ? endpoints : endpoints + layout_.model.rods;
  const auto is_down = [&](std::size_t at, int point) {
    if (point < endpoints) return Stands(at, point);
    const int rod = point - endpoints;
    return Stands(at, rod + 1) && Stands(at, scene_.skeleton.limbs[static_cast<std::size_t>(rod)].start);
  };
  // A fast foot would slip through a thin hurdle between two points, so drawn ground is looked at twice as
  // often.
  std::vector<double> times;
  const std::size_t each = layout_.ground.Level() ? 1 : 2;
  times.reserve(each * centres.size());
  for (std::size_t i = 0; i < centres.size(); ++i) {
    if (each == 2 && i > 0) times.push_back(0.5 * (centres[i - 1] + centres[i]));
    times.push_back(centres[i]);
  }
  for (int point = 0; point < points; ++point) {
    const bool lies = is_down(index, point);
    if (lies && point < endpoints) continue;
    const std::size_t skipped = !lies && (index == 0 || is_down(index - 1, point)) ? 2 * each : 0;
    const std::size_t end = times.size() - (!lies && is_down(index + 1, point) ? each : 0);
    for (std::size_t i = skipped; i < end; ++i) {
      const int height = AddVariable(lies ? -kSunk : 0.0, kNoBound, kNoBound);
      clearances.push_back({layout_.At(PieceWithin(layout_, phase, times[i]), times[i]), point, height});
    }
  }
}

void PlanConditions::AddKeyframe(std::size_t index) {
  const Keyframe& keyframe = scene_.plan.keyframes[index];
  const double time = layout_.TimeOf(keyframe.step);
  const PlanInstant at = layout_.At(layout_.PieceAt(time), time);
  const int number = static_cast<int>(index);
  for (std::size_t j = 0; j < keyframe.pose_rad.size(); ++j) {
    const Skeleton::Limb& limb = scene_.skeleton.limbs[j + 1];
    lines.push_back({static_cast<int>(j) + 3, limb.parent + 2, at.position[0],
                     static_cast<double>(limb.rest_rad) + static_cast<double>(keyframe.pose_rad[j]),
                     AddGive({PlanPart::Kind::kJoint, number, static_cast<int>(j)})});
  }
  if (keyframe.turned) {
    lines.push_back({2, -1, at.position[0],
                     layout_.start_direction[0] + static_cast<double>(keyframe.turn_rad),
                     AddGive({PlanPart::Kind::kTurn, number})});
  }
  if (keyframe.still) {
    // Feet that stand say the rest.
    const bool flies = layout_.phases[static_cast<std::size_t>(at.phase)].contacts.empty();
    for (int curve = flies ? 0 : 2; curve < layout_.Curves(); ++curve)
      lines.push_back({curve, -1, at.position[1], 0.0});
  }
  for (std::size_t i = 0; i < keyframe.marks.size(); ++i) {
    const Mark& mark = keyframe.marks[i];
    const int which = static_cast<int>(i);
    if (mark.axes != MarkAxes::kUp) {
      aims.push_back({at, mark.endpoint, true, static_cast<double>(mark.x_m) / layout_.length_m,
                      AddGive({PlanPart::Kind::kMarkX, number, which})});
    }
    if (mark.axes != MarkAxes::kAlong) {
      aims.push_back({at, mark.endpoint, false, static_cast<double>(mark.y_m) / layout_.length_m,
                      AddGive({PlanPart::Kind::kMarkY, number, which})});
    }
  }
}

void PlanConditions::AddLimits() {
  for (int joint = 0; joint + 1 < layout_.model.rods; ++joint) {
    const Skeleton::Limb& limb = scene_.skeleton.limbs[static_cast<std::size_t>(joint) + 1];
    const double rest = static_cast<double>(limb.rest_rad);
    const bool locked = !(limb.min_rad < limb.max_rad);
    // The first coefficient is the drawn pose, which is known.
    for (int i = 1; i < layout_.positions.Size(); ++i) {
      const int angle = locked ? -1
                               : AddVariable(rest + static_cast<double>(limb.min_rad),
                                             rest + static_cast<double>(limb.max_rad), kNoBound);
      limits.push_back({joint, i, angle});
    }
  }
}

}  // namespace gaitsmith
