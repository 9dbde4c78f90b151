// SPDX-License-Identifier: MIT
#include "shell/workspace/shipped_documents.h"

#include <algorithm>

#include "core/document/json.h"
#include "core/numeric/scalar_math.h"
#include "shell/embedded/embedded.h"

namespace gaitsmith::shell {
namespace {

// Several examples may have the same figure: list each name once.
std::vector<Figure> ShippedFigures() {
  std::vector<Figure> figures;
  const auto add = [&](const Figure& figure) {
    const bool known = std::ranges::any_of(figures, [&](const Figure& f) { return f.name == figure.name; });
    if (!known) figures.push_back(figure);
  };
  for (const Example& example : ExampleFigures()) {
    if (const auto figure = DecodeFigureJson(example.json)) add(*figure);
  }
  for (const Example& example : ExampleDocuments()) {
    if (const auto document = DecodeJson(example.json)) add(document->figure);
  }
  add(StandardFigure());
  return figures;
}

std::vector<Document> ShippedProblems() {
  std::vector<Document> problems;
  for (const Example& example : ExampleProblems()) {
    if (auto document = DecodeJson(example.json)) problems.push_back(std::move(*document));
  }
  return problems;
}

}  // namespace

Figure StandardFigure() {
  Figure figure{.name = "Mr. Star-Man", .rods = {}};
  for (int i = 0; i < 5; ++i) {
    Rod rod;
    if (i > 0) {
      rod.parent = 0;
      rod.parent_end = RodEnd::kStart;
    }
    rod.rest_rad = i == 0 ? static_cast<float>(kPi / 2) : static_cast<float>(0.4 * kPi * i);
    if (rod.rest_rad > static_cast<float>(kPi)) rod.rest_rad -= static_cast<float>(2 * kPi);
    figure.rods.push_back(rod);
  }
  return figure;
}

void BeginWithQuickSearch(SearchSettings& search) {
  search.algorithm = Algorithm::kPoseCycle;
  search.evaluations = 4000;
}

ShippedDocuments::ShippedDocuments() : figures_(ShippedFigures()), problems_(ShippedProblems()) {}

Document ShippedDocuments::FirstMotion() const {
  Document document;
  document.title = "Mr. Star-Man";
  document.figure = StandardFigure();
  for (const Example& example : ExampleDocuments()) {
    if (example.name != "star-man-shuffle") continue;
    if (auto shipped = DecodeJson(example.json)) document = std::move(*shipped);
  }
  BeginWithQuickSearch(document.search);
  return document;
}

Document ShippedDocuments::FirstProblem() const {
  Document first;
  first.figure = StandardFigure();
  first.title = first.figure.name;
  for (const Document& problem : problems_) {
    if (problem.title.starts_with(first.figure.name)) first = problem;
  }
  first.hash.reset();
  BeginWithQuickSearch(first.search);
  return first;
}

std::optional<Document> ShippedDocuments::MotionOf(const Figure& figure) const {
  for (const Example& example : ExampleDocuments()) {
    auto document = DecodeJson(example.json);
    if (document && document->figure.name == figure.name && !document->controllers.empty())
      return std::move(*document);
  }
  return std::nullopt;
}

}  // namespace gaitsmith::shell
