// SPDX-License-Identifier: MIT
#include "shell/words/plan_words.h"

#include <algorithm>

#include "core/numeric/scalar_math.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

namespace {

std::string Seconds(int step) { return Fixed(step * static_cast<double>(kStep), 2); }
std::string Metres(double amount) { return Fixed(std::max(amount, 0.01), 2); }
std::string Degrees(double amount) { return Fixed(std::max(amount * 180.0 / kPi, 1.0), 0); }

}  // namespace

std::string PointWords(int endpoint) {
  return endpoint == kCentreOfMass ? Tr("The centre of mass") : Tr("Endpoint {1}", endpoint + 1);
}

std::string MissWords(const PlanMiss& miss, const Plan& plan) {
  using Kind = PlanPart::Kind;
  const auto index = static_cast<std::size_t>(miss.part.index),
             which = static_cast<std::size_t>(miss.part.which);
  if (miss.part.kind == Kind::kStanceX || miss.part.kind == Kind::kStanceY) {
    const Stance& stance = plan.stances[index];
    return Tr("{1} cannot stand from {2} to {3} s: {4} m are missing.", PointWords(stance.endpoint),
              Seconds(stance.first_step), Seconds(stance.last_step), Metres(miss.amount));
  }
  const Keyframe& keyframe = plan.keyframes[index];
  const std::string when = Seconds(keyframe.step);
  switch (miss.part.kind) {
    case Kind::kJoint:
      return Tr("Joint {1} cannot be bent so at {2} s: {3}° are missing.", miss.part.which + 1, when,
                Degrees(miss.amount));
    case Kind::kTurn:
      return Tr("The body cannot have turned so at {1} s: {2}° are missing.", when, Degrees(miss.amount));
    case Kind::kMarkX:
      return Tr("{1} cannot be there at {2} s: {3} m are missing.",
                PointWords(keyframe.marks[which].endpoint), when, Metres(miss.amount));
    default:
      return Tr("{1} cannot be so high at {2} s: {3} m are missing.",
                PointWords(keyframe.marks[which].endpoint), when, Metres(miss.amount));
  }
}

std::string PlayedWords(const PlanReport& report) {
  constexpr double kCloseM = 0.01;
  if (report.played_miss_m < kCloseM) return Tr("Planned, and played as planned.");
  return Tr("Planned. Played blindly, it is {1} m beside its marks.", Metres(report.played_miss_m));
}

}  // namespace gaitsmith::shell
