// SPDX-License-Identifier: MIT
#include "shell/results/elite_map.h"

#include <algorithm>
#include <functional>
#include <string_view>

#include "shell/results/found_motions.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

std::optional<EliteMap> EliteMap::Of(const Document& searched, std::span<const std::uint8_t> state) {
  if (!KeepsElites(searched.search.algorithm) || state.empty()) return std::nullopt;
  const auto elites = ElitesOf(searched.search, ProblemOf(searched).Shape().Genes(), state);
  if (!elites) return std::nullopt;
  EliteMap map;
  map.searched_ = searched;
  map.bins_ = searched.search.elites.bins;
  map.cells_ = elites->Cells();
  map.sum_ = std::hash<std::string_view>{}({reinterpret_cast<const char*>(state.data()), state.size()});
  map.ranges_.fill({map.bins_, -1});
  for (std::size_t cell = 0; cell < map.cells_.size(); ++cell) {
    const Elite& elite = map.cells_[cell];
    if (elite.genome.empty()) continue;
    const bool first = map.ranges_[0].last < 0;
    map.least_ = first ? elite.score.fitness : std::min(map.least_, elite.score.fitness);
    map.best_ = first ? elite.score.fitness : std::max(map.best_, elite.score.fitness);
    auto rest = static_cast<int>(cell);
    for (std::size_t axis = map.ranges_.size(); axis-- > 0; rest /= map.bins_) {
      Range& range = map.ranges_[axis];
      range = {std::min(range.first, rest % map.bins_), std::max(range.last, rest % map.bins_)};
    }
  }
  if (map.ranges_[0].last < 0) return std::nullopt;
  return map;
}

std::string EliteMap::Title() const { return SearchTitle(searched_) + ", " + SearchLine(searched_); }

int EliteMap::Count() const {
  return static_cast<int>(
      std::ranges::count_if(cells_, [](const Elite& elite) { return !elite.genome.empty(); }));
}

int EliteMap::Count(int turns) const {
  int count = 0;
  for (int height = 0; height < bins_; ++height) {
    for (int slip = 0; slip < bins_; ++slip) count += At(height, slip, turns) != nullptr ? 1 : 0;
  }
  return count;
}

const Elite* EliteMap::At(int height, int slip, int turns) const {
  const Elite& elite = cells_[Index(height, slip, turns)];
  return elite.genome.empty() ? nullptr : &elite;
}

std::string EliteMap::RangeText(int axis, int bin) const {
  const float width = BinWidth(axis);
  const std::string low = Fixed(width * static_cast<float>(bin), 2);
  if (bin == bins_ - 1) return Tr("from {1}", low);
  return Tr("{1} to {2}", low, Fixed(width * static_cast<float>(bin + 1), 2));
}

std::string EliteMap::LowText(int axis) const {
  return Fixed(BinWidth(axis) * static_cast<float>(RangeOf(axis).first), 1);
}

std::string EliteMap::HighText(int axis) const {
  const int end = RangeOf(axis).last + 1;
  return Fixed(BinWidth(axis) * static_cast<float>(end), 1) + (end == bins_ ? "+" : "");
}

std::string EliteMap::CellName(int height, int slip, int turns) const {
  return std::to_string(sum_) + "/" + std::to_string(Index(height, slip, turns));
}

Document EliteMap::MotionAt(int height, int slip, int turns) const {
  return FoundDocument(searched_, cells_[Index(height, slip, turns)].genome);
}

}  // namespace gaitsmith::shell
