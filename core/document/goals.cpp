// SPDX-License-Identifier: MIT
#include "core/document/goals.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"
#include "core/physics/pose.h"
#include "core/physics/skeleton.h"

namespace gaitsmith {
namespace {

constexpr std::size_t Place(Goal goal) { return static_cast<std::size_t>(goal); }

/// A figure's row of docs/studies/goals/table.csv.
struct Measured {
  std::string_view figure;
  std::array<float, kGoals> strength;
  std::array<int, kGoals> met;  // of kGoalSeeds seeds
};

constexpr auto kMeasured = std::to_array<Measured>({
    {"Acrobat", {1.0f, 1.0f, 1.0f, 8.0f, 3.0f, 1.0f}, {20, 20, 20, 12, 6, 20}},
    {"Beryl Biped", {1.0f, 1.0f, 1.0f, 2.0f, 8.0f, 1.0f}, {20, 20, 0, 14, 6, 20}},
    {"Caterpillar", {1.0f, 1.0f, 3.0f, 2.0f, 3.0f, 3.0f}, {20, 20, 8, 20, 9, 17}},
    {"Crab", {1.0f, 1.0f, 4.0f, 2.0f, 1.0f, 1.0f}, {20, 20, 0, 20, 17, 20}},
    {"Fish", {1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f}, {16, 19, 1, 18, 0, 5}},
    {"Five-Rod Fred", {1.0f, 1.0f, 2.0f, 3.0f, 3.0f, 2.0f}, {20, 20, 6, 17, 6, 19}},
    {"Frog", {1.0f, 1.0f, 2.0f, 2.0f, 2.0f, 1.0f}, {20, 20, 17, 19, 12, 20}},
    {"Hopper", {1.0f, 1.0f, 1.0f, 4.0f, 2.0f, 3.0f}, {18, 0, 0, 17, 1, 9}},
    {"Horse", {1.0f, 1.0f, 8.0f, 4.0f, 3.0f, 1.0f}, {20, 20, 6, 11, 17, 19}},
    {"Inchworm", {1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f}, {20, 20, 0, 20, 0, 20}},
    {"Jelly", {1.0f, 1.0f, 2.0f, 2.0f, 1.0f, 1.0f}, {20, 20, 9, 20, 0, 20}},
    {"Kangaroo", {1.0f, 1.0f, 2.0f, 16.0f, 2.0f, 1.0f}, {20, 20, 4, 17, 9, 20}},
    {"Mr. Star-Man", {1.0f, 1.0f, 3.0f, 1.0f, 3.0f, 1.0f}, {20, 20, 7, 18, 9, 20}},
    {"Ostrich", {1.0f, 1.0f, 8.0f, 8.0f, 3.0f, 2.0f}, {20, 20, 13, 13, 10, 20}},
    {"Seven-Pointed Star", {1.0f, 1.0f, 3.0f, 2.0f, 3.0f, 1.0f}, {20, 0, 17, 20, 12, 20}},
    {"Snake", {1.0f, 1.0f, 1.0f, 4.0f, 4.0f, 2.0f}, {20, 20, 17, 11, 12, 16}},
    {"Soft Star", {1.0f, 1.0f, 1.0f, 4.0f, 1.0f, 2.0f}, {20, 20, 20, 16, 19, 20}},
    {"Soft Wheel", {1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f}, {20, 16, 20, 0, 17, 2}},
    {"Soft Worm", {1.0f, 1.0f, 8.0f, 2.0f, 1.0f, 1.0f}, {16, 20, 11, 17, 0, 15}},
    {"Spider", {1.0f, 1.0f, 4.0f, 3.0f, 3.0f, 1.0f}, {20, 20, 10, 17, 20, 17}},
    {"Swing-Arm", {1.0f, 1.0f, 1.0f, 8.0f, 4.0f, 4.0f}, {20, 20, 20, 20, 17, 17}},
    {"Torsoless Biped", {1.0f, 1.0f, 1.0f, 2.0f, 8.0f, 1.0f}, {20, 20, 0, 18, 8, 20}},
    {"Tumbler", {1.0f, 1.0f, 1.0f, 4.0f, 2.0f, 2.0f}, {20, 20, 20, 20, 19, 17}},
    {"Walking Table", {1.0f, 1.0f, 2.0f, 8.0f, 2.0f, 1.0f}, {20, 20, 6, 18, 15, 18}},
});

const Measured* RowOf(std::string_view figure) {
  const auto row = std::ranges::find(kMeasured, KindOf(figure), &Measured::figure);
  return row == kMeasured.end() ? nullptr : row;
}

/// The drawn pose's larger side and the height of its head [m].
struct Drawn {
  float size, head;
};

Drawn DrawnOf(const std::vector<Node>& nodes) {
  const auto [left, right] = std::ranges::minmax(nodes, {}, &Node::x_m);
  const auto [low, high] = std::ranges::minmax(nodes, {}, &Node::y_m);
  return {std::max(right.x_m - left.x_m, high.y_m - low.y_m), high.y_m - low.y_m};
}

Drawn DrawnOf(const Figure& figure) {
  if (figure.HasSprings()) return DrawnOf(figure.nodes);
  const Skeleton bones(figure);
  Pose<1> pose;
  PoseFigure<1>(bones, {}, pose);
  const SineCosine turn = SinCos(bones.start_angle_rad);
  float left = 0.0f, right = 0.0f, low = 0.0f, high = 0.0f, head = 0.0f;
  for (int end = 0; end < bones.endpoints; ++end) {
    const auto k = static_cast<std::size_t>(end);
    const float px = pose.endpoint_x[k][0], py = pose.endpoint_y[k][0];
    const float x = px * turn.cosine - py * turn.sine, y = px * turn.sine + py * turn.cosine;
    left = end == 0 ? x : std::min(left, x);
    right = end == 0 ? x : std::max(right, x);
    low = end == 0 ? y : std::min(low, y);
    high = end == 0 ? y : std::max(high, y);
    if (end == bones.head) head = y;
  }
  return {std::max(right - left, high - low), head - low};
}

Task TaskOf(Goal goal, float strength, Task task) {
  task.kind = goal == Goal::kHighJump ? TaskKind::kJump : TaskKind::kTravelRight;
  const std::array<float, kStyleTerms> weights = GoalWeights(goal);
  for (std::size_t term = 0; term < kStyleTerms; ++term) {
    const bool of_shown = term >= kFreeTerms && term < kWorkTerms;
    if (!of_shown) task.weights[term] = weights[term] * strength;
  }
  return task;
}

}  // namespace

std::array<float, kStyleTerms> GoalWeights(Goal goal) {
  std::array<float, kStyleTerms> weights{};
  const auto want = [&](StyleTerm term, float weight) { weights[static_cast<std::size_t>(term)] = weight; };
  switch (goal) {
    case Goal::kFar:
    case Goal::kHighJump:
      break;
    case Goal::kCartwheel:
      want(StyleTerm::kRotations, 10.0f);
      break;
    case Goal::kGlide:
      want(StyleTerm::kSlipSum, 0.3f);
      break;
    case Goal::kCalm:
      want(StyleTerm::kEffort, -0.025f);
      want(StyleTerm::kSmoothness, 0.1f);
      want(StyleTerm::kUpright, 1.0f);
      break;
    case Goal::kHeadUp:
      want(StyleTerm::kUpright, 5.0f);
      want(StyleTerm::kHeadHeight, 2.0f);
      break;
  }
  return weights;
}

float StrengthOf(Goal goal, std::string_view figure) {
  const Measured* row = RowOf(figure);
  return row == nullptr ? kGoalStrengths[kGoalStrengths.size() / 2] : row->strength[Place(goal)];
}

void SetGoal(Goal goal, float strength, Document& document) {
  document.task = TaskOf(goal, strength, document.task);
}

void SetGoal(Goal goal, Document& document) {
  SetGoal(goal, StrengthOf(goal, document.figure.name), document);
}

std::optional<Goal> GoalOf(const Document& document) {
  for (int i = 0; i < kGoals; ++i) {
    const auto goal = static_cast<Goal>(i);
    const Task task = TaskOf(goal, StrengthOf(goal, document.figure.name), document.task);
    if (task.kind == document.task.kind && task.weights == document.task.weights) return goal;
  }
  return std::nullopt;
}

bool Meets(Goal goal, const Figure& figure, const Terms& terms, float seconds) {
  if (terms.broke_physics) return false;
  const Drawn drawn = DrawnOf(figure);
  const float travel = std::abs(terms.travel_m);
  const bool travels = travel >= drawn.size;
  const auto actuators = static_cast<float>(std::max(1, figure.Actuators()));
  // In a second about four tenths of a usual range: of a joint 2.4 rad, of a muscle 0.8 drawn lengths.
  const float calm_rate = figure.HasSprings() ? 0.3f : 1.0f;
  switch (goal) {
    case Goal::kFar:
      return travel >= 0.25f * drawn.size * seconds;
    case Goal::kHighJump:
      return terms.max_cm_height_m - terms.start_height_m >= 0.2f * drawn.size;
    case Goal::kCartwheel:
      return terms.rotations >= 1.0f;
    case Goal::kGlide:
      return travels && terms.slip_sum_m >= travel;
    case Goal::kCalm:
      return travels && terms.effort_rad <= calm_rate * actuators * seconds;
    case Goal::kHeadUp:
      return travels && terms.upright >= 0.8f && terms.head_height_m >= 0.8f * drawn.head;
  }
  return false;
}

std::optional<int> SeedsThatMeet(Goal goal, std::string_view figure) {
  const Measured* row = RowOf(figure);
  if (row == nullptr) return std::nullopt;
  return row->met[Place(goal)];
}

}  // namespace gaitsmith
