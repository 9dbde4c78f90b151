// SPDX-License-Identifier: MIT
// The engine: core behind a C interface, compiled to a small WebAssembly module of its own (engine_module.js,
// engine_module.wasm) without window, files or exceptions. A worker uses one of its roles: an evaluator
// scores genomes, a search says which genomes to score, a transition map scores moments of a timeline.
// engine_module.d.ts declares this interface for JavaScript and engine.js wraps it; nothing else calls it.
//
// Rules of the border:
// - Bytes come in through gs_input(size): the caller writes them there, then calls a function that takes
//   their count. That area is free again when the function returns.
// - What comes out is a pointer that stays valid until the next call on the same object.
// - A function that can fail returns null or false, and gs_error() then is {"code","where","what"} as JSON.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/json_value.h"
#include "core/document/link.h"
#include "core/document/spread_json.h"
#include "core/document/transition.h"
#include "core/search/evaluation_score.h"
#include "core/search/spread.h"
#include "shell/body/body_parts.h"
#include "shell/export/exporters.h"

#define GS_EXPORT extern "C" __attribute__((used, visibility("default")))

namespace gaitsmith {
namespace {

std::vector<std::uint8_t> input;
std::string error_json;
std::vector<std::uint8_t> document_bytes;

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

void Note(const Error& error) {
  error_json = R"({"code":)" + QuoteJson(CodeName(error.code)) + R"(,"where":)" + QuoteJson(error.where) +
               R"(,"what":)" + QuoteJson(error.what) + "}";
}

/// The document in the input area, or nothing and a noted error.
std::optional<Document> TakeDocument(std::size_t size) {
  auto document = DecodeBinary(std::span(input).first(size));
  if (document) return std::move(*document);
  Note(document.error());
  return std::nullopt;
}

struct EvaluatorRole {
  Evaluator evaluator;
  std::size_t genes;
  std::vector<Score> scores;
};

struct SearchRole {
  std::unique_ptr<Search> search;
  int budget;
  std::size_t genes;
  std::vector<std::size_t> asked;  // number of genomes of each ask without scores, oldest first
  std::vector<Gene> genomes;       // genomes of the last ask, one after another (asked * genes)
  std::string spread = {};         // as JSON
  std::vector<std::uint8_t> saved;
};

struct MapRole {
  TransitionMap map;
  std::vector<float> scores;
};

struct MotionRole {
  Document document;
  Motion motion;
  std::vector<int> starts = {};     // of each rod: the endpoint where it begins
  std::vector<float> numbers = {};  // all frames, one after another
  shell::FigureLook look = {};
  std::vector<float> body = {};
  std::string text = {};
};

const char* Keep(MotionRole* role, std::string text) {
  role->text = std::move(text);
  return role->text.data();
}

}  // namespace
}  // namespace gaitsmith

using namespace gaitsmith;  // NOLINT: everything below is the border

GS_EXPORT std::uint8_t* gs_input(std::size_t size) {
  input.resize(size);
  return input.data();
}
GS_EXPORT const char* gs_error() { return error_json.c_str(); }

// Documents. Text is JSON, or a link, or a link's payload; bytes are core/document/binary.h.
/// @return the document's bytes, gs_document_size() of them
GS_EXPORT const std::uint8_t* gs_document_from_text(std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(input.data()), size);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && text[first] == '{';
  const auto document = json ? DecodeJson(text) : DecodeLink(text);
  if (!document) {
    Note(document.error());
    return nullptr;
  }
  document_bytes = EncodeBinary(*document);
  return document_bytes.data();
}
GS_EXPORT std::size_t gs_document_size() { return document_bytes.size(); }

// Evaluator.
GS_EXPORT EvaluatorRole* gs_evaluator_open(std::size_t size) {
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  const Problem problem = ProblemOf(*document);
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
  if (input.size() / sizeof(Gene) / role->genes < count) {
    Note({ErrorCode::kTruncated, "genomes", "fewer than announced"});
    return nullptr;
  }
  // std::vector's storage is aligned for any fundamental type.
  const auto* genes = reinterpret_cast<const Gene*>(input.data());
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
  const SearchSpace space = SpaceOf(*document);
  return new SearchRole{.search = MakeSearch(document->search, space),
                        .budget = document->search.evaluations,
                        .genes = space.shape.Genes(),
                        .asked = {},
                        .genomes = {},
                        .saved = {}};
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

/// Takes a score for each genome of the oldest ask without scores, in its order, from the input area: four
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
  if ((!whole && count != asked) || input.size() < count * sizeof(float)) {
    Note({ErrorCode::kStructure, "fitness", "must be one number, or a whole score, for every genome asked"});
    return false;
  }
  if (whole) {
    role->search->Tell(std::span(reinterpret_cast<const Score*>(input.data()), asked));
  } else {
    role->search->Tell(std::span(reinterpret_cast<const float*>(input.data()), asked));
  }
  role->asked.erase(role->asked.begin());
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
  BitReader in(std::span(input).first(size));
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

// A motion, for drawing and export.
GS_EXPORT MotionRole* gs_motion_open(std::size_t size) {
  auto document = TakeDocument(size);
  if (!document) return nullptr;
  Motion motion = Simulate(*document);
  auto* role = new MotionRole{.document = std::move(*document), .motion = std::move(motion)};
  const Skeleton& bones = role->motion.Bones();
  for (int rod = 0; rod < bones.rods; ++rod)
    role->starts.push_back(bones.limbs[static_cast<std::size_t>(rod)].start);
  role->look = shell::LookOf(role->document.figure.name, bones);
  for (int i = 0; i < role->motion.Frames(); ++i) {
    const Motion::Frame& frame = role->motion.At(i);
    const auto& timeline = role->document.timeline;
    const int clip = frame.clip;
    role->numbers.push_back(
        static_cast<float>(clip < 0 ? -1 : timeline[static_cast<std::size_t>(clip)].controller));
    role->numbers.insert(role->numbers.end(), {static_cast<float>(frame.x_m), frame.y_m});
    for (int k = 0; k < bones.endpoints; ++k) {
      const Motion::Point point = role->motion.Endpoint(i, k);
      role->numbers.push_back(static_cast<float>(frame.x_m + static_cast<double>(point.x)));
      role->numbers.push_back(frame.y_m + point.y);
    }
  }
  return role;
}
GS_EXPORT void gs_motion_close(MotionRole* role) { delete role; }
GS_EXPORT int gs_motion_frames(const MotionRole* role) { return role->motion.Frames(); }
GS_EXPORT int gs_motion_rods(const MotionRole* role) { return role->motion.Bones().rods; }
/// For each rod the endpoint at its start; rod i ends at endpoint i + 1.
GS_EXPORT const int* gs_motion_starts(const MotionRole* role) { return role->starts.data(); }
/// For each frame: the active controller (-1: none), the centre of mass, every endpoint [m].
GS_EXPORT const float* gs_motion_numbers(const MotionRole* role) { return role->numbers.data(); }
/// The figure's outline in a frame: gs_motion_body_size() numbers, 8 for each part of BodyPartsOf and for its
/// eye: x, y, radius at both ends [m], how far the radius swells halfway [m], and 0 for a near part, 1 for a
/// far one, 2 for the eye.
/// @param frame clamped to the motion
GS_EXPORT const float* gs_motion_body(MotionRole* role, int frame) {
  const int shown = std::clamp(frame, 0, role->motion.Frames() - 1);
  const Motion::Frame& at = role->motion.At(shown);
  const Skeleton& bones = role->motion.Bones();
  std::vector<shell::BodyPoint> endpoints;
  for (int k = 0; k < bones.endpoints; ++k) {
    const Motion::Point point = role->motion.Endpoint(shown, k);
    endpoints.push_back({static_cast<float>(at.x_m + static_cast<double>(point.x)), at.y_m + point.y});
  }
  role->body.clear();
  const auto add = [&](shell::BodyPoint from, float from_m, shell::BodyPoint to, float to_m, float belly_m,
                       float tone) {
    role->body.insert(role->body.end(), {from.x, from.y, from_m, to.x, to.y, to_m, belly_m, tone});
  };
  for (const shell::BodyPart& part : shell::BodyPartsOf(bones, role->look, endpoints))
    add(part.from, part.from_m, part.to, part.to_m, part.belly_m, part.far ? 1.0f : 0.0f);
  if (const auto eye = shell::EyeOf(bones, role->look, endpoints))
    add(eye->at, eye->radius_m, eye->at, eye->radius_m, 0.0f, 2.0f);
  return role->body.data();
}
/// Of the last gs_motion_body().
GS_EXPORT std::size_t gs_motion_body_size(const MotionRole* role) { return role->body.size(); }

// Exported files, gs_motion_text_size() bytes.
/// @param words_size bytes of FilmStripWords in the input area, with a 0 byte after each
GS_EXPORT const char* gs_motion_film_strip(MotionRole* role, std::size_t words_size, int poses) {
  shell::FilmStripOptions options{.poses = poses};
  const std::string_view words(reinterpret_cast<const char*>(input.data()), words_size);
  std::size_t at = 0;
  for (std::string* word : {&options.words.description, &options.words.slope, &options.words.decimal_mark}) {
    const std::size_t end = words.find('\0', at);
    if (end == std::string_view::npos) {
      Note({ErrorCode::kTruncated, "words", "fewer than expected"});
      return nullptr;
    }
    *word = words.substr(at, end - at);
    at = end + 1;
  }
  return Keep(role, shell::FilmStripSvg(role->document, role->motion, options));
}
/// A file that needs no words. @param id_size of an exporter's id in the input area
GS_EXPORT const char* gs_motion_file(MotionRole* role, std::size_t id_size) {
  const std::string_view id(reinterpret_cast<const char*>(input.data()), id_size);
  const auto row = std::ranges::find(shell::kExporters, id, &shell::ExporterRow::id);
  if (row == shell::kExporters.end()) {
    Note({ErrorCode::kUnknownName, "", "there is no such export"});
    return nullptr;
  }
  return Keep(role, row->make(role->document, role->motion, {}));
}
GS_EXPORT std::size_t gs_motion_text_size(const MotionRole* role) { return role->text.size(); }
