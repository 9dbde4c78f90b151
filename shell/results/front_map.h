// SPDX-License-Identifier: MIT
// The result of NSGA-II: the best motions for every price, from the cheapest to the one that scores most.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/evolution/nsga.h"

namespace gaitsmith::shell {

class FrontMap {
 public:
  /// @param searched the document that was searched. @param state of its search (Search::Save)
  /// @return nothing if the state is not from an NSGA-II search of the document, or nothing was found
  [[nodiscard]] static std::optional<FrontMap> Of(const Document& searched,
                                                  std::span<const std::uint8_t> state);

  [[nodiscard]] const Figure& Whose() const { return searched_.figure; }
  /// The search's problem and algorithm.
  [[nodiscard]] std::string Title() const;
  /// At least 1. All that follow are by rising score, and so by rising cost.
  [[nodiscard]] std::size_t Count() const { return front_.size(); }
  [[nodiscard]] float Score(std::size_t i) const { return front_[i].aims.score; }
  [[nodiscard]] float Cost(std::size_t i) const { return 0.0f - front_[i].aims.thrift; }
  /// What the cost is, with its unit, as a person reads it.
  [[nodiscard]] std::string CostName() const;
  /// Identifies the front and one of its motions, to remember a picture of it.
  [[nodiscard]] std::string Name(std::size_t i) const;
  [[nodiscard]] Document MotionAt(std::size_t i) const;

 private:
  Document searched_;
  std::vector<Compromise> front_;
  std::size_t sum_ = 0;  // of the state's bytes: tells two fronts apart
};

}  // namespace gaitsmith::shell
