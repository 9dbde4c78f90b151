// SPDX-License-Identifier: MIT
#include "core/search/pose_cycle_form.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

constexpr double kMinHalfWidth = 0.02;    // of a box around a joint's normalised angle, at width 0
constexpr double kHalfWidthRatio = 25.0;  // the half-width at width 1, as a multiple of it
constexpr double kMinShare = 0.15;        // of a pose in a timer's period, before normalising

/// The numbers of a point, pose by pose.
class Poses {
 public:
  Poses(std::span<const double> point, int joints) : point_(point), joints_(joints) {}
  [[nodiscard]] double Angle(int pose, int joint) const { return At(pose, joint); }
  [[nodiscard]] double Tau(int pose) const { return At(pose, joints_); }
  /// The width, or the share of the period.
  [[nodiscard]] double Extent(int pose) const { return At(pose, joints_ + 1); }

 private:
  [[nodiscard]] double At(int pose, int number) const {
    const std::size_t at = static_cast<std::size_t>(pose) * static_cast<std::size_t>(joints_ + 2);
    return std::clamp(point_[at + static_cast<std::size_t>(number)], 0.0, 1.0);
  }

  std::span<const double> point_;
  int joints_;
};

/// The gene of a normalised sense, whose genes reach beyond [0, 1].
Gene SenseGene(double sense) {
  constexpr Edges kEdges = EdgesOf(SenseKind::kPhysical);
  constexpr auto kLow = static_cast<double>(kEdges.low), kHigh = static_cast<double>(kEdges.high);
  return GeneOf((sense - kLow) / (kHigh - kLow));
}

}  // namespace

Gene GeneOf(double share) {
  return static_cast<Gene>(std::clamp(share * kGeneMax + 0.5, 0.0, static_cast<double>(kGeneMax)));
}

void IgnoreAll(Genome& genes, const BankShape& bank, int rule) {
  for (int sense = 0; sense < bank.senses; ++sense) {
    genes[bank.Low(rule, sense)] = 0;
    genes[bank.High(rule, sense)] = kGeneMax;
  }
}

void Silence(Genome& genes, const BankShape& bank, int rule) {
  IgnoreAll(genes, bank, rule);
  genes[bank.Low(rule, 0)] = kGeneMax;
}

CycleForm DrawForm(const BankShape& bank, SenseKind senses, RandomStream& random) {
  CycleForm form;
  form.poses = std::min(senses == SenseKind::kTimer ? 3 : 2, bank.rules);
  if (senses != SenseKind::kTimer) return form;
  form.repeats = 1 + static_cast<int>(random.Below(static_cast<std::uint32_t>(bank.rules / form.poses)));
  return form;
}

std::vector<double> DrawPoint(const CycleForm& form, const BankShape& bank, RandomStream& random) {
  std::vector<double> point;
  point.reserve(DimensionsOf(form, bank));
  for (int pose = 0; pose < form.poses; ++pose) {
    for (int joint = 0; joint < bank.joints; ++joint) {
      const double u = random.Uniform();
      point.push_back(u * u * (3.0 - 2.0 * u));  // nearer the ends than u
    }
    const double slow = random.Uniform();
    point.push_back(slow * slow * slow * slow);
    point.push_back(std::sqrt(random.Uniform()));
  }
  return point;
}

Genome CycleAt(const CycleForm& form, std::span<const double> point, const BankShape& bank,
               SenseKind senses) {
  const int joints = bank.joints;
  const Poses poses(point, joints);
  Genome genes(bank.Genes());
  double shares = 0.0;
  for (int pose = 0; pose < form.poses; ++pose) shares += kMinShare + poses.Extent(pose);

  double phase = 0.0;  // share of the period that the rules so far take
  for (int rule = 0; rule < bank.rules; ++rule) {
    const bool acts = rule < form.poses * form.repeats;
    const int pose = rule % form.poses;
    for (int joint = 0; joint < joints; ++joint) {
      genes[bank.Target(rule, joint)] = GeneOf(acts ? poses.Angle(pose, joint) : 0.5);
    }
    genes[bank.Tau(rule)] = GeneOf(acts ? poses.Tau(pose) : 0.0);
    if (!acts) {
      Silence(genes, bank, rule);
      continue;
    }
    IgnoreAll(genes, bank, rule);
    if (senses == SenseKind::kTimer) {
      const double share = (kMinShare + poses.Extent(pose)) / (shares * form.repeats);
      genes[bank.Low(rule, 0)] = GeneOf(phase);
      genes[bank.High(rule, 0)] = GeneOf(phase + share);
      phase += share;
      continue;
    }
    const int before = (pose + form.poses - 1) % form.poses;
    const double half = kMinHalfWidth * Exp(poses.Extent(pose) * Log(kHalfWidthRatio));
    for (int joint = 0; joint < joints; ++joint) {
      genes[bank.Low(rule, joint)] = SenseGene(poses.Angle(before, joint) - half);
      genes[bank.High(rule, joint)] = SenseGene(poses.Angle(before, joint) + half);
    }
  }
  return genes;
}

Genome CycleAt(const CycleForm& form, std::span<const double> point, const CurveShape& curves) {
  const Poses poses(point, curves.joints);
  double shares = 0.0;
  for (int pose = 0; pose < form.poses; ++pose) shares += kMinShare + poses.Extent(pose);
  Genome genes(curves.Genes());
  for (int knot = 0; knot < curves.knots; ++knot) {
    const double turns = static_cast<double>(knot * form.repeats) / curves.knots;
    double within = (turns - static_cast<double>(static_cast<int>(turns))) * shares;
    int pose = 0;
    while (pose + 1 < form.poses && within >= kMinShare + poses.Extent(pose))
      within -= kMinShare + poses.Extent(pose++);
    const int before = (pose + form.poses - 1) % form.poses;
    const double moves = poses.Tau(pose) * (kMinShare + poses.Extent(pose));
    const double there = within < moves ? within / moves : 1.0;
    for (int joint = 0; joint < curves.joints; ++joint) {
      const double from = poses.Angle(before, joint);
      genes[curves.Angle(knot, joint)] = GeneOf(from + there * (poses.Angle(pose, joint) - from));
    }
  }
  return genes;
}

}  // namespace gaitsmith
