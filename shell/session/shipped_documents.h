// SPDX-License-Identifier: MIT
// What comes with the program: figures, problems, and motions to look at.
#pragma once

#include <optional>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// Mr. Star-Man: five equal rods from one hub.
[[nodiscard]] Figure StandardFigure();

class ShippedDocuments {
 public:
  ShippedDocuments();
  [[nodiscard]] const std::vector<Figure>& Figures() const { return figures_; }
  /// Each a figure with a task and senses that go well together.
  [[nodiscard]] const std::vector<Document>& Problems() const { return problems_; }
  /// What a first visitor sees: the standard figure shuffles.
  [[nodiscard]] Document FirstMotion() const;
  /// The standard figure, standing still, with the senses that it learns most with: those of its problem.
  [[nodiscard]] Document FirstProblem() const;
  /// A document in which the figure of this name moves; nothing: none is shipped.
  [[nodiscard]] std::optional<Document> MotionOf(const Figure&) const;

 private:
  std::vector<Figure> figures_;
  std::vector<Document> problems_;
};

}  // namespace gaitsmith::shell
