// SPDX-License-Identifier: MIT
#include "shell/words/search_parameters.h"

#include <algorithm>
#include <array>

#include "core/document/trial_worlds.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr std::array<const char*, 2> kReadings = {TrLater("Per child"), TrLater("Per component")};
constexpr std::array<const char*, 2> kCopies = {TrLater("Kept"), TrLater("Perturbed")};
constexpr std::array<const char*, 2> kHeedless = {TrLater("Allowed"), TrLater("Forbidden")};
constexpr std::array<const char*, 3> kBodies = {TrLater("Stays as it is"), TrLater("May change a little"),
                                                TrLater("May change a lot")};
constexpr std::array<const char*, 4> kFinestSteps = {TrLater("As usual"), TrLater("Half"),
                                                     TrLater("A quarter"), TrLater("An eighth")};
constexpr std::array<const char*, 2> kCmaGenes = {TrLater("Of used senses"), TrLater("All")};
constexpr std::array<const char*, 3> kCovariances = {TrLater("Automatic"), TrLater("Full"),
                                                     TrLater("Variances only")};

constexpr std::array<const char*, 2> kNichings = {TrLater("May fill the population"),
                                                  TrLater("Compete with one another")};
constexpr std::array<const char*, 2> kCrossings = {TrLater("Whole rules of each"), TrLater("Blends of both")};
constexpr std::array<const char*, 2> kRestartKinds = {TrLater("Ever larger"),
                                                      TrLater("Large and small in turn")};
constexpr std::array<const char*, 2> kCosts = {TrLater("Effort"), TrLater("Slip")};

struct Row {
  unsigned group;  // of settings, or 0: all algorithms read it
  SearchParameter parameter;
};

const std::vector<Row>& AlgorithmRows() {
  using S = SearchSettings;
  using namespace settings_group;
  static const std::vector<Row> kRows = {
      {0,
       {"search/body", TrLater("The body"),
        TrLater(
            "Lengths, masses and joint limits may change by a quarter, or to twice and half. Total length "
            "and mass stay."),
        ChoiceParameter{kBodies, [](const S& s) { return static_cast<int>(s.body); },
                        [](S& s, int i) { s.body = static_cast<BodyFreedom>(i); }}}},
      {0,
       {"search/worlds", TrLater("Worlds"),
        TrLater("Each candidate is tried in this many worlds, some steeper, some more slippery, heavier or "
                "slower. Their mean counts."),
        WholeParameter{1, kMaxWorlds, 1, [](S& s) -> int& { return s.worlds; }}}},
      {0,
       {"search/finest-step", TrLater("Finest step"),
        TrLater("In the other worlds physics takes shorter time steps, down to this part of 0.01 s. Such "
                "motions rely less on how this simulator computes."),
        ChoiceParameter{kFinestSteps, [](const S& s) { return static_cast<int>(s.finest_step); },
                        [](S& s, int i) { s.finest_step = static_cast<FinestStep>(i); }},
        [](const S& s) { return s.worlds > 1; }}},
      {kClimbs,
       {"search/population", TrLater("Population"), TrLater("Number of parallel candidates."),
        WholeParameter{2, 1000, 1, [](S& s) -> int& { return s.population; }}}},
      {kClimbs,
       {"search/reseed", TrLater("Reseed every (generations)"),
        TrLater("How often the best half takes over."),
        WholeParameter{1, 1'000'000, 10, [](S& s) -> int& { return s.reseed_interval; }}}},
      {kPopulation,
       {"search/genetic-population", TrLater("Population"),
        TrLater("Controllers that mate with one another."),
        WholeParameter{2, 10'000, 10, [](S& s) -> int& { return s.genetic.population; }}}},
      {kTorus,
       {"search/side", TrLater("Side of the torus"),
        TrLater("Cells along one side. The population is the square of this number."),
        WholeParameter{2, 128, 1, [](S& s) -> int& { return s.torus.side; }}}},
      {kTorus,
       {"search/walk", TrLater("Walk to a mate (steps)"),
        TrLater("The fittest controller on the walk becomes the mate."),
        WholeParameter{1, 1000, 1, [](S& s) -> int& { return s.torus.walk_steps; }}}},
      {kRates,
       {"search/mutation", TrLater("Mutation rate"),
        TrLater("Chance that a child, or a gene of it, is perturbed."),
        RealParameter{0.0, 1.0, 0.01, false, [](S& s) -> float& { return s.genetic.rates.mutation; }}}},
      {kRates,
       {"search/crossover", TrLater("Crossover rate"),
        TrLater("Chance that a child, or a rule of it, comes from both parents."),
        RealParameter{0.0, 1.0, 0.01, false, [](S& s) -> float& { return s.genetic.rates.crossover; }}}},
      {kRates,
       {"search/rates", TrLater("Rates count"), TrLater("For a child as a whole, or for each rule and gene."),
        ChoiceParameter{kReadings, [](const S& s) { return static_cast<int>(s.genetic.rates.reading); },
                        [](S& s, int i) { s.genetic.rates.reading = static_cast<RateReading>(i); }}}},
      {kRates,
       {"search/copies", TrLater("Copies of a parent"),
        TrLater("A kept copy is simulated again, with the same score."),
        ChoiceParameter{kCopies, [](const S& s) { return static_cast<int>(s.genetic.rates.copies); },
                        [](S& s, int i) { s.genetic.rates.copies = static_cast<Copies>(i); }}}},
      {kCrossing,
       {"search/crossing", TrLater("Hybrids are"),
        TrLater("Rules that work are kept whole. Blends suit numbers."),
        ChoiceParameter{kCrossings, [](const S& s) { return static_cast<int>(s.genetic.rates.crossing); },
                        [](S& s, int i) { s.genetic.rates.crossing = static_cast<Crossing>(i); }}}},
      {kNiching,
       {"search/niching", TrLater("Controllers that are alike"),
        TrLater("If they compete, several kinds live side by side."),
        ChoiceParameter{kNichings, [](const S& s) { return static_cast<int>(s.genetic.niching); },
                        [](S& s, int i) { s.genetic.niching = static_cast<Niching>(i); }}}},
      {kCost,
       {"search/cost", TrLater("Cost"), TrLater("What the score is set against. Less of it is better."),
        ChoiceParameter{kCosts, [](const S& s) { return static_cast<int>(s.cost); },
                        [](S& s, int i) { s.cost = static_cast<Cost>(i); }}}},
      {kDifference,
       {"search/members", TrLater("Population"),
        TrLater("Controllers that move by each other’s differences."),
        WholeParameter{4, 10'000, 10, [](S& s) -> int& { return s.difference.population; }}}},
      {kDifference,
       {"search/difference-weight", TrLater("Weight of a difference"),
        TrLater("How far a controller moves, in differences of two others."),
        RealParameter{0.0, 2.0, 0.01, false, [](S& s) -> float& { return s.difference.weight; }}}},
      {kDifference,
       {"search/difference-crossover", TrLater("Moved genes"), TrLater("Chance that a gene moves."),
        RealParameter{0.0, 1.0, 0.01, false, [](S& s) -> float& { return s.difference.crossover; }}}},
      {kRankBias,
       {"search/rank-bias", TrLater("Rank bias"),
        TrLater("Matings of the fittest for each mating of the median."),
        RealParameter{1.0, 2.0, 0.01, false, [](S& s) -> float& { return s.genetic.rank_bias; }}}},
      {kRefine,
       {"search/refine-step", TrLater("First step"), TrLater("Along each gene, as a share of its range."),
        RealParameter{0.001, 1.0, 0.001, true, [](S& s) -> float& { return s.refine.step; }}}},
      {kCma,
       {"search/step", TrLater("First deviation"),
        TrLater("How far the first samples scatter, as a share of a gene's range."),
        RealParameter{0.001, 1.0, 0.001, true, [](S& s) -> float& { return s.cma.step; }}}},
      {kCma,
       {"search/cma-population", TrLater("Samples (0: by genes)"),
        TrLater("In each generation. 0 means 4 + 3 ln(genes)."),
        WholeParameter{0, 10'000, 1, [](S& s) -> int& { return s.cma.population; }}}},
      {kRestarts,
       {"search/restarts", TrLater("Restarts"), TrLater("The populations of runs that follow a stalled one."),
        ChoiceParameter{kRestartKinds, [](const S& s) { return static_cast<int>(s.cma.restarts); },
                        [](S& s, int i) { s.cma.restarts = static_cast<Restarts>(i); }}}},
      {kRestarts,
       {"search/growth", TrLater("Growth at a restart"),
        TrLater("A search that stalls restarts with more samples."),
        RealParameter{1.0, 10.0, 0.1, false, [](S& s) -> float& { return s.cma.growth; }}}},
      {kRestarts,
       {"search/draws", TrLater("Random at first"), TrLater("Every run starts from the best of these."),
        WholeParameter{1, 10'000, 10, [](S& s) -> int& { return s.cma.draws; }}}},
      {kCma,
       {"search/cma-genes", TrLater("Genes"),
        TrLater("All, or only those of the senses that the first controller uses."),
        ChoiceParameter{kCmaGenes, [](const S& s) { return static_cast<int>(s.cma.genes); },
                        [](S& s, int i) { s.cma.genes = static_cast<CmaGenes>(i); }}}},
      {kCma,
       {"search/covariance", TrLater("Covariance"),
        TrLater("Automatic: full up to 128 genes, which costs time."),
        ChoiceParameter{kCovariances, [](const S& s) { return static_cast<int>(s.cma.covariance); },
                        [](S& s, int i) { s.cma.covariance = static_cast<Covariance>(i); }}}},
      {kElites,
       {"search/initial", TrLater("Random at first"), TrLater("Random motions that fill the grid first."),
        WholeParameter{1, 100'000, 10, [](S& s) -> int& { return s.elites.initial; }}}},
      {kBatches,
       {"search/batch", TrLater("Children at a time"), TrLater("New motions from each look at the grid."),
        WholeParameter{1, 1000, 1, [](S& s) -> int& { return s.elites.batch; }}}},
      {kBatches,
       {"search/elite-crossover", TrLater("Hybrids"),
        TrLater("Chance that a child has whole rules of two motions on the grid."),
        RealParameter{0.0, 1.0, 0.01, false, [](S& s) -> float& { return s.elites.crossover; }}}},
      {kEmitters,
       {"search/emitters", TrLater("Samplings side by side"),
        TrLater("Each starts from a motion on the grid and learns where to go."),
        WholeParameter{1, 100, 1, [](S& s) -> int& { return s.elites.emitters; }}}},
      {kEmitters,
       {"search/learning", TrLater("Rising demands"),
        TrLater("How fast a cell asks for more. At 0 samplings only climb, at 1 they only explore."),
        RealParameter{0.0, 1.0, 0.001, true, [](S& s) -> float& { return s.elites.learning; }}}},
      {kElites,
       {"search/bins", TrLater("Bins of each style term"),
        TrLater("The cube of this number is the number of cells. Each holds one motion."),
        WholeParameter{1, 32, 1, [](S& s) -> int& { return s.elites.bins; }}}},
      {kElites,
       {"search/most-height", TrLater("Greatest height (m)"), TrLater("Where the last bin of height ends."),
        RealParameter{0.1, 1000.0, 0.1, true, [](S& s) -> float& { return s.elites.most[0]; }}}},
      {kElites,
       {"search/most-slip", TrLater("Greatest slip (m)"), TrLater("Where the last bin of slip ends."),
        RealParameter{0.1, 1000.0, 0.1, true, [](S& s) -> float& { return s.elites.most[1]; }}}},
      {kElites,
       {"search/most-rotations", TrLater("Most rotations"), TrLater("Where the last bin of turns ends."),
        RealParameter{0.1, 1000.0, 0.1, true, [](S& s) -> float& { return s.elites.most[2]; }}}},
      {kStages,
       {"search/random", TrLater("Random at first"), TrLater("Random motions in the first stage."),
        WholeParameter{1, 1'000'000, 100, [](S& s) -> int& { return s.two_stage.random; }}}},
      {kStages,
       {"search/kept", TrLater("How many climb"), TrLater("The best random motions climb, each on its own."),
        WholeParameter{1, 1000, 1, [](S& s) -> int& { return s.two_stage.kept; }}}},
  };
  return kRows;
}

const std::vector<Row>& VariationRows() {
  using S = SearchSettings;
  using namespace settings_group;
  static const std::vector<Row> kRows = {
      {0,
       {"search/dont-care", TrLater("Ignored senses"),
        TrLater("Chance that a random rule ignores a physical sense."),
        RealParameter{0.0, 1.0, 0.01, false, [](S& s) -> float& { return s.variation.dont_care; }}}},
      {0,
       {"search/heedless", TrLater("Rules without senses"),
        TrLater("A rule that uses no sense can hold one pose for ever."),
        ChoiceParameter{kHeedless, [](const S& s) { return static_cast<int>(s.variation.heedless); },
                        [](S& s, int i) { s.variation.heedless = static_cast<Heedless>(i); }}}},
      {kVariation,
       {"search/gene-chance", TrLater("Changed genes"),
        TrLater("Chance that a gene of a perturbed controller changes a little."),
        RealParameter{0.001, 1.0, 0.001, true, [](S& s) -> float& { return s.variation.gene_chance; }}}},
      {kVariation,
       {"search/creep", TrLater("Creep"),
        TrLater("Standard deviation of a gene's change, as a share of its range."),
        RealParameter{0.001, 1.0, 0.001, true, [](S& s) -> float& { return s.variation.creep; }}}},
      {kVariation,
       {"search/redraw", TrLater("Redrawn rules"),
        TrLater("Chance that a rule or node of a perturbed controller is drawn anew."),
        RealParameter{0.0, 1.0, 0.01, false, [](S& s) -> float& { return s.variation.redraw; }}}},
  };
  return kRows;
}

std::vector<const SearchParameter*> Of(const std::vector<Row>& rows, Algorithm algorithm) {
  const unsigned groups = kAlgorithmGroups[static_cast<std::size_t>(algorithm)];
  std::vector<const SearchParameter*> parameters;
  for (const Row& row : rows) {
    if (row.group == 0 || (groups & row.group) != 0) parameters.push_back(&row.parameter);
  }
  return parameters;
}

}  // namespace

std::vector<const SearchParameter*> ParametersOf(Algorithm algorithm) {
  return Of(AlgorithmRows(), algorithm);
}
std::vector<const SearchParameter*> VariationOf(Algorithm algorithm) {
  return Of(VariationRows(), algorithm);
}

void Fit(SearchSettings& search) {
  search.evaluations = std::max(search.evaluations, PopulationOf(search));
  // The least population is 4. Below it the slider means "automatic".
  int& samples = search.cma.population;
  if (samples > 0 && samples < 4) samples = samples == 3 ? 0 : 4;
}

}  // namespace gaitsmith::shell
