// SPDX-License-Identifier: MIT
#include "shell/command_line/problem_options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "core/document/joints.h"
#include "core/document/style_weights.h"
#include "core/world/ground_preset.h"

namespace gaitsmith::shell {

Result<int> WholeSteps(const std::string& text, const std::string& where, int least, int most) {
  const auto seconds = ParseNumber(text, where);
  if (!seconds) return std::unexpected(seconds.error());
  const double steps = std::round(*seconds / 0.01);
  if (!(steps >= least && steps <= most) || std::abs(steps * 0.01 - *seconds) > 1e-9) {
    char range[96];
    std::snprintf(range, sizeof range, "must be from %g to %g s in steps of 0.01 s, is ", least * 0.01,
                  most * 0.01);
    return Fail(ErrorCode::kOutOfRange, where, range + text);
  }
  return static_cast<int>(steps);
}

Result<void> SetSense(const std::string& text, SenseSpec& senses) {
  if (text == "physical") {
    senses.kind = SenseKind::kPhysical;
    return {};
  }
  if (text == "sight" || text.starts_with("sight=")) {
    senses.kind = SenseKind::kSight;
    if (text == "sight") return {};
    const auto rods = ParseNumber(text.substr(6), "--sense sight");
    if (!rods) return std::unexpected(rods.error());
    senses.sight_rods = static_cast<float>(std::clamp(std::abs(*rods), 0.0, 1e30));
    senses.facing = *rods < 0.0 ? Facing::kLeft : Facing::kRight;
    return {};
  }
  if (!text.starts_with("timer=")) {
    return Fail(ErrorCode::kUnknownName, "--sense",
                "must be physical, timer=SECONDS or sight, is \"" + text + "\"");
  }
  const auto period = WholeSteps(text.substr(6), "--sense timer", 2);
  if (!period) return std::unexpected(period.error());
  senses.kind = SenseKind::kTimer;
  senses.period_steps = *period;
  return {};
}

std::string SenseText(const SenseSpec& senses) {
  if (senses.kind == SenseKind::kPhysical) return "physical";
  char text[40];
  if (senses.kind == SenseKind::kSight) {
    const float rods = senses.facing == Facing::kLeft ? -senses.sight_rods : senses.sight_rods;
    std::snprintf(text, sizeof text, "sight=%g", static_cast<double>(rods));
    return text;
  }
  std::snprintf(text, sizeof text, "timer=%g", senses.period_steps * 0.01);
  return text;
}

Result<void> SetWeight(const std::string& name, const std::string& number, Document& document,
                       const std::string& option, const std::string& where) {
  const auto term = IndexOf(kStyleTermNames, name, option);
  if (!term) return std::unexpected(term.error());
  const auto index = static_cast<std::size_t>(*term);
  const bool less = number.starts_with('-');
  const std::string_view word = std::string_view(number).substr(less ? 1 : 0);
  if (word == "usual" || word == "gentle") {
    const float weight = (word == "usual" ? UsualWeights(document) : GentleWeights(document))[index];
    document.task.weights[index] = less ? -weight : weight;
    return {};
  }
  const auto weight = ParseNumber(number, where);
  if (!weight) return std::unexpected(weight.error());
  document.task.weights[index] = static_cast<float>(std::clamp(*weight, -1e30, 1e30));
  return {};
}

namespace {

/// The numbers of a text with a sign between them, such as 0:0:0.8. @param where for errors
Result<std::vector<float>> NumbersOf(const std::string& text, char between, const std::string& where) {
  std::vector<float> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(between, begin), text.size());
    const auto number = ParseNumber(text.substr(begin, end - begin), where);
    if (!number) return std::unexpected(number.error());
    numbers.push_back(static_cast<float>(std::clamp(*number, -1e30, 1e30)));
    begin = end + 1;
  }
  return numbers;
}

Result<int> StepAt(const std::string& text, const std::string& where, int least) {
  return WholeSteps(text.substr(0, text.find(':')), where, least, kMaxSteps);
}

/// A term that was given something to be measured against, but no weight, gets the usual one.
void WeighShown(StyleTerm term, Document& document) {
  float& weight = document.task.weights[static_cast<std::size_t>(term)];
  if (weight == 0.0f) weight = UsualWeights(document)[static_cast<std::size_t>(term)];
}

Result<void> SetWay(const std::string& text, Document& document) {
  std::vector<WayPoint> way;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string point = text.substr(begin, end - begin);
    const auto numbers = NumbersOf(point, ':', "--way");
    if (!numbers) return std::unexpected(numbers.error());
    if (numbers->size() != 3)
      return Fail(ErrorCode::kSyntax, "--way", "must have points SECONDS:X:Y, has \"" + point + "\"");
    const auto step = StepAt(point, "--way", 0);
    if (!step) return std::unexpected(step.error());
    way.push_back({*step, (*numbers)[1], (*numbers)[2]});
    begin = end + 1;
  }
  document.task.shown.way = std::move(way);
  WeighShown(StyleTerm::kOnWay, document);
  return {};
}

Result<void> SetPose(const std::string& text, Document& document) {
  if (document.figure.HasSprings())
    return Fail(ErrorCode::kStructure, "--pose", "is for figures of rods, and this one has springs");
  const auto numbers = NumbersOf(text, ':', "--pose");
  if (!numbers) return std::unexpected(numbers.error());
  const auto joints = static_cast<std::size_t>(document.figure.Joints());
  if (numbers->size() != 2 + joints)
    return Fail(ErrorCode::kSyntax, "--pose",
                "must be SECONDS:TURN and the angles of the " + std::to_string(joints) +
                    " joints, all with colons between them, has " + std::to_string(numbers->size()) +
                    " numbers");
  const auto step = StepAt(text, "--pose", 1);
  if (!step) return std::unexpected(step.error());
  Demonstration& shown = document.task.shown;
  shown.pose_step = *step;
  shown.pose_turn_rad = (*numbers)[1];
  shown.pose_rad.assign(numbers->begin() + 2, numbers->end());
  WeighShown(StyleTerm::kInPose, document);
  return {};
}

Result<void> SetJoints(const std::string& text, Document& document) {
  if (text == "strong") {
    FreeJoints(document);
    return {};
  }
  LimitJoints(document);
  if (text == "limited") return {};
  const auto strength = ParseNumber(text, "--joints");
  if (!strength)
    return Fail(ErrorCode::kUnknownName, "--joints",
                "must be strong, limited or a strength in M g L, is \"" + text + "\"");
  // Validate checks the range.
  SetJointStrength(static_cast<float>(std::clamp(*strength, -1e30, 1e30)), document);
  return {};
}

Result<void> SetGround(const std::string& text, Document& document) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string name = text.substr(0, colon);
  const auto found = std::ranges::find(kGroundPresetNames, name);
  const auto preset = static_cast<GroundPreset>(found - kGroundPresetNames.begin());
  if (found == kGroundPresetNames.end() || (colon < text.size() && preset != GroundPreset::kRubble))
    return Fail(
        ErrorCode::kUnknownName, "--ground",
        "must be level, step, stairs, ramp, gap, hurdles, rubble or rubble:SEED, is \"" + text + "\"");
  std::uint32_t seed = 1;
  if (colon < text.size()) {
    const auto number = ParseWhole(text.substr(colon + 1), 1, kMostRubble, "--ground rubble");
    if (!number) return std::unexpected(number.error());
    seed = static_cast<std::uint32_t>(*number);
  }
  document.environment.ground = GroundOf(preset, seed);
  if (!document.environment.ground.empty() && document.model < kFirstDrawnGround)
    return Fail(ErrorCode::kStructure, "--ground",
                "only limited joints know such ground: add --joints limited");
  return {};
}

}  // namespace

Result<void> SetProblemOptions(const Arguments& arguments, Document& document) {
  if (arguments.Has("duration")) {
    const auto duration = WholeSteps(arguments.Last("duration"), "--duration", 1);
    if (!duration) return std::unexpected(duration.error());
    document.task.duration_steps = *duration;
  }
  if (arguments.Has("sense")) {
    if (auto sense = SetSense(arguments.Last("sense"), document.senses); !sense) return sense;
  }
  if (arguments.Has("controller")) {
    // A trajectory that rests has a name of its own.
    std::string name = arguments.Last("controller");
    const bool rests = name == "trajectory:rest";
    if (rests) name = "trajectory";
    const auto kind = IndexOf(kControllerKindNames, name, "--controller");
    if (!kind) return std::unexpected(kind.error());
    document.kind = static_cast<ControllerKind>(*kind);
    document.senses.at_end = rests ? CurveEnd::kRest : CurveEnd::kRepeat;
  }
  if (arguments.Has("joints")) {
    if (document.figure.HasSprings())
      return Fail(ErrorCode::kStructure, "--joints", "a figure of springs has no joints");
    if (auto set = SetJoints(arguments.Last("joints"), document); !set) return set;
  }
  if (arguments.Has("ground")) {
    if (auto set = SetGround(arguments.Last("ground"), document); !set) return set;
  }
  if (arguments.Has("way")) {
    if (auto set = SetWay(arguments.Last("way"), document); !set) return set;
  }
  if (arguments.Has("pose")) {
    if (auto set = SetPose(arguments.Last("pose"), document); !set) return set;
  }
  for (const std::string& weight : arguments.All("weight")) {
    const std::size_t equals = std::min(weight.find('='), weight.size());
    const std::string number = weight.substr(std::min(equals + 1, weight.size()));
    if (auto set = SetWeight(weight.substr(0, equals), number, document, "--weight", "--weight " + weight);
        !set) {
      return set;
    }
  }
  return {};
}

}  // namespace gaitsmith::shell
