// SPDX-License-Identifier: MIT
#include "shell/workspace/shipped_documents.h"

#include <algorithm>

#include "core/document/json.h"
#include "core/document/standing.h"
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

ShippedDocuments::ShippedDocuments() : figures_(ShippedFigures()), problems_(ShippedProblems()) {}

std::optional<Document> ShippedDocuments::Motion(std::string_view name) const {
  const auto examples = ExampleDocuments();
  const auto example = std::ranges::find(examples, name, &Example::name);
  if (example == examples.end()) return std::nullopt;
  auto document = DecodeJson(example->json);
  if (!document) return std::nullopt;
  BeginWithQuickSearch(document->search);
  return std::move(*document);
}

Document ShippedDocuments::FirstFigure() const {
  const auto bird = std::ranges::find(figures_, "Ostrich", &Figure::name);
  return Standing(bird == figures_.end() ? StandardFigure() : *bird);
}

}  // namespace gaitsmith::shell
