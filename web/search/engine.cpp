// SPDX-License-Identifier: MIT
// Documents, evaluators, searches and transition maps behind the engine's border.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/json_value.h"
#include "core/document/link.h"
#include "core/document/spread_json.h"
#include "core/document/transition.h"
#include "core/search/evaluation_score.h"
#include "core/search/spread.h"
#include "web/search/engine_border.h"

namespace gaitsmith {
namespace {

std::string error_json;
std::vector<std::uint8_t> document_bytes;
std::string document_text;

std::string_view CodeName(ErrorCode code) {
  switch (code) {
    case ErrorCode::kOutOfRange:
      return "out-of-range";
    case ErrorCode::kNotFinite:
      return "not-finite";
    case ErrorCode::kMissing:
      return "missing";
    case ErrorCode::kUnknownName:
      return "unknown-name";
    case ErrorCode::kUnknownVersion:
      return "unknown-version";
    case ErrorCode::kTruncated:
      return "truncated";
    case ErrorCode::kTrailing:
      return "trailing";
    case ErrorCode::kChecksum:
      return "checksum";
    case ErrorCode::kSyntax:
      return "syntax";
    case ErrorCode::kTooMany:
      return "too-many";
    case ErrorCode::kStructure:
      return "structure";
  }
  return "unknown";
}

struct EvaluatorRole {
  Evaluator evaluator;
  std::size_t genes;
  std::vector<Score> scores;
};

struct MapRole {
  TransitionMap map;
  std::vector<float> scores;
};

}  // namespace

std::vector<std::uint8_t>& Input() {
  static std::vector<std::uint8_t> input;
  return input;
}

void Note(const Error& error) {
  error_json = R"({"code":)" + QuoteJson(CodeName(error.code)) + R"(,"where":)" + QuoteJson(error.where) +
               R"(,"what":)" + QuoteJson(error.what) + "}";
}

std::optional<Document> TakeDocument(std::size_t size) {
  auto document = DecodeBinary(std::span(Input()).first(size));
  if (document) return std::move(*document);
  Note(document.error());
  return std::nullopt;
}

const std::uint8_t* KeepDocument(const Document& document) {
  document_bytes = EncodeBinary(document);
  return document_bytes.data();
}

}  // namespace gaitsmith

using namespace gaitsmith;  // NOLINT: everything below is the border

GS_EXPORT std::uint8_t* gs_input(std::size_t size) {
  Input().resize(size);
  return Input().data();
}
GS_EXPORT const char* gs_error() { return error_json.c_str(); }

// Documents. Text is JSON, or a link, or a link's payload; bytes are core/document/binary.h.
/// @return the document's bytes, gs_document_size() of them
GS_EXPORT const std::uint8_t* gs_document_from_text(std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(Input().data()), size);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && text[first] == '{';
  const auto document = json ? DecodeJson(text) : DecodeLink(text);
  if (!document) {
    Note(document.error());
    return nullptr;
  }
  return KeepDocument(*document);
}
GS_EXPORT std::size_t gs_document_size() { return document_bytes.size(); }
/// The document as JSON, ending with a 0 byte.
GS_EXPORT const char* gs_document_json(std::size_t size) {
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  document_text = EncodeJson(*document);
  return document_text.c_str();
}
/// The payload of a document's link, ending with a 0 byte.
GS_EXPORT const char* gs_document_link(std::size_t size) {
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  document_text = EncodeLink(*document);
  return document_text.c_str();
}

// Evaluator.
/// @param traits whether they are measured, too, as they are for searches that need them
GS_EXPORT EvaluatorRole* gs_evaluator_open(std::size_t size, bool traits) {
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  Problem problem = ProblemOf(*document);
  problem.traits = problem.traits || traits;
  return new EvaluatorRole{Evaluator(problem), problem.Shape().Genes(), {}};
}
GS_EXPORT void gs_evaluator_close(EvaluatorRole* role) { delete role; }
GS_EXPORT std::size_t gs_evaluator_genes(const EvaluatorRole* role) { return role->genes; }

constexpr std::size_t kScoreLength = 4 + kTraits;
static_assert(sizeof(Score) == kScoreLength * sizeof(float) && kScoreLength == 17,
              "as SCORE_LENGTH of engine.js");

/// Scores `count` genomes that lie one after another in the input area, 16 bits a gene.
/// @return `count` scores of floats: fitness, greatest height, slip, rotations, then the traits; null if the
/// input is too short
GS_EXPORT const Score* gs_evaluator_run(EvaluatorRole* role, std::size_t count) {
  if (Input().size() / sizeof(Gene) / role->genes < count) {
    Note({ErrorCode::kTruncated, "genomes", "fewer than announced"});
    return nullptr;
  }
  // std::vector's storage is aligned for any fundamental type.
  const auto* genes = reinterpret_cast<const Gene*>(Input().data());
  std::vector<std::span<const Gene>> genomes;
  genomes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) genomes.emplace_back(genes + i * role->genes, role->genes);
  role->scores.clear();
  for (const Evaluation& evaluation : role->evaluator.Evaluate(genomes)) {
    role->scores.push_back(ScoreOf(evaluation));
  }
  return role->scores.data();
}

// Search.
GS_EXPORT SearchRole* gs_search_open(std::size_t size) {
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  const Scorer scorer(ProblemOf(*document));
  const SearchSpace space = scorer.Space(StartOf(*document));
  std::unique_ptr<Search> search = MakeSearch(document->search, space);
  if (!search) {
    Note({ErrorCode::kUnknownName, "search.algorithm", "is not in this page's small engine"});
    return nullptr;
  }
  return new SearchRole{.scorer = scorer,
                        .search = std::move(search),
                        .budget = document->search.evaluations,
                        .genes = space.shape.Genes(),
                        .asked = {},
                        .genomes = {}};
}
/// A document that shows the genome that follows, which a search of the document may have found.
/// @return its bytes, gs_document_size() of them
GS_EXPORT const std::uint8_t* gs_shown(std::size_t size) {
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  Genome genome((Input().size() - size) / sizeof(Gene));
  if (genome.size() != Scorer(ProblemOf(*document)).Space(StartOf(*document)).shape.Genes()) {
    Note({ErrorCode::kOutOfRange, "genome", "has another number of genes"});
    return nullptr;
  }
  std::memcpy(genome.data(), Input().data() + size, genome.size() * sizeof(Gene));
  Document shown = *document;
  shown.controllers = {TakeFound(*document, std::move(genome), shown)};
  shown.timeline = {{.controller = 0, .start_step = 0}};
  shown.duration_steps = shown.task.duration_steps;
  shown.search.start = -1;
  shown.lineage = {};
  shown.hash.reset();
  return KeepDocument(shown);
}
GS_EXPORT void gs_search_close(SearchRole* role) { delete role; }
GS_EXPORT std::size_t gs_search_genes(const SearchRole* role) { return role->genes; }
GS_EXPORT int gs_search_budget(const SearchRole* role) { return role->budget; }

/// @return the number of genomes to score next, which gs_search_genomes() returns. 0 while every proposal
/// depends on scores that have not arrived; only some searches can propose genomes before then
/// (gs_search_asks_ahead)
GS_EXPORT std::size_t gs_search_ask(SearchRole* role, int wanted) {
  role->genomes.clear();
  if (!role->asked.empty() && !role->search->AsksAhead()) return 0;
  const std::vector<Genome> genomes = role->search->Ask(wanted);
  for (const Genome& genome : genomes) {
    role->genomes.insert(role->genomes.end(), genome.begin(), genome.end());
  }
  if (!genomes.empty()) role->asked.push_back(genomes.size());
  return genomes.size();
}
GS_EXPORT bool gs_search_asks_ahead(const SearchRole* role) { return role->search->AsksAhead(); }
GS_EXPORT const Gene* gs_search_genomes(const SearchRole* role) { return role->genomes.data(); }

/// Takes a score for each genome of the oldest ask without scores, in its order, from the input area: its
/// floats as gs_evaluator_run returns them, or the fitness alone for searches that need no more. Call once
/// for each ask.
/// @param count floats
GS_EXPORT bool gs_search_tell(SearchRole* role, std::size_t count) {
  if (role->asked.empty()) {
    Note({ErrorCode::kStructure, "fitness", "was not asked for"});
    return false;
  }
  const std::size_t asked = role->asked.front();
  const bool whole = count == kScoreLength * asked;
  if ((!whole && count != asked) || Input().size() < count * sizeof(float)) {
    Note({ErrorCode::kStructure, "fitness", "must be one number, or a whole score, for every genome asked"});
    return false;
  }
  if (whole) {
    role->search->Tell(std::span(reinterpret_cast<const Score*>(Input().data()), asked));
  } else {
    role->search->Tell(std::span(reinterpret_cast<const float*>(Input().data()), asked));
  }
  role->asked.erase(role->asked.begin());
  return true;
}
/// Scores the genomes of the last ask here and tells the search. No other ask may be open.
GS_EXPORT bool gs_search_score(SearchRole* role) {
  if (role->asked.size() != 1 || role->genomes.size() != role->asked.front() * role->genes) {
    Note({ErrorCode::kStructure, "genomes", "must be those of the only open ask"});
    return false;
  }
  std::vector<Genome> genomes;
  for (std::size_t i = 0; i < role->asked.front(); ++i) {
    const auto first = role->genomes.begin() + static_cast<std::ptrdiff_t>(i * role->genes);
    genomes.emplace_back(first, first + static_cast<std::ptrdiff_t>(role->genes));
  }
  role->search->Tell(role->scorer.ScoresOf(genomes));
  role->asked.clear();
  return true;
}
GS_EXPORT int gs_search_evaluations(const SearchRole* role) { return role->search->Evaluations(); }
GS_EXPORT bool gs_search_done(const SearchRole* role) { return role->search->Done(); }
GS_EXPORT float gs_search_best_fitness(const SearchRole* role) { return role->search->BestFitness(); }

/// @return gs_search_genes() genes, or null before the first tell
GS_EXPORT const Gene* gs_search_best_genome(const SearchRole* role) {
  const Genome& best = role->search->BestGenome();
  return best.empty() ? nullptr : best.data();
}

/// The points of the best-so-far curve, each an int (evaluation) and a float (best).
static_assert(sizeof(Search::CurvePoint) == 8);
GS_EXPORT std::size_t gs_search_curve_length(const SearchRole* role) { return role->search->Curve().size(); }
GS_EXPORT const void* gs_search_curve(const SearchRole* role) { return role->search->Curve().data(); }

/// The spread of the population's fitness as JSON (core/document/spread_json.h), ending with a 0 byte; null
/// if there is none.
GS_EXPORT const char* gs_search_spread(SearchRole* role) {
  const auto spread = SpreadOf(role->search->PopulationFitness());
  if (!spread) return nullptr;
  role->spread = SpreadJson(*spread);
  return role->spread.c_str();
}

/// The whole state of the search. Call between a tell and an ask.
GS_EXPORT const std::uint8_t* gs_search_save(SearchRole* role) {
  BitWriter out;
  role->search->Save(out);
  role->saved = out.Bytes();
  return role->saved.data();
}
GS_EXPORT std::size_t gs_search_saved_size(const SearchRole* role) { return role->saved.size(); }

/// Continues from a saved state in the input area, which must come from the same document. Earlier asks are
/// forgotten.
GS_EXPORT bool gs_search_load(SearchRole* role, std::size_t size) {
  role->asked.clear();
  BitReader in(std::span(Input()).first(size));
  const auto loaded = role->search->Load(in);
  if (!loaded) Note(loaded.error());
  return loaded.has_value();
}

// The transition map of the clip in the document's search.in_place_of.
GS_EXPORT MapRole* gs_map_open(std::size_t size) {
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  if (TransitionSteps(*document, document->search.in_place_of).empty()) {
    Note({ErrorCode::kStructure, "search.in_place_of", "has no other moment at which it could take over"});
    return nullptr;
  }
  return new MapRole{TransitionMapOf(*document), {}};
}
GS_EXPORT void gs_map_close(MapRole* role) { delete role; }
GS_EXPORT int gs_map_count(const MapRole* role) { return role->map.Count(); }
GS_EXPORT float gs_map_usual_score(const MapRole* role) { return role->map.UsualScore(); }
/// @return `count` scores, in the map's order; null if the map has no such places
GS_EXPORT const float* gs_map_run(MapRole* role, int first, int count) {
  if (first < 0 || count < 1 || count > role->map.Count() || first > role->map.Count() - count) {
    Note({ErrorCode::kOutOfRange, "places", "are not in the map"});
    return nullptr;
  }
  role->scores = role->map.Scores(first, count);
  return role->scores.data();
}
