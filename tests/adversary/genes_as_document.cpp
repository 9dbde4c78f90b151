// SPDX-License-Identifier: MIT
#include "tests/adversary/genes_as_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/document/joints.h"
#include "core/document/json.h"
#include "core/numeric/scalar_math.h"
#include "core/rollout/models.h"

namespace gaitsmith::test {

namespace {

constexpr int kSteps = 150;
constexpr int kRules = 3;

/// Reads numbers from genes, one after another, and starts again after the last.
class Reader {
 public:
  explicit Reader(std::span<const Gene> genes) : genes_(genes) {}

  Gene Next() { return genes_[at_++ % genes_.size()]; }
  /// The outer tenth of the gene's range on either side gives the limit itself, so that extremes are tried.
  float Between(float low, float high) {
    const float share = std::clamp(static_cast<float>(Next()) * (1.25f / 65535.0f) - 0.125f, 0.0f, 1.0f);
    return share >= 1.0f ? high : low + (high - low) * share;
  }
  /// The same on a logarithmic scale.
  float Magnitude(float low, float high) {
    const float power = Between(0.0f, 1.0f);
    const double from = Log(static_cast<double>(low)), to = Log(static_cast<double>(high));
    return std::clamp(static_cast<float>(Exp(from + (to - from) * static_cast<double>(power))), low, high);
  }
  int Below(int count) {
    return static_cast<int>(static_cast<std::uint32_t>(Next()) * static_cast<std::uint32_t>(count) >> 16);
  }

 private:
  std::span<const Gene> genes_;
  std::size_t at_ = 0;
};

Figure FigureOf(bool any, Reader& read) {
  Figure figure;
  const int rods = 1 + read.Below(any ? kMaxRods : 7);
  const bool folded = any && read.Below(8) == 0;
  for (int i = 0; i < rods; ++i) {
    Rod rod;
    rod.length_m = any ? read.Magnitude(0.001f, 1000.0f) : read.Between(0.2f, 2.0f);
    rod.mass_kg = any ? read.Magnitude(1e-6f, 1e6f) : read.Between(0.2f, 5.0f);
    rod.rest_rad = folded && i > 0 ? 3.1415927f : read.Between(-3.1415927f, 3.1415927f);
    rod.min_rad = any ? read.Between(-3.1415927f, 0.0f) : -1.0f;
    rod.max_rad = any ? read.Between(0.0f, 3.1415927f) : 1.0f;
    const int parent = read.Below(std::max(1, i));
    rod.parent = i == 0 ? kNoParent : parent;
    rod.parent_end = read.Below(2) == 0 ? RodEnd::kStart : RodEnd::kEnd;
    figure.rods.push_back(rod);
  }
  return figure;
}

/// Nodes, each held by a spring to an earlier one, and further springs. Masses are raised until the stiffness
/// at each node is one that a document may hold.
Figure SpringsOf(bool any, Reader& read) {
  Figure figure;
  const int nodes = 2 + read.Below(any ? kMaxPoints - 1 : 9);
  for (int i = 0; i < nodes; ++i) {
    const float most = any ? read.Magnitude(0.01f, 1000.0f) : 0.6f;
    figure.nodes.push_back({.x_m = read.Between(-most, most),
                            .y_m = read.Between(-most, most),
                            .mass_kg = any ? read.Magnitude(1e-6f, 1e6f) : read.Between(0.05f, 1.0f)});
  }
  const auto join = [&](int from, int to) {
    Spring spring{.from = from, .to = to};
    spring.stiffness_npm = any ? read.Magnitude(1e-3f, 1e6f) : read.Magnitude(100.0f, 5000.0f);
    spring.damping_nspm = any ? read.Magnitude(1e-3f, 1e6f) : read.Between(0.0f, 10.0f);
    spring.rest = any ? read.Between(kLeastRest, kMostRest) : 1.0f;
    spring.min_rest = spring.max_rest = spring.rest;
    if (read.Below(2) == 0 && figure.Muscles() < kMaxMuscles) {
      spring.min_rest = any ? read.Between(kLeastRest, spring.rest) : 0.6f;
      spring.max_rest = any ? read.Between(spring.rest, kMostRest) : 1.4f;
    }
    const bool there = std::ranges::any_of(figure.springs, [&](const Spring& other) {
      return std::minmax(other.from, other.to) == std::minmax(from, to);
    });
    const bool apart = DrawnLength(figure, spring) >= kShortestSpring;
    if (from != to && !there && apart && figure.springs.size() < kMaxSprings)
      figure.springs.push_back(spring);
    return apart;
  };
  for (int i = 1; i < nodes; ++i) {
    const int earlier = read.Below(i);
    if (join(i, earlier)) continue;
    figure.nodes[static_cast<std::size_t>(i)].x_m =
        figure.nodes[static_cast<std::size_t>(earlier)].x_m < 0.0f ? 500.0f : -500.0f;
    join(i, earlier);
  }
  for (int more = read.Below(2 * nodes); more > 0; --more) {
    const int from = read.Below(nodes), to = read.Below(nodes);
    join(from, to);
  }
  for (int node = 0; FastestVibration(figure, &node) > kStiffest;)
    figure.nodes[static_cast<std::size_t>(node)].mass_kg *= 2.0f;
  return figure;
}

/// The shipped figures of rods, or of springs, read once.
const std::vector<Figure>& ShippedFigures(bool springs) {
  static const std::array<std::vector<Figure>, 2> kFigures = [] {
    std::array<std::vector<Figure>, 2> figures;
    for (const std::string name :
         {"mr-star-man", "beryl-biped", "horse", "hopper", "inchworm", "five-rod-fred", "fish", "jelly",
          "soft-star", "soft-wheel", "soft-worm", "walking-table"}) {
      std::ifstream in(std::string(GAITSMITH_SOURCE_DIR "/examples/figures/") + name + ".json");
      const std::string text(std::istreambuf_iterator<char>(in), {});
      if (auto figure = DecodeFigureJson(text)) figures[figure->HasSprings() ? 1 : 0].push_back(*figure);
    }
    return figures;
  }();
  return kFigures[springs ? 1 : 0];
}

Push PushOf(bool any, const Figure& figure, Reader& read) {
  Push push;
  push.step = read.Below(kSteps);
  push.endpoint = read.Below(figure.Endpoints() + 1) - 1;
  const float most = any ? read.Magnitude(1e-3f, 1e6f) : 10.0f;
  push.impulse_x_ns = read.Between(-most, most);
  push.impulse_y_ns = read.Between(-most, most);
  return push;
}

/// Sets what the joints can do: all the same, or each its own in any world. A strength of 1000 is as good as
/// no limit.
void SetJoints(Scope scope, Reader& read, Document& d) {
  const bool any = scope == Scope::kAny;
  const bool alike = !any || read.Below(2) == 0;
  float strength = 0.0f, stiffness = 0.0f;
  for (Rod& rod : d.figure.rods) {
    if (!alike || stiffness == 0.0f) {
      const int kind = read.Below(8);
      strength = kind == 0 ? 0.0f : kind == 1 ? 1000.0f : read.Magnitude(0.1f, 100.0f);
      stiffness = any ? read.Magnitude(1.0f, 1e6f) : read.Magnitude(1e3f, 1e6f);
    }
    rod.strength = strength;
    rod.stiffness = stiffness;
  }
}

void SetSenses(Scope scope, Reader& read, SenseSpec& senses) {
  senses.kind = std::array{SenseKind::kTimer, SenseKind::kPhysical,
                           SenseKind::kSight}[static_cast<std::size_t>(read.Below(3))];
  senses.period_steps = 2 + read.Below(kSteps);
  senses.tau_min_s = scope == Scope::kOrdinary ? 0.07f : 0.02f;
  if (senses.kind != SenseKind::kSight) return;
  senses.sight_rods = scope == Scope::kAny ? read.Magnitude(0.5f, 20.0f) : 2.0f;
  senses.facing = read.Below(2) == 0 ? Facing::kRight : Facing::kLeft;
}

/// Sets everything except joints and controller.
void SetScene(bool any, bool springs, Reader& read, Document& d) {
  d.figure = springs ? SpringsOf(any, read) : FigureOf(any, read);
  d.environment.gravity_mps2 = any ? read.Between(0.0f, 100.0f) : read.Between(1.0f, 20.0f);
  d.environment.friction = any ? read.Between(0.0f, 10.0f) : read.Between(0.0f, 1.5f);
  d.environment.slope_rad = any ? read.Between(-0.6f, 0.6f) : read.Between(-0.2f, 0.2f);
  d.environment.sway_rad = read.Below(3) == 0 ? read.Between(0.0f, any ? 0.6f : 0.2f) : 0.0f;
  d.environment.sway_period_s = any ? read.Between(0.5f, 60.0f) : read.Between(2.0f, 8.0f);
  d.start.drop_height_m = read.Below(2) == 0 ? 0.0f : read.Between(0.0f, any ? 100.0f : 1.0f);
  const float speed = any ? read.Magnitude(0.1f, 100.0f) : 3.0f;
  d.start.velocity_x_mps = read.Between(-speed, speed);
  d.start.velocity_y_mps = read.Between(-speed, any ? speed : 1.0f);
  d.start.spin_radps = any ? read.Between(-40.0f, 40.0f) : read.Between(-6.0f, 6.0f);
  for (int pushes = read.Below(3); pushes > 0; --pushes) d.pushes.push_back(PushOf(any, d.figure, read));
  std::ranges::sort(d.pushes, {}, &Push::step);
}

}  // namespace

SearchSpace SpaceOfDocuments() {
  // The genes of a network are plain numbers, so no operator reorders them.
  int hidden = 1;
  while (NetworkShape(hidden, 8).Genes() < kDocumentGenes) ++hidden;
  return {{ControllerKind::kNetwork, hidden, SenseKind::kPhysical, 8}, {}, {}};
}

Document DocumentOf(Scope scope, int model, bool still, std::span<const Gene> genes) {
  const bool any = scope == Scope::kAny, springs = model == kSpringModel;
  Reader read(genes.first(std::min(genes.size(), kDocumentGenes)));
  Document d;
  if (scope == Scope::kGait) {
    const std::vector<Figure>& figures = ShippedFigures(springs);
    d.figure = figures[static_cast<std::size_t>(read.Below(static_cast<int>(figures.size())))];
  } else {
    SetScene(any, springs, read, d);
  }
  d.model = model;
  if (HasLimitedJoints(d)) SetJoints(scope, read, d);
  SetSenses(scope, read, d.senses);
  const bool other_kind = read.Below(2) == 0;
  if (other_kind && d.senses.kind == SenseKind::kPhysical && !springs) d.kind = ControllerKind::kNetwork;
  if (other_kind && d.senses.kind == SenseKind::kTimer) d.kind = ControllerKind::kTrajectory;
  d.rules = kRules;
  d.task.duration_steps = d.duration_steps = kSteps;
  if (still) return d;
  Controller controller{"", d.kind, d.senses, d.rules, {}};
  const ControllerShape shape = controller.Shape(CountPorts(model, d.figure));
  for (std::size_t gene = 0; gene < shape.Genes(); ++gene) controller.genes.push_back(read.Next());
  if (d.kind == ControllerKind::kRules) {
    const BankShape& bank = shape.Bank();
    for (int rule = 0; rule < bank.rules; ++rule) {
      for (int sense = 0; sense < bank.senses; ++sense) {
        Gene& low = controller.genes[bank.Low(rule, sense)];
        Gene& high = controller.genes[bank.High(rule, sense)];
        // Most of many senses must be ignored, or no rule ever matches.
        if (d.senses.kind != SenseKind::kTimer && (low ^ high) % 5 != 0) {
          low = 0;
          high = kGeneMax;
        }
        if (low > high) std::swap(low, high);
      }
    }
  }
  d.controllers = {controller};
  d.timeline = {{.controller = 0, .start_step = 0}};
  return d;
}

}  // namespace gaitsmith::test
