// SPDX-License-Identifier: MIT
// The border of the engine: core behind a C interface, compiled to a small WebAssembly module of its own
// (engine_module.js, engine_module.wasm) without window, files or exceptions. A worker uses one of its roles:
// an evaluator scores genomes, a search says which genomes to score, a transition map scores moments of a
// timeline. engine_module.d.ts declares this interface for JavaScript and engine.js wraps it; nothing else
// calls it.
//
// Rules of the border:
// - Bytes come in through gs_input(size): the caller writes them there, then calls a function that takes
//   their count. That area is free again when the function returns.
// - What comes out is a pointer that stays valid until the next call on the same object.
// - A function that can fail returns null or false, and gs_error() then is {"code","where","what"} as JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/breeding/brood.h"
#include "core/document/document.h"
#include "core/search/evaluation_score.h"

#define GS_EXPORT extern "C" __attribute__((used, visibility("default")))

namespace gaitsmith {

/// The input area.
std::vector<std::uint8_t>& Input();

/// Keeps an error for gs_error().
void Note(const Error&);

/// The document in the first bytes of the input area, or nothing and a noted error.
[[nodiscard]] std::optional<Document> TakeDocument(std::size_t size);

/// Keeps a document's bytes for gs_document_size(). @return them
const std::uint8_t* KeepDocument(const Document&);

/// A search at work.
struct SearchRole {
  Scorer scorer;  // of its genomes, where they are not worth sending to evaluators
  std::unique_ptr<Search> search;
  const Brood* brood = nullptr;  // the same search, if it breeds
  int budget;
  std::size_t genes;
  std::vector<std::size_t> asked;  // number of genomes of each ask without scores, oldest first
  std::vector<Gene> genomes;       // genomes of the last ask, one after another (asked * genes)
  std::string spread = {};         // as JSON
  std::vector<std::uint8_t> saved = {};
  std::vector<Score> children = {};
};

}  // namespace gaitsmith
