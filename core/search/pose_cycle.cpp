// SPDX-License-Identifier: MIT
#include "core/search/pose_cycle.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "core/numeric/scalar_math.h"
#include "core/search/rule_moves.h"

namespace gaitsmith {

namespace {

constexpr int kDraws = 120;      // genomes of the first batch
constexpr int kContenders = 6;   // that begin the race
constexpr int kFirstRung = 33;   // evaluations of each contender in the first rung; doubles
constexpr int kPatience = 40;    // generations without improvement after which a run ends
constexpr float kGain = 0.001f;  // of fitness: an improvement
constexpr double kSigma = 0.2;
constexpr double kNarrowest = 1e-4;
constexpr int kChildren = 4;         // of a climb's generation: one register
constexpr std::size_t kMemory = 50;  // generations after which the climb forgets how good its parent was
constexpr int kSightings = 32;
constexpr int kMaxStream = 1000;    // exceeds every population
constexpr int kPerBody = 4;         // genomes of the first batch that share a body: one register
constexpr int kBodyTurn = 3;        // one of so many generations of the climb changes the body
constexpr double kBodyMoves = 3.0;  // genes of a body that change at a time, on average
constexpr double kLeastBodyStep = 0.01;
constexpr double kBodyStepRatio = 30.0;
constexpr int kBodyStream = kMaxStream - 1;

/// Indices of the scores, the greatest fitness first; equals stay in order.
std::vector<std::size_t> BestFirst(std::span<const Score> scores) {
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return scores[a].fitness != scores[b].fitness ? scores[a].fitness > scores[b].fitness : a < b;
  });
  return order;
}

/// How many times as many evaluations the last contender has. A timer leaves less for the climb.
int LastRung(SenseKind senses) { return senses == SenseKind::kTimer ? 12 : 6; }

int PopulationOf(const CycleForm& form, const BankShape& bank) {
  return CmaDistribution::UsualPopulation(DimensionsOf(form, bank));
}

}  // namespace

PoseCycle::PoseCycle(const SearchSettings& settings, const SearchSpace& space)
    : BatchSearch(settings, space) {}

bool PoseCycle::HasCycles() const {
  const ControllerShape& shape = Space().shape;
  return shape.Kind() != ControllerKind::kNetwork && shape.Bank().rules > 1 && shape.Bank().joints > 0;
}

std::vector<float> PoseCycle::PopulationFitness() const {
  if (!parent_.genome.empty()) return {parent_.fitness};
  std::vector<float> fitness;
  fitness.reserve(contenders_.size());
  for (const Contender& one : contenders_) fitness.push_back(one.best.fitness);
  return fitness;
}

std::pair<CycleForm, std::vector<double>> PoseCycle::Draw(int individual) const {
  RandomStream random = Stream(individual, 0);
  const CycleForm form = DrawForm(Space().shape.Bank(), Space().senses.kind, random);
  return {form, DrawPoint(form, Space().shape.Bank(), random)};
}

Genome PoseCycle::DrawBody(int individual) const {
  Genome body(Space().shape.BodyGenes(), kUnchangedGene);
  if (individual < kPerBody) return body;  // the drawn one
  RandomStream random = Stream(individual / kPerBody * kMaxStream + kBodyStream, 0);
  for (Gene& gene : body) gene = random.Gene();
  return body;
}

Genome PoseCycle::GenomeOf(const CycleForm& form, std::span<const double> point,
                           std::span<const Gene> body) const {
  const ControllerShape& shape = Space().shape;
  Genome genome = shape.Kind() == ControllerKind::kTrajectory
                      ? CycleAt(form, point, shape.Curves())
                      : CycleAt(form, point, shape.Bank(), Space().senses.kind);
  genome.insert(genome.end(), body.begin(), body.end());
  return genome;
}

Genome PoseCycle::MoveBody(const Genome& parent, RandomStream& random) const {
  const std::size_t genes = Space().shape.BodyGenes();
  const double chance = std::min(1.0, kBodyMoves / static_cast<double>(genes));
  Genome child = parent;
  const double step = kLeastBodyStep * Exp(random.Uniform() * Log(kBodyStepRatio));
  do {
    for (std::size_t i = child.size() - genes; i < child.size(); ++i) {
      if (random.Chance(chance)) child[i] = GeneOf(child[i] * (1.0 / kGeneMax) + step * random.Normal());
    }
  } while (child == parent);
  return child;
}

PoseCycle::Contender PoseCycle::Enter(const CycleForm& form, std::vector<double> point, int stream) const {
  Contender one;
  one.form = form;
  one.stream = stream;
  one.distribution = {std::move(point), kSigma, PopulationOf(form, Space().shape.Bank()), true};
  return one;
}

std::vector<std::vector<double>> PoseCycle::PointsOf(const Contender& one) const {
  std::vector<std::vector<double>> points;
  for (int k = 0; k < one.distribution.Population(); ++k) {
    RandomStream random = Stream(one.stream * kMaxStream + k, 1 + one.generations);
    points.push_back(one.distribution.Sample(random));
    for (double& x : points.back()) x = std::clamp(x, 0.0, 1.0);
  }
  return points;
}

std::vector<Genome> PoseCycle::Propose() const {
  std::vector<Genome> batch;
  const ControllerShape& shape = Space().shape;
  if (!parent_.genome.empty()) {
    const bool body = shape.BodyGenes() > 0 && generation_ % kBodyTurn == 0;
    for (int k = 0; k < kChildren; ++k) {
      RandomStream random = Stream(k, generation_);
      if (body && shape.Kind() != ControllerKind::kNetwork) {
        batch.push_back(MoveBody(parent_.genome, random));
        continue;
      }
      batch.push_back(shape.Kind() == ControllerKind::kRules
                          ? MoveRules(parent_.genome, sightings_, shape.Bank(), random)
                          : Perturb(parent_.genome, shape, Space().senses, Settings().variation, random));
    }
    return batch;
  }
  for (const Contender& one : contenders_) {
    if (!InRung(one)) continue;
    for (const auto& point : PointsOf(one))
      batch.push_back(GenomeOf(one.form, point, BodyIn(one.best.genome)));
  }
  if (!batch.empty()) return batch;
  if (!Space().start.empty()) return {Space().start};
  for (int k = 0; k < kDraws; ++k) {
    if (!HasCycles()) {
      batch.push_back(First(k));
      continue;
    }
    const auto [form, point] = Draw(k);
    batch.push_back(GenomeOf(form, point, DrawBody(k)));
  }
  return batch;
}

void PoseCycle::See(Genome genome) {
  seen_ = std::move(genome);
  if (Space().sightings) sightings_ = Space().sightings(seen_, kSightings);
}

void PoseCycle::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  ++generation_;
  if (!contenders_.empty()) {
    for (Contender& one : contenders_) {
      if (!InRung(one)) continue;
      const auto population = static_cast<std::size_t>(one.distribution.Population());
      Adapt(one, scores.first(population));
      scores = scores.subspan(population);
    }
    EndRungs();
    return;
  }
  const bool first = parent_.genome.empty();
  if (first && HasCycles() && Space().start.empty()) {
    BeginRace(scores);
    return;
  }
  const auto best = std::ranges::max_element(scores, {}, &Score::fitness);
  Individual child = {batch[static_cast<std::size_t>(best - scores.begin())], best->fitness};
  if (first) {
    BeginClimb(std::move(child));
  } else {
    Climb(std::move(child));
  }
}

void PoseCycle::BeginClimb(Individual parent) {
  parent_ = std::move(parent);
  past_.assign(kMemory, parent_.fitness);
  See(parent_.genome);
}

void PoseCycle::Climb(Individual child) {
  float& past = past_[static_cast<std::size_t>(generation_) % kMemory];
  if (child.fitness >= parent_.fitness || child.fitness >= past) {
    // A child that is exactly as good hardly ever moves otherwise.
    const bool moves_alike = child.fitness == parent_.fitness;
    parent_ = std::move(child);
    if (!moves_alike) See(parent_.genome);
  }
  past = parent_.fitness;
}

void PoseCycle::BeginRace(std::span<const Score> scores) {
  const std::vector<std::size_t> order = BestFirst(scores);
  for (int i = 0; i < kContenders; ++i) {
    const std::size_t drawn = order[static_cast<std::size_t>(i)];
    const auto [form, point] = Draw(static_cast<int>(drawn));
    contenders_.push_back(Enter(form, point, i + 1));
    contenders_.back().best = {GenomeOf(form, point, DrawBody(static_cast<int>(drawn))),
                               scores[drawn].fitness};
  }
  rung_ = kFirstRung;
}

void PoseCycle::Adapt(Contender& one, std::span<const Score> scores) {
  const std::vector<std::vector<double>> points = PointsOf(one);
  const std::vector<std::size_t> order = BestFirst(scores);
  std::vector<std::vector<double>> ranked;
  ranked.reserve(order.size());
  for (const std::size_t i : order) ranked.push_back(points[i]);
  ++one.generations;
  one.evaluations += static_cast<int>(points.size());
  one.distribution.Adapt(ranked, one.generations);

  const float fitness = scores[order.front()].fitness;
  one.stale = fitness > one.best.fitness + kGain ? 0 : one.stale + 1;
  if (fitness > one.best.fitness) {
    one.best = {GenomeOf(one.form, ranked.front(), BodyIn(one.best.genome)), fitness};
  }
  one.ended = one.stale > kPatience || !one.distribution.Sound() || one.distribution.Spread() < kNarrowest;
}

void PoseCycle::EndRungs() {
  while (std::ranges::none_of(contenders_, [&](const Contender& one) { return InRung(one); })) {
    std::ranges::sort(contenders_, [](const Contender& a, const Contender& b) {
      return a.best.fitness != b.best.fitness ? a.best.fitness > b.best.fitness : a.stream < b.stream;
    });
    if (contenders_.size() == 1) {
      BeginClimb(std::move(contenders_.front().best));
      contenders_.clear();
      return;
    }
    contenders_.resize((contenders_.size() + 1) / 2);
    rung_ *= contenders_.size() == 1 ? LastRung(Space().senses.kind) : 2;
  }
}

void PoseCycle::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  out.Put(static_cast<std::uint32_t>(rung_), 32);
  PutGenome(out, parent_.genome, parent_.fitness);
  for (const Gene gene : seen_) out.Put(gene, 16);
  for (const float fitness : past_) out.Put(std::bit_cast<std::uint32_t>(fitness), 32);
  out.Put(static_cast<std::uint32_t>(contenders_.size()), 32);
  for (const Contender& one : contenders_) {
    for (const int count :
         {one.form.poses, one.form.repeats, one.stream, one.evaluations, one.generations, one.stale}) {
      out.Put(static_cast<std::uint32_t>(count), 32);
    }
    out.Put(one.ended ? 1 : 0, 1);
    PutGenome(out, one.best.genome, one.best.fitness);
    one.distribution.Save(out);
  }
}

bool PoseCycle::LoadState(BitReader& in) {
  const std::size_t genes = Space().shape.Genes();
  const int most = Settings().evaluations + 1;
  int count = 0;
  if (!TakeCount(in, generation_, most) || !TakeCount(in, rung_, kFirstRung << 8)) return false;
  Individual parent;
  if (!TakeGenome(in, parent.genome, parent.fitness, genes)) return false;
  Genome seen(parent.genome.size());
  for (Gene& gene : seen) gene = static_cast<Gene>(in.Take(16));
  std::vector<float> past(parent.genome.empty() ? 0 : kMemory);
  for (float& fitness : past) fitness = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
  if (std::ranges::any_of(past,
                          [](float fitness) { return !(fitness < std::numeric_limits<float>::infinity()); }))
    return false;
  if (!TakeCount(in, count, kContenders)) return false;
  const bool climbs = !parent.genome.empty(), races = count > 0;
  if ((climbs || races) != (generation_ > 0) || (climbs && races)) return false;
  if (races && (!HasCycles() || !Space().start.empty() || rung_ < kFirstRung)) return false;
  contenders_.clear();
  for (int i = 0; i < count; ++i) {
    CycleForm form;
    const BankShape& bank = Space().shape.Bank();
    if (!TakeCount(in, form.poses, std::min(3, bank.rules)) || form.poses < 1) return false;
    if (!TakeCount(in, form.repeats, bank.rules / form.poses) || form.repeats < 1) return false;
    Contender one = Enter(form, std::vector<double>(DimensionsOf(form, bank)), 0);
    if (!TakeCount(in, one.stream, kContenders)) return false;
    for (int* number : {&one.evaluations, &one.generations, &one.stale}) {
      if (!TakeCount(in, *number, most)) return false;
    }
    one.ended = in.Take(1) != 0;
    if (!TakeGenome(in, one.best.genome, one.best.fitness, genes) || one.best.genome.empty()) return false;
    if (!one.distribution.Load(in)) return false;
    contenders_.push_back(std::move(one));
  }
  parent_ = std::move(parent);
  past_ = std::move(past);
  sightings_.clear();
  if (in.Overrun()) return true;  // the caller reports the error
  if (climbs) See(std::move(seen));
  return !races || std::ranges::any_of(contenders_, [&](const Contender& one) { return InRung(one); });
}

std::unique_ptr<Search> MakePoseCycle(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<PoseCycle>(settings, space);
}

}  // namespace gaitsmith
