// SPDX-License-Identifier: MIT
// Searches over genomes with an ask/tell interface: a search proposes genomes and receives their scores in
// the same order. One evaluator therefore serves all searches, and a search can pause, resume, be cancelled
// and be tested without physics. The result of a finished search depends only on its settings. It does not
// depend on how many genomes are requested at a time, nor on where they are evaluated. During the search the
// best may come from ahead of the serial order, so a search that is stopped early can give a different
// result.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/numeric/bit_stream.h"
#include "core/numeric/error.h"
#include "core/search/operators.h"
#include "core/signal/traits.h"

namespace gaitsmith {

enum class Algorithm {
  kRandomSearch,  // RG&T: random generate and test
  kSphc,          // stochastic population hill climbing, Figure 5
  kGga,           // generational genetic algorithm, Figure 2
  kSsga,          // steady-state genetic algorithm, Figure 3
  kShc,           // stochastic hill climbing, Figure 4
  kMpga,          // massively parallel genetic algorithm, Figure 1
  kNelderMead,    // downhill simplex
  kPowell,        // direction set
  kCmaEs,         // covariance matrix adaptation
  kMapElites,     // the best motion of every style
  kTwoStage,      // random generate and test, then ascents from the best
  kPoseCycle,     // a race of CMA-ES over pose cycles, then moves of rules that act
  kDifferentialEvolution,
  kNsga,    // NSGA-II: the front between the score and a cost
  kCmaMae,  // MAP-Elites whose children come from CMA-ES
};

/// What becomes of controllers that are alike, so that one kind does not fill the population.
enum class Niching {
  kNone,
  kKept,  // GGA shares fitness among them [Goldberg Richardson 1987]; in SSGA a child takes the place of the
          // parent that it is more like, if it is fitter [Mahfoud 1995]
};
inline constexpr std::array<std::string_view, 2> kNichingNames = {"none", "kept"};

/// Parameters of GGA and SSGA, and the rates of MPGA.
struct GeneticSettings {
  int population = 200;  // GGA, SSGA, [2, 10000]; Table 2: 200
  Rates rates;
  float rank_bias = 1.5f;  // SSGA: how many times as often the fittest is chosen as the median, [1, 2]
  Niching niching = Niching::kNone;  // GGA, SSGA
};

/// Parameters of MPGA: one processor per cell of a square torus.
struct TorusSettings {
  int side = 64;        // cells per side, [2, 128]; the paper's Connection Machine: 64 x 64
  int walk_steps = 10;  // steps of the random walk to find a mate, [1, 1000]
};

/// Parameters of Nelder-Mead and Powell.
struct RefineSettings {
  float step = 0.1f;  // first step along a gene, as a share of its range, [0.001, 1]
};

enum class Covariance {
  kAutomatic,  // full up to kMaxFullGenes genes, else separable
  kFull,
  kSeparable,  // variances only
};
inline constexpr std::array<std::string_view, 3> kCovarianceNames = {"automatic", "full", "separable"};
inline constexpr int kMaxFullGenes = 128;  // limit of the automatic choice; Star-Man's timer banks have 70
/// Limit for any full covariance: 600^2 numbers are 3 MB.
inline constexpr std::size_t kMaxCovarianceGenes = 600;

enum class CmaGenes {
  kCared,  // intervals that the run's first genome ignores stay ignored
  kAll,
};
inline constexpr std::array<std::string_view, 2> kCmaGenesNames = {"cared-for", "all"};

/// What a run that has stalled is followed by.
enum class Restarts {
  kGrowing,  // a larger population each time: IPOP [Auger Hansen 2005]
  kBipop,    // either that, or a small population with a smaller step, whichever has spent less [Hansen 2009]
};
inline constexpr std::array<std::string_view, 2> kRestartsNames = {"growing", "bipop"};

struct CmaSettings {
  CmaGenes genes = CmaGenes::kCared;
  Covariance covariance = Covariance::kAutomatic;
  int population = 0;   // lambda, 0 or [4, 10000]; 0: 4 + 3 ln(genes) [Hansen 2016]
  float step = 0.3f;    // first standard deviation, as a share of a gene's range, [0.001, 1]
  float growth = 2.0f;  // growth of the population at every restart, [1, 10]
  Restarts restarts = Restarts::kGrowing;
  int draws = 50;  // random genomes, the best of which begins a run, [1, 10000]
};

struct ElitesSettings {
  int initial = 200;  // random genomes in the first batch, [1, 100000]
  int batch = 32;  // children proposed together, [1, 1000]; changes the result, unlike the number of workers
  int bins = 8;    // bins per style term, [1, 32]
  // Upper end of the last bin of each term, (0, 1000]. Larger values fall into the last bin.
  std::array<float, 3> most = {4.0f, 10.0f, 4.0f};  // height [m], slip [m], rotations
  float crossover = 0.0f;  // MAP-Elites: chance that a child takes whole rules from two elites, [0, 1]
  int emitters = 5;        // CMA-MAE: distributions that sample side by side, [1, 100]
  float learning = 0.01f;  // CMA-MAE: how fast a cell asks for more, [0, 1]: alpha
};

struct DifferenceSettings {
  int population = 50;     // [4, 10000]
  float weight = 0.5f;     // of the difference, [0, 2]
  float crossover = 0.9f;  // chance that a gene is the changed one, [0, 1]
};

/// What a front sets against the score: as little as possible of it.
enum class Cost { kEffort, kSlip };
inline constexpr std::array<std::string_view, 2> kCostNames = {"effort", "slip"};
inline constexpr std::array<Trait, 2> kCostTraits = {Trait::kEffort, Trait::kSlip};
/// By second, and in sizes of the figure or for each joint, so that it means the same for all.
[[nodiscard]] inline float CostOf(const Traits& traits, Cost cost) {
  return TraitOf(traits, kCostTraits[static_cast<std::size_t>(cost)]);
}

struct TwoStageSettings {
  int random = 1000;  // random genomes of the first stage, [1, 1000000]
  int kept = 5;       // ascents in the second stage, [1, 1000]
};

inline constexpr int kMaxHandovers = 64;
/// A controller of the document that runs from the start, and the step at which it hands over the figure.
struct Handover {
  int controller = 0;
  int step = 0;  // [0, kMaxSteps - 1]
};

/// How far a search may change the figure's body.
enum class BodyFreedom {
  kNone,    // it stays as it is
  kLittle,  // lengths, masses and joint limits are multiplied or divided by 1.25 at most
  kLot,     // by 2 at most
};
inline constexpr std::array<std::string_view, 3> kBodyFreedomNames = {"none", "little", "lot"};
/// By how many times a part may differ from what was drawn.
inline constexpr std::array<float, 3> kBodyTimes = {1.0f, 1.25f, 2.0f};

/// The finest time step of the worlds in which a search tries controllers, as a part of the usual 0.01 s.
enum class FinestStep { kUsual, kHalf, kQuarter, kEighth };
inline constexpr std::array<std::string_view, 4> kFinestStepNames = {"usual", "half", "quarter", "eighth"};

struct SearchSettings {
  Algorithm algorithm = Algorithm::kSphc;
  std::uint32_t seed = 1;
  int evaluations = 40000;    // simulations allowed, [1, 100 million]; Table 2 of the paper: 40,000
  int population = 10;        // SPHC, [2, 1000]; Table 2: 10
  int reseed_interval = 200;  // SPHC: generations between reseedings, [1, 1 million]; Table 2: 200
  Variation variation;
  BodyFreedom body = BodyFreedom::kNone;
  int start = -1;  // controller of the document that the search starts with; -1: a random one
  /// The clip that the controller replaces. The controller is scored from the state in which the clips before
  /// it leave the figure, for the duration of the clip. -1: scored from the start, for the duration of the
  /// task.
  int in_place_of = -1;
  /// The controller is also scored from the states in which these leave the figure. Not together with
  /// in_place_of.
  std::vector<Handover> handovers = {};
  /// In how many worlds a controller is tried, of which the document's own is one. From 2 on its score is the
  /// mean, which finds robust controllers (core/document/trial_worlds.h).
  int worlds = 1;
  /// In worlds other than the document's own physics takes steps down to this.
  FinestStep finest_step = FinestStep::kUsual;
  GeneticSettings genetic;
  TorusSettings torus;
  RefineSettings refine;
  CmaSettings cma;
  ElitesSettings elites;
  TwoStageSettings two_stage;
  DifferenceSettings difference;
  Cost cost = Cost::kEffort;  // NSGA-II
};

/// The score of a motion that a search receives.
struct Score {
  float fitness = 0.0f;
  std::array<float, 3> style = {};  // unweighted secondary terms in the order of Table 3, for MAP-Elites
  Traits traits = {};               // if the problem measures them, for Brood and NSGA-II
};

/// A fitness at or below this means that there is no real motion (the evaluator's kVoidScore is -1e9).
/// Genetic algorithms that use differences of fitness must ignore it.
inline constexpr float kNoMotion = -1e8f;

class Search {
 public:
  virtual ~Search() = default;

  /// The next genomes to evaluate: about `wanted` of them, fewer if later proposals depend on scores still
  /// missing, and none once the budget is spent. Tell must follow before the next Ask.
  [[nodiscard]] virtual std::vector<Genome> Ask(int wanted) = 0;

  /// Whether several Asks may be open at once, so that evaluators need not wait for each other. Tells then
  /// answer the Asks in order. Ask returns an empty batch while every proposal depends on scores that have
  /// not arrived.
  [[nodiscard]] virtual bool AsksAhead() const { return false; }

  /// Passes the scores of the oldest open Ask, in its order. NaN ranks below every other fitness.
  virtual void Tell(std::span<const Score> scores) = 0;
  /// Passes fitness without style, for searches that do not use style.
  void Tell(std::span<const float> fitness);

  /// Number of evaluations that the serial algorithm would have made by now.
  [[nodiscard]] virtual int Evaluations() const = 0;
  [[nodiscard]] virtual bool Done() const = 0;

  /// The best genome so far. Empty before the first Tell.
  [[nodiscard]] virtual const Genome& BestGenome() const = 0;
  [[nodiscard]] virtual float BestFitness() const = 0;

  /// One point for every improvement of the best, in the order of the serial algorithm.
  struct CurvePoint {
    int evaluation;  // from 1
    float best;
  };
  [[nodiscard]] virtual const std::vector<CurvePoint>& Curve() const = 0;

  /// Fitness of the present population, for display only: the climbs, the population, the last generation,
  /// the simplex or the elites. Empty for RG&T, which has no population, and before the first generation is
  /// scored. CMA-ES does not save it, so it is empty after a Load until the next generation.
  [[nodiscard]] virtual std::vector<float> PopulationFitness() const = 0;

  /// The whole state between a Tell and an Ask. A Load of it continues with the same result.
  virtual void Save(BitWriter&) const = 0;
  [[nodiscard]] virtual Result<void> Load(BitReader&) = 0;
};

/// Groups of settings. A bit of each says whether an algorithm reads it.
namespace settings_group {
inline constexpr unsigned kClimbs = 1;          // population, reseed_interval
inline constexpr unsigned kPopulation = 2;      // genetic.population
inline constexpr unsigned kRates = 4;           // genetic.rates
inline constexpr unsigned kRankBias = 8;        // genetic.rank_bias
inline constexpr unsigned kTorus = 16;          // torus
inline constexpr unsigned kRefine = 32;         // refine
inline constexpr unsigned kCma = 64;            // cma
inline constexpr unsigned kElites = 128;        // elites
inline constexpr unsigned kStages = 256;        // two_stage
inline constexpr unsigned kVariation = 512;     // variation: settings of perturbation
inline constexpr unsigned kNiching = 1024;      // genetic.niching
inline constexpr unsigned kCrossing = 2048;     // genetic.crossing
inline constexpr unsigned kRestarts = 4096;     // cma.restarts, growth and draws
inline constexpr unsigned kBatches = 8192;      // elites.batch, crossover
inline constexpr unsigned kEmitters = 16384;    // elites.emitters, learning
inline constexpr unsigned kDifference = 32768;  // difference
inline constexpr unsigned kCost = 65536;        // cost
}  // namespace settings_group

/// @param settings must be valid, as in a valid document
using SearchMaker = std::unique_ptr<Search>(const SearchSettings&, const SearchSpace&);
// Each is defined beside its algorithm.
SearchMaker MakeRandomSearch, MakeSphc, MakeGga, MakeSsga, MakeShc, MakeMpga, MakeNelderMead, MakePowell,
    MakeCmaEs, MakeMapElites, MakeTwoStage, MakePoseCycle, MakeDifferentialEvolution, MakeNsga, MakeCmaMae;

/// A row of the algorithm table.
struct AlgorithmRow {
  Algorithm algorithm;
  std::string_view name;
  unsigned groups;                           // of settings that it reads
  bool refines_one;                          // improves one given genome
  int (*population)(const SearchSettings&);  // that the budget must hold; 0: none
  SearchMaker* make;
};

/// The one table of algorithms. A new one goes to the end: binary documents hold its place.
inline constexpr auto kAlgorithms = [] {
  using namespace settings_group;
  using enum Algorithm;
  using S = const SearchSettings&;
  constexpr auto kNone = [](S) { return 0; };
  constexpr auto kOfParents = [](S s) { return s.genetic.population; };
  constexpr auto kOfCells = [](S s) { return s.torus.side * s.torus.side; };
  constexpr auto kOfMembers = [](S s) { return s.difference.population; };
  return std::to_array<AlgorithmRow>({
      {kRandomSearch, "rgt", 0, false, kNone, MakeRandomSearch},
      {kSphc, "sphc", kClimbs | kVariation, false, kNone, MakeSphc},
      {kGga, "gga", kPopulation | kRates | kCrossing | kNiching | kVariation, false, kOfParents, MakeGga},
      {kSsga, "ssga", kPopulation | kRates | kCrossing | kRankBias | kNiching | kVariation, false, kOfParents,
       MakeSsga},
      {kShc, "shc", kVariation, true, kNone, MakeShc},
      {kMpga, "mpga", kTorus | kRates | kVariation, false, kOfCells, MakeMpga},
      {kNelderMead, "nelder-mead", kRefine, true, kNone, MakeNelderMead},
      {kPowell, "powell", kRefine, true, kNone, MakePowell},
      {kCmaEs, "cma-es", kCma | kRestarts, true, kNone, MakeCmaEs},
      {kMapElites, "map-elites", kElites | kBatches | kVariation, false, kNone, MakeMapElites},
      {kTwoStage, "two-stage", kStages | kVariation, false, kNone, MakeTwoStage},
      {kPoseCycle, "pose-cycle", 0, true, kNone, MakePoseCycle},
      {kDifferentialEvolution, "de", kDifference, false, kOfMembers, MakeDifferentialEvolution},
      {kNsga, "nsga-ii", kPopulation | kRates | kCrossing | kCost | kVariation, false, kOfParents, MakeNsga},
      {kCmaMae, "cma-mae", kElites | kEmitters | kCma, false, kNone, MakeCmaMae},
  });
}();
static_assert([] {
  for (std::size_t i = 0; i < kAlgorithms.size(); ++i) {
    if (kAlgorithms[i].algorithm != static_cast<Algorithm>(i)) return false;
  }
  return true;
}());

/// One column of the table. A program that reads no more than a column does not link the algorithms.
template <class T>
[[nodiscard]] consteval std::array<T, kAlgorithms.size()> AlgorithmColumn(T AlgorithmRow::* column) {
  std::array<T, kAlgorithms.size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = kAlgorithms[i].*column;
  return values;
}
/// Names on the command line and in documents.
inline constexpr auto kAlgorithmNames = AlgorithmColumn(&AlgorithmRow::name);
inline constexpr auto kAlgorithmGroups = AlgorithmColumn(&AlgorithmRow::groups);
inline constexpr auto kRefinesOne = AlgorithmColumn(&AlgorithmRow::refines_one);
inline constexpr auto kPopulations = AlgorithmColumn(&AlgorithmRow::population);

/// How many evaluations the first population alone takes; 0 where the algorithm has none.
[[nodiscard]] inline int PopulationOf(const SearchSettings& settings) {
  return kPopulations[static_cast<std::size_t>(settings.algorithm)](settings);
}

/// @return nothing for an algorithm that this build leaves out (search.cpp)
[[nodiscard]] SearchMaker MakeSearch;

}  // namespace gaitsmith
