// SPDX-License-Identifier: MIT
#include "core/search/two_stage.h"

#include <algorithm>
#include <numeric>

namespace gaitsmith {

std::vector<Genome> TwoStage::Propose() const {
  std::vector<Genome> batch;
  if (kept_.empty()) {
    for (int i = 0; i < Settings().two_stage.random; ++i) batch.push_back(First(i));
    return batch;
  }
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    RandomStream random = Stream(static_cast<int>(i), generation_);
    batch.push_back(Perturb(kept_[i].genome, Space().shape, Space().senses, Settings().variation, random));
  }
  return batch;
}

void TwoStage::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  ++generation_;
  if (!kept_.empty()) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (scores[i].fitness > kept_[i].fitness) kept_[i] = {batch[i], scores[i].fitness};
    }
    return;
  }
  std::vector<std::size_t> order(batch.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return scores[a].fitness != scores[b].fitness ? scores[a].fitness > scores[b].fitness : a < b;
  });
  order.resize(std::min(order.size(), static_cast<std::size_t>(Settings().two_stage.kept)));
  for (const std::size_t i : order) kept_.push_back({batch[i], scores[i].fitness});
}

void TwoStage::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  PutPopulation(out, kept_);
}

bool TwoStage::LoadState(BitReader& in) {
  const auto size =
      static_cast<std::size_t>(std::min(Settings().two_stage.kept, Settings().two_stage.random));
  return TakeCount(in, generation_, Settings().evaluations) &&
         TakePopulation(in, kept_, size, Space().shape.Genes()) &&
         kept_.size() == (generation_ > 0 ? size : 0);
}

std::unique_ptr<Search> MakeTwoStage(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<TwoStage>(settings, space);
}

}  // namespace gaitsmith
