// SPDX-License-Identifier: MIT
// Documents that come with the program: figures, problems and motions.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// Mr. Star-Man: five equal rods from one hub.
[[nodiscard]] Figure StandardFigure();

class ShippedDocuments {
 public:
  ShippedDocuments();
  [[nodiscard]] const std::vector<Figure>& Figures() const { return figures_; }
  /// Figures, each with a task and suitable senses.
  [[nodiscard]] const std::vector<Document>& Problems() const { return problems_; }
  /// A shipped motion with the quick search for its next search. A page inside another page begins with
  /// "star-man-shuffle". @param name  of its file, without folder and extension
  [[nodiscard]] std::optional<Document> Motion(std::string_view name) const;
  /// What a first visit and "New" show: an ostrich that stands and cannot move yet.
  [[nodiscard]] Document FirstFigure() const;

 private:
  std::vector<Figure> figures_;
  std::vector<Document> problems_;
};

}  // namespace gaitsmith::shell
