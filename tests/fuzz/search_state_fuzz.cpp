// SPDX-License-Identifier: MIT
// The saved state of any search, valid, damaged or invented, such as a worker's checkpoint: an error, or a
// search that continues within its rules. An undamaged state continues without any difference. Input bytes:
// the search, its progress before it was saved and whether its figure is of springs, then pairs of a position
// and a change. A single last byte truncates the state.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "core/breeding/brood.h"
#include "core/document/document.h"
#include "tests/fuzz/small_lattice.h"

namespace {

using namespace gaitsmith;

Document SmallProblem(const std::uint8_t* head) {
  Document d;
  d.figure.rods = {Rod{}, Rod{.parent = 0}, Rod{.parent = 1}};
  d.rules = 2;
  // One more than there are algorithms: breeding.
  d.search.algorithm =
      static_cast<Algorithm>(head[0] % (kAlgorithmNames.size() + 1) % kAlgorithmNames.size());
  d.search.seed = head[0];
  d.search.evaluations = 300;
  d.search.population = 4;
  d.search.reseed_interval = 3;
  d.search.genetic.population = 12;
  d.search.torus.side = 4;
  d.search.elites.initial = 20;
  d.search.elites.batch = 8;
  d.search.two_stage = {.random = 30, .kept = 2};
  if (d.search.algorithm == Algorithm::kTwoStage) {
    d.kind = ControllerKind::kNetwork;
  } else if (head[1] >= 128) {
    test::MakeSpringy(d);
  }
  return d;
}

// A test function instead of a simulation. Some genomes have no motion.
Score ScoreOf(const Genome& genome) {
  std::uint32_t sum = 2166136261u;
  for (const Gene gene : genome) sum = (sum ^ gene) * 16777619u;
  const float share = static_cast<float>(sum >> 8) * (1.0f / 16777216.0f);
  Traits traits{};
  for (std::size_t i = 0; i + 1 < kTraits; ++i)
    traits[i] = static_cast<float>((sum >> i) % 64) * kTraitTable[i].scale / 16.0f;
  return {sum % 17 == 0 ? -1e9f : share, {share, 1.0f - share, share * share}, traits};
}

std::unique_ptr<Search> SearchFor(const Document& d, const std::uint8_t* head) {
  if (head[0] % (kAlgorithmNames.size() + 1) != kAlgorithmNames.size())
    return MakeSearch(d.search, SpaceOf(d));
  const SearchSpace space = SpaceOf(d);
  BreedWish wish;
  for (std::uint64_t parent = 0; parent < 2; ++parent) {
    RandomStream random(d.search.seed, parent, 0);
    wish.parents.push_back(RandomGenome(space.shape, d.senses, Variation{}, random));
  }
  return std::make_unique<Brood>(d.search, space, wish);
}

bool Round(Search& search) {
  const std::vector<Genome> asked = search.Ask(10);
  if (asked.empty()) return false;
  std::vector<Score> scores(asked.size());
  std::ranges::transform(asked, scores.begin(), ScoreOf);
  search.Tell(scores);
  return true;
}

std::vector<std::uint8_t> SavedState(const Search& search) {
  BitWriter out;
  search.Save(out);
  return out.Bytes();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const Document d = SmallProblem(data);
  if (!Validate(d)) std::abort();
  const auto search = SearchFor(d, data);
  for (int round = 0; round < data[1] % 40; ++round) {
    if (!Round(*search)) break;
  }
  std::vector<std::uint8_t> state = SavedState(*search);
  const std::vector<std::uint8_t> sound = state;
  std::size_t at = 2;
  for (; at + 2 < size && !state.empty(); at += 3) {
    const std::size_t place = (static_cast<std::size_t>(data[at]) << 8 | data[at + 1]) % state.size();
    state[place] = static_cast<std::uint8_t>(state[place] ^ data[at + 2]);
  }
  if (size - at == 1) state.resize(state.size() * data[at] / 256);

  const auto other = SearchFor(d, data);
  BitReader in(state);
  const auto loaded = other->Load(in);
  if (!loaded) {
    if (loaded.error().what.empty() || state == sound) std::abort();
    return 0;
  }
  for (int round = 0; round < 12; ++round) {
    const bool more = Round(*other);
    if (other->Evaluations() > d.search.evaluations + 1000 || std::isnan(other->BestFitness())) std::abort();
    if (state == sound && (Round(*search) != more || SavedState(*search) != SavedState(*other))) std::abort();
    if (!more) break;
  }
  return 0;
}
