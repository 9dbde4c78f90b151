// SPDX-License-Identifier: MIT
// Breeding by eye and a person's taste behind the engine's border.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/breeding/litter.h"
#include "core/breeding/motion_traits.h"
#include "core/breeding/taste_weights.h"
#include "core/document/archive.h"
#include "core/document/binary.h"
#include "core/document/json_value.h"
#include "web/search/engine_border.h"

namespace gaitsmith {
namespace {

/// The genomes that follow the first `size` bytes of the input area, 16 bits a gene.
std::vector<Genome> TakeGenomes(std::size_t size, std::size_t genes) {
  std::vector<Genome> genomes((Input().size() - size) / (genes * sizeof(Gene)), Genome(genes));
  for (Genome& genome : genomes) {
    std::memcpy(genome.data(), Input().data() + size, genes * sizeof(Gene));
    size += genes * sizeof(Gene);
  }
  return genomes;
}

/// Keeps a document with genomes that came from outside. @return null, with a noted error, if it is invalid
const std::uint8_t* KeepChecked(const Document& document) {
  const std::uint8_t* bytes = KeepDocument(document);
  const auto read = DecodeBinary(EncodeBinary(document));
  if (read) return bytes;
  Note(read.error());
  return nullptr;
}

struct TasteRole {
  Taste taste;
};

}  // namespace
}  // namespace gaitsmith

using namespace gaitsmith;  // NOLINT: everything below is the border

// Breeding. The input area holds `size` bytes of a document, then genomes, 16 bits a gene.
/// The nursery of a round of the document's lineage. The genomes are the children of the round's parent.
/// @return the nursery's bytes, gs_document_size() of them
GS_EXPORT const std::uint8_t* gs_nursery(std::size_t size, int round) {
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  const auto& founders = document->lineage.founders;
  const auto litter =
      founders.empty() ? std::vector<Genome>{} : TakeGenomes(size, founders.front().genes.size());
  const auto nursery = NurseryOf(*document, round, litter);
  if (nursery) return KeepChecked(*nursery);
  Note(nursery.error());
  return nullptr;
}
/// A document that shows the child with the genome that follows. @return its bytes, gs_document_size() of
/// them
GS_EXPORT const std::uint8_t* gs_child(std::size_t size) {
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  const auto& founders = document->lineage.founders;
  const auto genomes =
      founders.empty() ? std::vector<Genome>{} : TakeGenomes(size, founders.front().genes.size());
  if (!genomes.empty()) return KeepChecked(ChildOf(*document, genomes.front()));
  Note({ErrorCode::kMissing, "lineage", "has no such child"});
  return nullptr;
}

/// A search for the children of a nursery (core/breeding/litter.h). Its evaluators must measure traits.
GS_EXPORT SearchRole* gs_brood_open(std::size_t size) {
  const auto nursery = TakeDocument(size);
  if (!nursery) return nullptr;
  if (nursery->lineage.rounds.empty() || nursery->search.in_place_of >= 0 ||
      !FitsSearch(*nursery, nursery->lineage.founders.front())) {
    Note({ErrorCode::kMissing, "lineage", "has no round to breed"});
    return nullptr;
  }
  auto brood = BroodOf(*nursery);
  const Brood* same = brood.get();
  return new SearchRole{.scorer = Scorer(NurseryProblem(*nursery)),
                        .search = std::move(brood),
                        .brood = same,
                        .budget = kRoundEvaluations,
                        .genes = nursery->lineage.founders.front().genes.size(),
                        .asked = {},
                        .genomes = {}};
}
/// The children of a brood: how many, their genomes one after another, and their scores as
/// gs_evaluator_run returns them.
GS_EXPORT std::size_t gs_brood_children(SearchRole* role) {
  role->genomes.clear();
  role->children.clear();
  if (role->brood == nullptr) return 0;
  for (const Brood::Member& child : role->brood->Children()) {
    role->genomes.insert(role->genomes.end(), child.genome.begin(), child.genome.end());
    role->children.push_back({.fitness = child.fitness, .traits = child.traits});
  }
  return role->children.size();
}
GS_EXPORT const Score* gs_brood_scores(const SearchRole* role) { return role->children.data(); }

// A person's taste.
/// Names, units and scales of the traits, as a JSON list, ending with a 0 byte.
GS_EXPORT const char* gs_traits() {
  static const std::string kTraitsJson = [] {
    std::string json = "[";
    for (const TraitRow& row : kTraitTable) {
      json += (json.size() > 1 ? R"(,{"name":)" : R"({"name":)") + QuoteJson(row.name) + R"(,"unit":)" +
              QuoteJson(row.unit) + R"(,"scale":)" + RealText(row.scale) + "}";
    }
    return json + "]";
  }();
  return kTraitsJson.c_str();
}
/// The traits of a document's motion, kTraits floats; null if it has none.
GS_EXPORT const float* gs_document_traits(std::size_t size) {
  static Traits kept;
  const auto document = TakeDocument(size);
  if (!document) return nullptr;
  const auto traits = MotionTraits(*document);
  if (!traits) {
    Note(traits.error());
    return nullptr;
  }
  kept = *traits;
  return kept.data();
}
/// Learns from `count` comparisons in the input area: the traits of two motions, then the place of the
/// verdict in kVerdictNames, as floats.
GS_EXPORT TasteRole* gs_taste_open(std::size_t count) {
  constexpr std::size_t kNumbers = 2 * kTraits + 1;
  if (Input().size() / (kNumbers * sizeof(float)) < count) {
    Note({ErrorCode::kTruncated, "comparisons", "fewer than announced"});
    return nullptr;
  }
  const auto* numbers = reinterpret_cast<const float*>(Input().data());
  std::vector<Comparison> comparisons(count);
  for (Comparison& one : comparisons) {
    std::copy_n(numbers, kTraits, one.first.begin());
    std::copy_n(numbers + kTraits, kTraits, one.second.begin());
    const float verdict = numbers[2 * kTraits];
    one.verdict = verdict == 0.0f ? Verdict::kFirst : verdict == 1.0f ? Verdict::kSecond : Verdict::kNeither;
    if (!std::all_of(numbers, numbers + kNumbers, [](float value) { return value - value == 0.0f; })) {
      Note({ErrorCode::kNotFinite, "comparisons", "has a number that is not finite"});
      return nullptr;
    }
    numbers += kNumbers;
  }
  return new TasteRole{Taste(comparisons)};
}
GS_EXPORT void gs_taste_close(TasteRole* role) { delete role; }
/// A number for each trait, as Taste::Weights and Taste::Doubts.
GS_EXPORT const float* gs_taste_weights(const TasteRole* role) { return role->taste.Weights().data(); }
GS_EXPORT const float* gs_taste_doubts(const TasteRole* role) { return role->taste.Doubts().data(); }
/// How much a comparison of two motions would tell, whose traits are in the input area; -1 if they are not.
GS_EXPORT float gs_taste_telling(const TasteRole* role) {
  Traits first, second;
  if (Input().size() < sizeof first + sizeof second) return -1.0f;
  std::memcpy(first.data(), Input().data(), sizeof first);
  std::memcpy(second.data(), Input().data() + sizeof first, sizeof second);
  return role->taste.Telling(first, second);
}
/// The document with the taste as the weights of its task. @return its bytes, gs_document_size() of them
GS_EXPORT const std::uint8_t* gs_taste_document(const TasteRole* role, std::size_t size) {
  auto document = TakeDocument(size);
  if (!document) return nullptr;
  document->task.weights = WeightsOf(role->taste, *document);
  return KeepDocument(*document);
}
