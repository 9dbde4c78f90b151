// SPDX-License-Identifier: MIT
// Geometry of the springs' drawing board.
#include "shell/panels/figure/spring_edit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "core/numeric/scalar_math.h"
#include "core/world/environment.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

/// Of what is drawn. A pair of nodes at a spring then swings 10 times a second.
constexpr float kNodeKg = 0.3f, kStiffnessNpm = 600.0f, kDampingNspm = 2.0f;
/// How far a new muscle goes.
constexpr float kLeastMuscle = 0.65f, kMostMuscle = 1.35f;

/// Whole centimetres keep files readable.
float Rounded(float metres) { return std::round(metres * 100.0f) / 100.0f; }

float Distance(const Node& a, float x, float y) { return std::hypot(a.x_m - x, a.y_m - y); }

Node NodeAt(ImVec2 place) { return {.x_m = Rounded(place.x), .y_m = Rounded(place.y), .mass_kg = kNodeKg}; }

Spring SpringOf(int from, int to) {
  return {.from = from, .to = to, .stiffness_npm = kStiffnessNpm, .damping_nspm = kDampingNspm};
}

bool HasSpring(const Figure& figure, int one, int other) {
  return std::ranges::any_of(figure.springs, [&](const Spring& spring) {
    return std::minmax(spring.from, spring.to) == std::minmax(one, other);
  });
}

/// Without what there is already, and what is too short for core.
void Join(Figure& figure, int from, int to) {
  const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
  if (from == to || HasSpring(figure, from, to)) return;
  if (Distance(figure.nodes[a], figure.nodes[b].x_m, figure.nodes[b].y_m) < kShortestSpring) return;
  figure.springs.push_back(SpringOf(from, to));
}

/// Joins the last node to the nearest others.
void JoinToNearest(Figure& figure, int springs) {
  const auto last = static_cast<int>(figure.nodes.size()) - 1;
  const Node& node = figure.nodes.back();
  std::vector<int> others;
  others.reserve(figure.nodes.size());
  for (int other = 0; other < last; ++other) others.push_back(other);
  std::ranges::sort(others, {}, [&](int other) {
    return std::pair(Distance(figure.nodes[static_cast<std::size_t>(other)], node.x_m, node.y_m), other);
  });
  for (int i = 0; i < std::min(springs, last); ++i) Join(figure, others[static_cast<std::size_t>(i)], last);
}

bool OnMirror(float x, float mirror_m) { return std::abs(x - mirror_m) < kOnMirror; }

/// What a person draws at the mirror is meant to be on it.
ImVec2 AtMirror(ImVec2 place, Mirror mirror) {
  if (mirror && OnMirror(place.x, *mirror)) place.x = *mirror;
  return place;
}

ImVec2 Image(ImVec2 place, float mirror_m) { return {2.0f * mirror_m - place.x, place.y}; }

/// Which nodes springs hold together with this one.
std::vector<bool> HeldWith(const Figure& figure, std::size_t node) {
  std::vector<bool> held(figure.nodes.size(), false);
  held[node] = true;
  for (std::size_t round = 0; round < held.size(); ++round) {
    for (const Spring& spring : figure.springs) {
      const auto a = static_cast<std::size_t>(spring.from), b = static_cast<std::size_t>(spring.to);
      held[a] = held[b] = held[a] || held[b];
    }
  }
  return held;
}

/// Keeps the largest part that springs hold together, and of equals the one with the first node.
void DropLoose(Figure& figure) {
  std::vector<bool> held(figure.nodes.size(), false);
  for (std::size_t node = 0; node < figure.nodes.size(); ++node) {
    const std::vector<bool> part = HeldWith(figure, node);
    if (std::ranges::count(part, true) > std::ranges::count(held, true)) held = part;
  }
  std::vector<int> number(held.size(), -1);
  std::vector<Node> kept;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) continue;
    number[i] = static_cast<int>(kept.size());
    kept.push_back(figure.nodes[i]);
  }
  figure.nodes = std::move(kept);
  std::erase_if(figure.springs, [&](const Spring& spring) {
    return number[static_cast<std::size_t>(spring.from)] < 0 ||
           number[static_cast<std::size_t>(spring.to)] < 0;
  });
  for (Spring& spring : figure.springs) {
    spring.from = number[static_cast<std::size_t>(spring.from)];
    spring.to = number[static_cast<std::size_t>(spring.to)];
  }
}

void RemoveNode(Figure& figure, int node) {
  figure.nodes.erase(figure.nodes.begin() + node);
  std::erase_if(figure.springs,
                [node](const Spring& spring) { return spring.from == node || spring.to == node; });
  for (Spring& spring : figure.springs) {
    spring.from -= spring.from > node ? 1 : 0;
    spring.to -= spring.to > node ? 1 : 0;
  }
}

/// Calls back with a part's number and, if there is another one, its image's.
template <class Change>
void OnBothSides(int index, int image, const Change& change) {
  change(index);
  if (image >= 0 && image != index) change(image);
}

int ImageOf(const Figure& figure, SpringPart part, Mirror mirror) {
  if (!mirror) return -1;
  return part.kind == SpringPart::Kind::kNode ? ImageOfNode(figure, part.index, *mirror)
                                              : ImageOfSpring(figure, part.index, *mirror);
}

}  // namespace

int ImageOfNode(const Figure& figure, int node, float mirror_m) {
  const Node& here = figure.nodes[static_cast<std::size_t>(node)];
  const ImVec2 there = Image({here.x_m, here.y_m}, mirror_m);
  int nearest = -1;
  float within = kOnMirror;
  for (std::size_t other = 0; other < figure.nodes.size(); ++other) {
    const float distance = Distance(figure.nodes[other], there.x, there.y);
    if (distance >= within) continue;
    within = distance;
    nearest = static_cast<int>(other);
  }
  return nearest;
}

int ImageOfSpring(const Figure& figure, int spring, float mirror_m) {
  const Spring& here = figure.springs[static_cast<std::size_t>(spring)];
  const int from = ImageOfNode(figure, here.from, mirror_m), to = ImageOfNode(figure, here.to, mirror_m);
  if (from < 0 || to < 0) return -1;
  const auto there = std::ranges::find_if(figure.springs, [&](const Spring& other) {
    return std::minmax(other.from, other.to) == std::minmax(from, to);
  });
  return there == figure.springs.end() ? -1 : static_cast<int>(there - figure.springs.begin());
}

float MiddleOf(const Figure& figure) {
  const auto [left, right] = std::ranges::minmax(figure.nodes, {}, &Node::x_m);
  return 0.5f * (left.x_m + right.x_m);
}

Figure SpringBetween(ImVec2 from, ImVec2 to) {
  Figure figure;
  figure.nodes = {NodeAt(from), NodeAt(to)};
  figure.springs = {SpringOf(0, 1)};
  return figure;
}

Figure WithNodeAt(const Figure& figure, ImVec2 place, Mirror mirror) {
  Figure grown = figure;
  place = AtMirror(place, mirror);
  grown.nodes.push_back(NodeAt(place));
  JoinToNearest(grown, 2);
  if (mirror && !OnMirror(place.x, *mirror)) {
    grown.nodes.push_back(NodeAt(Image(place, *mirror)));
    JoinToNearest(grown, 2);
  }
  return grown;
}

Figure WithNodeFrom(const Figure& figure, int from, ImVec2 place, Mirror mirror) {
  Figure grown = figure;
  place = AtMirror(place, mirror);
  const auto add = [&](int start, ImVec2 at) {
    grown.nodes.push_back(NodeAt(at));
    Join(grown, start, static_cast<int>(grown.nodes.size()) - 1);
    JoinToNearest(grown, 2);
  };
  const int image = mirror ? ImageOfNode(figure, from, *mirror) : -1;
  add(from, place);
  if (image >= 0 && !OnMirror(place.x, *mirror)) add(image, Image(place, *mirror));
  return grown;
}

Figure WithNodeGrown(const Figure& figure, int node, Mirror mirror) {
  const Node& here = figure.nodes[static_cast<std::size_t>(node)];
  float length = 0.0f;
  for (const Spring& spring : figure.springs) length += DrawnLength(figure, spring);
  length = std::max(0.05f, length / static_cast<float>(figure.springs.size()));
  ImVec2 best;
  float most_room = -1.0f;
  // Upwards first, then to both sides in turn.
  for (int turn = 0; turn < 12; ++turn) {
    const int side = turn % 2 == 1 ? (turn + 1) / 2 : -turn / 2;
    const float angle = (0.5f + static_cast<float>(side) / 6.0f) * static_cast<float>(kPi);
    const ImVec2 place(here.x_m + length * std::cos(angle), here.y_m + length * std::sin(angle));
    float room = 2.0f * length;
    for (const Node& other : figure.nodes) room = std::min(room, Distance(other, place.x, place.y));
    if (room <= most_room + 0.01f * length) continue;
    most_room = room;
    best = place;
  }
  return WithNodeFrom(figure, node, best, mirror);
}

Figure WithSpring(const Figure& figure, int from, int to, Mirror mirror) {
  Figure joined = figure;
  Join(joined, from, to);
  if (!mirror) return joined;
  const int image_from = ImageOfNode(figure, from, *mirror), image_to = ImageOfNode(figure, to, *mirror);
  if (image_from >= 0 && image_to >= 0) Join(joined, image_from, image_to);
  return joined;
}

Figure WithNodeMoved(const Figure& figure, int node, ImVec2 place, Mirror mirror) {
  Figure moved = figure;
  const int image = mirror ? ImageOfNode(figure, node, *mirror) : -1;
  if (image == node) place.x = *mirror;  // what is on the mirror stays on it
  const auto put = [&](int index, ImVec2 at) {
    moved.nodes[static_cast<std::size_t>(index)].x_m = Rounded(at.x);
    moved.nodes[static_cast<std::size_t>(index)].y_m = Rounded(at.y);
  };
  put(node, place);
  if (image >= 0 && image != node) put(image, Image(place, *mirror));
  return moved;
}

Figure WithMuscleToggled(const Figure& figure, int spring, Mirror mirror) {
  Figure changed = figure;
  const bool muscle = !figure.springs[static_cast<std::size_t>(spring)].IsMuscle();
  OnBothSides(spring, ImageOf(figure, {SpringPart::Kind::kSpring, spring}, mirror), [&](int index) {
    Spring& one = changed.springs[static_cast<std::size_t>(index)];
    one.min_rest = muscle ? std::max(kLeastRest, kLeastMuscle * one.rest) : one.rest;
    one.max_rest = muscle ? std::min(kMostRest, kMostMuscle * one.rest) : one.rest;
  });
  return changed;
}

Figure Without(const Figure& figure, SpringPart part, Mirror mirror) {
  Figure rest = figure;
  std::vector<int> gone;
  OnBothSides(part.index, ImageOf(figure, part, mirror), [&](int index) { gone.push_back(index); });
  std::ranges::sort(gone, std::greater<>());  // the later one first, so that the other keeps its number
  for (const int index : gone) {
    if (part.kind == SpringPart::Kind::kNode) {
      RemoveNode(rest, index);
    } else {
      rest.springs.erase(rest.springs.begin() + index);
    }
  }
  DropLoose(rest);
  return rest;
}

Figure WithNode(const Figure& figure, int node, const Node& as, Mirror mirror) {
  Figure changed = figure;
  const Node& before = figure.nodes[static_cast<std::size_t>(node)];
  if (as.x_m != before.x_m || as.y_m != before.y_m)
    changed = WithNodeMoved(figure, node, {as.x_m, as.y_m}, mirror);
  OnBothSides(node, ImageOf(figure, {SpringPart::Kind::kNode, node}, mirror),
              [&](int index) { changed.nodes[static_cast<std::size_t>(index)].mass_kg = as.mass_kg; });
  return changed;
}

Figure WithSpringAs(const Figure& figure, int spring, const Spring& as, Mirror mirror) {
  Figure changed = figure;
  OnBothSides(spring, ImageOf(figure, {SpringPart::Kind::kSpring, spring}, mirror), [&](int index) {
    Spring& one = changed.springs[static_cast<std::size_t>(index)];
    one = {.from = one.from,
           .to = one.to,
           .stiffness_npm = as.stiffness_npm,
           .damping_nspm = as.damping_nspm,
           .rest = as.rest,
           .min_rest = as.min_rest,
           .max_rest = as.max_rest};
  });
  return changed;
}

Figure WithStiffness(const Figure& figure, float times) {
  const float most = 0.99f * kStiffest / std::max(FastestVibration(figure), 1.0f);
  times = std::min(times, most);
  Figure changed = figure;
  for (Spring& spring : changed.springs) {
    spring.stiffness_npm = std::clamp(spring.stiffness_npm * times, 1.0f, 1e6f);
    spring.damping_nspm = std::min(spring.damping_nspm * std::sqrt(times), 1e6f);
  }
  return changed;
}

const char* StiffnessWords(const Figure& figure) {
  float mass = 0.0f, stiffness = 0.0f;
  for (const Node& node : figure.nodes) mass += node.mass_kg;
  for (const Spring& spring : figure.springs) stiffness += spring.stiffness_npm;
  if (figure.springs.empty()) return Tr("soft");
  // A typical spring under half of the figure, as a share of the figure's size.
  const float sag = 0.5f * mass * kStandardGravity /
                    (stiffness / static_cast<float>(figure.springs.size()) * SizeOf(figure));
  return sag > 0.05f ? Tr("soft") : sag > 0.005f ? Tr("firm") : Tr("stiff");
}

Figure MirroredSprings(const Figure& figure) {
  Figure mirrored = figure;
  const float middle = MiddleOf(figure);
  for (Node& node : mirrored.nodes) node.x_m = 2.0f * middle - node.x_m;
  return mirrored;
}

}  // namespace gaitsmith::shell
