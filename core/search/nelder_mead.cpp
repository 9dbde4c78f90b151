// SPDX-License-Identifier: MIT
#include "core/search/nelder_mead.h"

#include <algorithm>
#include <cstdlib>

namespace gaitsmith {

std::vector<Genome> NelderMead::Edges(const Genome& start) const {
  const auto step = static_cast<double>(Settings().refine.step);
  RandomStream random = Stream(1, beginnings_);
  std::vector<Genome> vertices;
  vertices.reserve(start.size());
  std::vector<double> point = PointOf(start);
  for (double& x : point) {
    const double before = x;
    const bool up = beginnings_ == 0 || random.Chance(0.5);
    x += up ? step : -step;
    if (x < 0.0 || x > 1.0) x = before + (up ? -step : step);
    vertices.push_back(GenomeAt(point, Space().shape));
    x = before;
  }
  return vertices;
}

Genome NelderMead::Beyond(double factor) const {
  const std::size_t genes = Space().shape.Genes();
  std::vector<double> point(genes);
  // Sums of integers are exact in any order.
  for (std::size_t i = 0; i + 1 < simplex_.size(); ++i) {
    for (std::size_t gene = 0; gene < genes; ++gene) point[gene] += simplex_[i].genome[gene];
  }
  for (std::size_t gene = 0; gene < genes; ++gene) {
    const double middle = point[gene] / (static_cast<double>(genes) * kGeneMax);
    point[gene] = middle + factor * (middle - simplex_.back().genome[gene] * (1.0 / kGeneMax));
  }
  return GenomeAt(point, Space().shape);
}

std::vector<Genome> NelderMead::Propose() const {
  switch (move_) {
    case Move::kBegin: {
      if (!simplex_.empty()) return Edges(simplex_.front().genome);
      std::vector<Genome> batch = {First(0)};
      for (Genome& vertex : Edges(batch.front())) batch.push_back(std::move(vertex));
      return batch;
    }
    case Move::kReflect:
      return {Beyond(1.0)};
    case Move::kExpand:
      return {Beyond(2.0)};
    case Move::kContract:
      return {Beyond(reflected_.fitness > simplex_.back().fitness ? 0.5 : -0.5)};
    case Move::kShrink:
      break;
  }
  std::vector<Genome> batch;
  const std::vector<double> best = PointOf(simplex_.front().genome);
  for (std::size_t i = 1; i < simplex_.size(); ++i) {
    std::vector<double> point = PointOf(simplex_[i].genome);
    for (std::size_t gene = 0; gene < point.size(); ++gene) {
      point[gene] = best[gene] + 0.5 * (point[gene] - best[gene]);
    }
    batch.push_back(GenomeAt(point, Space().shape));
  }
  return batch;
}

void NelderMead::ReplaceWorst(Individual vertex) {
  simplex_.pop_back();
  const auto place =
      std::ranges::upper_bound(simplex_, vertex.fitness, std::ranges::greater{}, &Individual::fitness);
  simplex_.insert(place, std::move(vertex));
  reflected_ = {};
  move_ = Move::kReflect;
}

void NelderMead::Shrink(std::span<const Genome> batch, std::span<const Score> scores) {
  if (!simplex_.empty()) simplex_.resize(1);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const auto place =
        std::ranges::upper_bound(simplex_, scores[i].fitness, std::ranges::greater{}, &Individual::fitness);
    simplex_.insert(place, {batch[i], scores[i].fitness});
  }
  reflected_ = {};
  move_ = Move::kReflect;
}

bool NelderMead::Collapsed() const {
  return std::ranges::all_of(simplex_, [&](const Individual& vertex) {
    return std::ranges::equal(vertex.genome, simplex_.front().genome,
                              [](Gene a, Gene b) { return std::abs(int{a} - int{b}) <= 1; });
  });
}

void NelderMead::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  const float fitness = scores[0].fitness;
  switch (move_) {
    case Move::kBegin:
      ++beginnings_;
      Shrink(batch, scores);
      return;
    case Move::kReflect:
      if (fitness > simplex_.front().fitness) {
        reflected_ = {batch[0], fitness};
        move_ = Move::kExpand;
      } else if (fitness > simplex_[simplex_.size() - 2].fitness) {
        ReplaceWorst({batch[0], fitness});
      } else {
        reflected_ = {batch[0], fitness};
        move_ = Move::kContract;
      }
      return;
    case Move::kExpand:
      ReplaceWorst(fitness > reflected_.fitness ? Individual{batch[0], fitness} : reflected_);
      return;
    case Move::kContract:
      if (fitness > simplex_.back().fitness && fitness >= reflected_.fitness) {
        ReplaceWorst({batch[0], fitness});
      } else {
        move_ = Move::kShrink;
      }
      break;
    case Move::kShrink:
      Shrink(batch, scores);
      break;
  }
  if (!Collapsed()) return;
  simplex_.resize(1);
  reflected_ = {};
  move_ = Move::kBegin;
}

void NelderMead::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(beginnings_), 32);
  out.Put(static_cast<std::uint64_t>(move_), 3);
  PutGenome(out, reflected_.genome, reflected_.fitness);
  PutPopulation(out, simplex_);
}

bool NelderMead::LoadState(BitReader& in) {
  const std::size_t genes = Space().shape.Genes();
  if (!TakeCount(in, beginnings_, Settings().evaluations)) return false;
  const auto move = in.Take(3);
  if (move > static_cast<std::uint64_t>(Move::kShrink)) return false;
  move_ = static_cast<Move>(move);
  if (!TakeGenome(in, reflected_.genome, reflected_.fitness, genes)) return false;
  if (!TakePopulation(in, simplex_, genes + 1, genes)) return false;
  const bool whole = simplex_.size() == genes + 1;
  return (move_ == Move::kBegin ? simplex_.size() == (beginnings_ > 0 ? 1 : 0) : whole) &&
         std::ranges::is_sorted(simplex_, std::ranges::greater{}, &Individual::fitness);
}

std::unique_ptr<Search> MakeNelderMead(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<NelderMead>(settings, space);
}

}  // namespace gaitsmith
