// SPDX-License-Identifier: MIT
#include "shell/results/front_map.h"

#include <functional>
#include <string_view>

#include "shell/results/found_motions.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"

namespace gaitsmith::shell {

std::optional<FrontMap> FrontMap::Of(const Document& searched, std::span<const std::uint8_t> state) {
  if (searched.search.algorithm != Algorithm::kNsga || state.empty()) return std::nullopt;
  auto front = FrontOf(searched.search, ProblemOf(searched).Shape().Genes(), state);
  if (!front || front->empty()) return std::nullopt;
  FrontMap map;
  map.searched_ = searched;
  map.front_ = std::move(*front);
  map.sum_ = std::hash<std::string_view>{}({reinterpret_cast<const char*>(state.data()), state.size()});
  return map;
}

std::string FrontMap::Title() const { return SearchTitle(searched_) + ", " + SearchLine(searched_); }

std::string FrontMap::CostName() const {
  if (searched_.search.cost == Cost::kSlip) return Tr("Slip, sizes of the figure a second");
  return searched_.figure.HasSprings() ? Tr("Effort, lengths a second and muscle")
                                       : Tr("Effort, radians a second and joint");
}

std::string FrontMap::Name(std::size_t i) const { return std::to_string(sum_) + "/" + std::to_string(i); }

Document FrontMap::MotionAt(std::size_t i) const { return FoundDocument(searched_, front_[i].genome); }

}  // namespace gaitsmith::shell
