// SPDX-License-Identifier: MIT
#include "shell/results/elite_map.h"

#include <algorithm>

#include "core/numeric/bit_stream.h"
#include "shell/results/found_motions.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

std::optional<EliteMap> EliteMap::Of(const Document& searched, std::span<const std::uint8_t> state) {
  if (searched.search.algorithm != Algorithm::kMapElites || state.empty()) return std::nullopt;
  // Only read, so it needs no genome to start from and looks at no motion.
  const Problem problem = ProblemOf(searched);
  MapElites search(searched.search, {problem.Shape(), problem.senses, {}, {}});
  BitReader in(state);
  if (!search.Load(in)) return std::nullopt;
  EliteMap map;
  map.searched_ = searched;
  map.bins_ = searched.search.elites.bins;
  map.cells_ = search.Cells();
  bool first = true;
  for (const MapElites::Elite& elite : map.cells_) {
    if (elite.genome.empty()) continue;
    map.least_ = first ? elite.score.fitness : std::min(map.least_, elite.score.fitness);
    map.best_ = first ? elite.score.fitness : std::max(map.best_, elite.score.fitness);
    first = false;
  }
  if (first) return std::nullopt;
  return map;
}

std::string EliteMap::Title() const { return SearchTitle(searched_) + ", " + SearchLine(searched_); }

int EliteMap::Count() const {
  return static_cast<int>(
      std::ranges::count_if(cells_, [](const MapElites::Elite& elite) { return !elite.genome.empty(); }));
}

int EliteMap::Count(int turns) const {
  int count = 0;
  for (int height = 0; height < bins_; ++height) {
    for (int slip = 0; slip < bins_; ++slip) count += At(height, slip, turns) != nullptr ? 1 : 0;
  }
  return count;
}

const MapElites::Elite* EliteMap::At(int height, int slip, int turns) const {
  const MapElites::Elite& elite = cells_[Index(height, slip, turns)];
  return elite.genome.empty() ? nullptr : &elite;
}

std::string EliteMap::RangeText(int axis, int bin) const {
  const float width =
      searched_.search.elites.most[static_cast<std::size_t>(axis)] / static_cast<float>(bins_);
  const std::string low = Fixed(width * static_cast<float>(bin), 2);
  if (bin == bins_ - 1) return Tr("from {1}", low);
  return Tr("{1} to {2}", low, Fixed(width * static_cast<float>(bin + 1), 2));
}

Document EliteMap::MotionAt(int height, int slip, int turns) const {
  return FoundDocument(searched_, cells_[Index(height, slip, turns)].genome);
}

}  // namespace gaitsmith::shell
