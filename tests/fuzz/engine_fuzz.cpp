// SPDX-License-Identifier: MIT
// Simulates messages to workers: any calls of the engine's interface (web/search/engine_border.h) in any
// order, with any documents, genomes, scores and saved states, valid, damaged or invented. Each call succeeds
// or fails with a message. Its results are finite and in the engine's own memory. Input bytes: the document,
// then calls with their data.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

#include "core/document/binary.h"
#include "core/document/json_value.h"
#include "core/rollout/evaluator.h"
#include "core/search/search.h"
#include "tests/fuzz/small_lattice.h"
// The interface has no header, only a declaration for JavaScript.
#include "web/search/engine.cpp"           // NOLINT
#include "web/search/engine_breeding.cpp"  // NOLINT
#include "web/search/engine_files.cpp"     // NOLINT
#include "web/search/engine_motion.cpp"    // NOLINT

namespace {

using namespace gaitsmith;

// The fuzzer's remaining bytes, then zeros.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}
  [[nodiscard]] bool Empty() const { return rest_.empty(); }
  std::uint8_t Next() {
    if (rest_.empty()) return 0;
    const std::uint8_t byte = rest_.front();
    rest_ = rest_.subspan(1);
    return byte;
  }
  int Signed() { return static_cast<std::int8_t>(Next()); }
  std::vector<std::uint8_t> Take(std::size_t count) {
    const auto part = rest_.first(std::min(count, rest_.size()));
    rest_ = rest_.subspan(part.size());
    return {part.begin(), part.end()};
  }

 private:
  std::span<const std::uint8_t> rest_;
};

Document SmallProblem(Bytes& bytes) {
  Document d;
  d.figure.rods = {Rod{}, Rod{.parent = 0}, Rod{.parent = 1}};
  d.rules = 2;
  d.task.duration_steps = d.duration_steps = 1 + bytes.Next() % 40;
  d.search.algorithm = static_cast<Algorithm>(bytes.Next() % kAlgorithmNames.size());
  d.search.seed = bytes.Next();
  d.search.evaluations = 1 + bytes.Next();
  d.search.population = 4;
  d.search.genetic.population = 12;
  d.search.torus.side = 4;
  d.search.elites.initial = 20;
  d.search.elites.batch = 8;
  d.search.two_stage = {.random = 30, .kept = 2};
  if (bytes.Next() % 4 == 0 || d.search.algorithm == Algorithm::kTwoStage) d.kind = ControllerKind::kNetwork;
  d.senses.kind = std::array{SenseKind::kTimer, SenseKind::kPhysical, SenseKind::kSight}[bytes.Next() % 3u];
  if (d.senses.kind == SenseKind::kTimer && d.kind == ControllerKind::kRules && bytes.Next() % 2 == 0) {
    d.kind = ControllerKind::kTrajectory;
    if (bytes.Next() % 2 == 0) d.senses.at_end = CurveEnd::kRest;
  }
  if (const std::uint8_t joints = bytes.Next(); joints % 2 == 1) {
    d.model = 2;
    d.figure.rods[1].strength = static_cast<float>(joints / 16);
    d.figure.rods[2].stiffness = joints % 4 == 1 ? 1.0f : 1e6f;
  } else if (joints % 4 == 2 && d.kind != ControllerKind::kNetwork) {
    test::MakeSpringy(d);
  }
  RandomStream random(bytes.Next(), 0, 0);
  for (int clip = 0; clip < bytes.Next() % 3; ++clip) {
    d.controllers.push_back(
        {"", d.kind, d.senses, d.rules, RandomGenome(SpaceOf(d).shape, d.senses, Variation{}, random)});
    d.timeline.push_back({clip, clip * 15});
  }
  for (int round = 0; round < bytes.Next() % 4; ++round) {
    if (round == 0)
      d.lineage.founders = {
          {"", d.kind, d.senses, d.rules, RandomGenome(SpaceOf(d).shape, d.senses, Variation{}, random)}};
    const int parent = bytes.Signed() % (round + 1) - (bytes.Next() % 2);
    d.lineage.rounds.push_back({.name = "",
                                .parent = std::max(-1, std::min(parent, round - 1)),
                                .picks = parent < 0 ? 1u : 1u + bytes.Next(),
                                .seed = bytes.Next(),
                                .difference = static_cast<float>(bytes.Next()) / 255.0f,
                                .keep_goal = bytes.Next() % 2 == 0,
                                .kept_rules = bytes.Next(),
                                .kept_joints = bytes.Next(),
                                .task = d.task});
  }
  d.search.in_place_of = bytes.Signed() % 4;
  const auto body = static_cast<BodyFreedom>(bytes.Next() % 3);
  if (!d.figure.HasSprings()) d.search.body = body;
  return d;
}

std::size_t Bring(std::vector<std::uint8_t> what) {
  std::uint8_t* at = gs_input(what.size());
  std::ranges::copy(what, at);
  return what.size();
}

// Passes data with one byte changed in some cases.
std::size_t BringDamaged(Bytes& bytes, std::vector<std::uint8_t> what) {
  const std::uint8_t damage = bytes.Next();
  if (damage % 8 == 1 && !what.empty()) what[(damage * 256u + bytes.Next()) % what.size()] ^= bytes.Next();
  if (damage % 8 == 2) what.resize(what.size() * bytes.Next() / 256);
  return Bring(std::move(what));
}

void Refused() {
  const auto error = ParseJson(gs_error());
  if (!error || error->Find("what") == nullptr || error->Find("what")->text.empty()) std::abort();
}

template <class Role, class Open>
void Opened(std::unique_ptr<Role, void (*)(Role*)>& role, Open open, std::size_t size) {
  Role* now = open(size);
  if (now == nullptr) return Refused();
  role.reset(now);
}

void Tell(Bytes& bytes, SearchRole* search, std::size_t asked) {
  const std::size_t numbers = (bytes.Next() % 2 == 0 ? 4 : 1) * asked + (bytes.Next() % 16 == 1 ? 1 : 0);
  // NaN and very large numbers are possible too.
  std::vector<std::uint8_t> scores = bytes.Take(std::min<std::size_t>(bytes.Next(), 4 * numbers));
  while (scores.size() < 4 * numbers)
    scores.push_back(static_cast<std::uint8_t>(scores.size() % 4 == 3 ? 63 : 0));
  Bring(std::move(scores));
  if (!gs_search_tell(search, numbers)) return Refused();
  if (std::isnan(gs_search_best_fitness(search))) std::abort();
  static_cast<void>(gs_search_spread(search));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const Document d = SmallProblem(bytes);
  const std::vector<std::uint8_t> document = EncodeBinary(d);
  std::unique_ptr<EvaluatorRole, void (*)(EvaluatorRole*)> evaluating(nullptr, gs_evaluator_close);
  std::unique_ptr<SearchRole, void (*)(SearchRole*)> searching(nullptr, gs_search_close);
  std::unique_ptr<MapRole, void (*)(MapRole*)> mapping(nullptr, gs_map_close);
  std::unique_ptr<MotionRole, void (*)(MotionRole*)> showing(nullptr, gs_motion_close);
  std::vector<std::size_t> asked;
  std::vector<std::uint8_t> saved;
  for (int calls = 0; calls < 40 && !bytes.Empty(); ++calls) {
    switch (bytes.Next() % 16) {
      case 0:
        Opened(
            evaluating, [&](std::size_t all) { return gs_evaluator_open(all, bytes.Next() % 2 == 0); },
            BringDamaged(bytes, document));
        break;
      case 1: {
        if (!evaluating) break;
        Bring(bytes.Take(bytes.Next() * 4u));
        const std::size_t count = bytes.Next() % 20;
        const Score* scores = gs_evaluator_run(evaluating.get(), count);
        if (scores == nullptr && count > 0) Refused();
        for (std::size_t i = 0; scores != nullptr && i < count; ++i) {
          if (!std::isfinite(scores[i].fitness)) std::abort();
        }
        break;
      }
      case 2:
        Opened(searching, gs_search_open, BringDamaged(bytes, document));
        asked.clear();
        break;
      case 3: {
        if (!searching) break;
        const std::size_t count = gs_search_ask(searching.get(), bytes.Signed());
        const Gene* genomes = gs_search_genomes(searching.get());
        unsigned sum = 0;  // the whole result is readable
        for (std::size_t i = 0; i < count * gs_search_genes(searching.get()); ++i) sum += genomes[i];
        if (sum == 0xffffffffu) std::abort();
        if (count > 0) asked.push_back(count);
        break;
      }
      case 4:
        if (!searching) break;
        Tell(bytes, searching.get(), asked.empty() ? 3 : asked.front());
        if (!asked.empty()) asked.erase(asked.begin());
        break;
      case 14:
        if (!searching) break;
        if (!gs_search_score(searching.get())) {
          Refused();
          break;
        }
        asked.clear();
        if (std::isnan(gs_search_best_fitness(searching.get()))) std::abort();
        break;
      case 5: {
        if (!searching || !asked.empty()) break;
        const std::uint8_t* state = gs_search_save(searching.get());
        saved.assign(state, state + gs_search_saved_size(searching.get()));
        break;
      }
      case 6:
        if (!searching) break;
        if (!gs_search_load(searching.get(), BringDamaged(bytes, saved))) Refused();
        asked.clear();
        break;
      case 7:
        Opened(mapping, gs_map_open, BringDamaged(bytes, document));
        break;
      case 8: {
        if (!mapping) break;
        const int first = bytes.Signed();
        const int count = bytes.Signed() % 8;
        const float* scores = gs_map_run(mapping.get(), first, count);
        if (scores == nullptr) Refused();
        for (int i = 0; scores != nullptr && i < count; ++i) {
          if (std::isnan(scores[i])) std::abort();
        }
        break;
      }
      case 9: {
        const std::uint8_t how = bytes.Next();
        Opened(
            showing,
            [how](std::size_t size) {
              if (how % 4 == 1) return gs_motion_open_loop(size, how % 8 == 1, how % 16 == 1);
              return how % 4 == 2 ? gs_motion_open_planned(size) : gs_motion_open(size);
            },
            BringDamaged(bytes, document));
        if (!showing) break;
        const std::size_t words = Bring(bytes.Take(bytes.Next()));
        const char* text = gs_motion_film_strip(showing.get(), words, bytes.Signed());
        if (text == nullptr) Refused();
        for (const shell::ExporterRow& row : shell::kExporters) {
          if (gs_motion_file(showing.get(), Bring({row.id.begin(), row.id.end()})) != nullptr) continue;
          if (row.check == nullptr && (row.springs || !d.figure.HasSprings())) std::abort();
          Refused();
        }
        if (gs_motion_sprites(showing.get(), bytes.Signed(), bytes.Signed()) == nullptr) Refused();
        break;
      }
      case 10: {
        Opened(searching, gs_brood_open, BringDamaged(bytes, document));
        asked.clear();
        break;
      }
      case 11: {
        if (!searching) break;
        const std::size_t children = gs_brood_children(searching.get());
        for (std::size_t i = 0; i < children; ++i) {
          if (std::isnan(gs_brood_scores(searching.get())[i].fitness)) std::abort();
        }
        break;
      }
      case 12: {
        std::vector<std::uint8_t> family = document;
        const std::vector<std::uint8_t> genomes = bytes.Take(bytes.Next() * 8u);
        family.insert(family.end(), genomes.begin(), genomes.end());
        Bring(family);
        const std::uint8_t* made =
            bytes.Next() % 2 == 0 ? gs_child(document.size()) : gs_nursery(document.size(), bytes.Signed());
        if (made == nullptr) {
          Refused();
        } else if (!DecodeBinary({made, gs_document_size()})) {
          std::abort();
        }
        break;
      }
      case 13: {
        const std::size_t count =
            Bring(bytes.Take(bytes.Next() * 8u)) / ((2 * kTraits + 1) * sizeof(float)) + bytes.Next() % 2;
        TasteRole* taste = gs_taste_open(count);
        if (taste == nullptr) {
          Refused();
          break;
        }
        for (std::size_t i = 0; i < kTraits; ++i) {
          if (!std::isfinite(gs_taste_weights(taste)[i]) || !(gs_taste_doubts(taste)[i] > 0.0f)) std::abort();
        }
        static_cast<void>(gs_taste_telling(taste));
        if (gs_taste_document(taste, Bring(document)) == nullptr) Refused();
        gs_taste_close(taste);
        break;
      }
      default: {
        const std::uint8_t* read = gs_document_from_text(Bring(bytes.Take(bytes.Next() * 16u)));
        if (read == nullptr) {
          Refused();
        } else if (!DecodeBinary({read, gs_document_size()})) {
          std::abort();
        }
      }
    }
  }
  return 0;
}
