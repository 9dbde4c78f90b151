// SPDX-License-Identifier: MIT
// Documents that come with the program: figures, problems and motions.
#pragma once

#include <optional>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// Mr. Star-Man: five equal rods from one hub.
[[nodiscard]] Figure StandardFigure();

/// Sets the search that the page begins with: pose-cycle with 4,000 evaluations, a tenth of the paper's
/// budget (docs/search.md). Keeps the seed. Documents of core and of the command line begin with SPHC.
void BeginWithQuickSearch(SearchSettings&);

class ShippedDocuments {
 public:
  ShippedDocuments();
  [[nodiscard]] const std::vector<Figure>& Figures() const { return figures_; }
  /// Figures, each with a task and suitable senses.
  [[nodiscard]] const std::vector<Document>& Problems() const { return problems_; }
  /// The motion for a first visit: the standard figure shuffles. The next search is the quick one.
  [[nodiscard]] Document FirstMotion() const;
  /// The standard figure, standing still, with the senses that let it learn most and the quick search.
  [[nodiscard]] Document FirstProblem() const;
  /// A shipped document in which the figure of this name moves, if any.
  [[nodiscard]] std::optional<Document> MotionOf(const Figure&) const;

 private:
  std::vector<Figure> figures_;
  std::vector<Document> problems_;
};

}  // namespace gaitsmith::shell
