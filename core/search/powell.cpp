// SPDX-License-Identifier: MIT
#include "core/search/powell.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith {

namespace {

constexpr double kGrid = 1.0 / kGeneMax;
constexpr std::size_t kMaxTrials = 10;  // per line
constexpr double kMinStep = 16.0 * kGrid;
constexpr double kGolden = 0.381966011250105;

}  // namespace

std::optional<double> Powell::NextTrial(std::span<const Trial> tried, double step, double low, double high) {
  if (tried.size() > kMaxTrials) return std::nullopt;
  const Trial top = *std::ranges::max_element(tried, {}, &Trial::fitness);
  std::optional<Trial> left, right;  // the neighbours of top
  for (const Trial& one : tried) {
    if (one.at < top.at && (!left || one.at > left->at)) left = one;
    if (one.at > top.at && (!right || one.at < right->at)) right = one;
  }
  // Not bracketed yet: go further out by twice the last step.
  if (!right && top.at < high - kGrid)
    return std::min(high, top.at + (left ? 2.0 * (top.at - left->at) : step));
  if (!left && top.at > low + kGrid)
    return std::max(low, top.at - (right ? 2.0 * (right->at - top.at) : step));
  // The top of a parabola through the three points, unless it is not a new point.
  if (left && right) {
    const double a = top.at - left->at;
    const double b = right->at - top.at;
    const double rise_left = static_cast<double>(top.fitness) - static_cast<double>(left->fitness);
    const double rise_right = static_cast<double>(top.fitness) - static_cast<double>(right->fitness);
    const double at =
        top.at + 0.5 * (b * b * rise_left - a * a * rise_right) / (b * rise_left + a * rise_right);
    if (at > left->at + kGrid && at < right->at - kGrid && std::abs(at - top.at) > kGrid) return at;
  }
  // Otherwise a golden section of the wider side.
  const double to_left = left ? top.at - left->at : 0.0;
  const double to_right = right ? right->at - top.at : 0.0;
  const double wider = std::max(to_left, to_right) * kGolden;
  if (wider < kGrid) return std::nullopt;
  return to_right >= to_left ? top.at + wider : top.at - wider;
}

Powell::Powell(const SearchSettings& settings, const SearchSpace& space)
    : BatchSearch(settings, space), step_(static_cast<double>(settings.refine.step)) {
  ResetDirections();
}

void Powell::ResetDirections() {
  directions_.assign(Space().shape.Genes(), {});
  axes_.clear();
  for (int gene = 0; std::cmp_less(gene, directions_.size()); ++gene) axes_.push_back(gene);
}

std::vector<float> Powell::PopulationFitness() const {
  if (phase_ == Phase::kFirst) return {};
  return {here_.fitness};
}

std::vector<double> Powell::PointAt(double at) const {
  std::vector<double> point = PointOf(here_.genome);
  const Direction& along = directions_[line_];
  if (along.empty()) point[static_cast<std::size_t>(axes_[line_])] += at;
  for (std::size_t gene = 0; gene < along.size(); ++gene)
    point[gene] += at * static_cast<double>(along[gene]);
  return point;
}

std::vector<Genome> Powell::Propose() const {
  switch (phase_) {
    case Phase::kFirst:
      return {First(0)};
    case Phase::kSweep:
    case Phase::kExtraLine:
      return {GenomeAt(PointAt(next_), Space().shape)};
    case Phase::kBeyond:
      break;
  }
  // As far again as the sweep has moved.
  std::vector<double> point = PointOf(here_.genome);
  const std::vector<double> start = PointOf(start_.genome);
  for (std::size_t gene = 0; gene < point.size(); ++gene) point[gene] += point[gene] - start[gene];
  return {GenomeAt(point, Space().shape)};
}

void Powell::BeginSweep() {
  phase_ = Phase::kSweep;
  start_ = here_;
  gain_ = 0.0;
  gainer_ = 0;
  any_trial_ = false;
  BeginLine(0);
}

void Powell::BeginLine(std::size_t line) {
  line_ = line;
  best_ = here_;
  tried_ = {{0.0, here_.fitness}};
}

void Powell::Advance() {
  while (phase_ == Phase::kSweep || phase_ == Phase::kExtraLine) {
    // The range in which the line stays within the cube.
    double low = -1.0;
    double high = 1.0;
    const std::vector<double> point = PointOf(here_.genome);
    const Direction& along = directions_[line_];
    for (std::size_t gene = 0; gene < point.size(); ++gene) {
      const double slope =
          along.empty() ? (std::cmp_equal(gene, axes_[line_]) ? 1.0 : 0.0) : static_cast<double>(along[gene]);
      if (slope == 0.0) continue;
      const double down = (slope > 0.0 ? -point[gene] : 1.0 - point[gene]) / slope;
      const double up = (slope > 0.0 ? 1.0 - point[gene] : -point[gene]) / slope;
      low = std::max(low, down);
      high = std::min(high, up);
    }
    if (const auto next = NextTrial(tried_, step_, low, high)) {
      next_ = *next;
      any_trial_ = true;
      return;
    }
    FinishLine();
  }
}

void Powell::FinishLine() {
  const double gain = static_cast<double>(best_.fitness) - static_cast<double>(here_.fitness);
  if (gain > gain_) {
    gain_ = gain;
    gainer_ = line_;
  }
  here_ = best_;
  if (phase_ == Phase::kExtraLine) return BeginSweep();
  if (line_ + 1 < directions_.size()) return BeginLine(line_ + 1);
  FinishSweep();
}

void Powell::FinishSweep() {
  if (here_.fitness > start_.fitness) {
    phase_ = Phase::kBeyond;
    return;
  }
  step_ *= 0.5;
  if (step_ < kMinStep || !any_trial_) {
    step_ = static_cast<double>(Settings().refine.step);
    ResetDirections();
  }
  BeginSweep();
}

void Powell::JudgeBeyond(float fitness) {
  // Checks whether the direction of the largest gain has become too similar to the sweep's own direction
  // [Press 1992, section 10.5].
  const auto before = static_cast<double>(start_.fitness);
  const auto now = static_cast<double>(here_.fitness);
  const auto beyond = static_cast<double>(fitness);
  const double rest = now - before - gain_;
  const double replace =
      2.0 * (2.0 * now - before - beyond) * rest * rest - gain_ * (before - beyond) * (before - beyond);
  if (!(beyond > before) || !(replace < 0.0)) return BeginSweep();
  Direction way(here_.genome.size());
  float longest = 0.0f;
  for (std::size_t gene = 0; gene < way.size(); ++gene) {
    way[gene] = static_cast<float>(int{here_.genome[gene]} - int{start_.genome[gene]});
    longest = std::max(longest, std::abs(way[gene]));
  }
  for (float& component : way) component /= longest;
  directions_[gainer_] = std::move(directions_.back());
  axes_[gainer_] = axes_.back();
  directions_.back() = std::move(way);
  phase_ = Phase::kExtraLine;
  BeginLine(directions_.size() - 1);
}

void Powell::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  const float fitness = scores[0].fitness;
  switch (phase_) {
    case Phase::kFirst:
      here_ = {batch[0], fitness};
      BeginSweep();
      break;
    case Phase::kSweep:
    case Phase::kExtraLine:
      tried_.push_back({next_, fitness});
      if (fitness > best_.fitness) best_ = {batch[0], fitness};
      break;
    case Phase::kBeyond:
      JudgeBeyond(fitness);
      break;
  }
  Advance();
}

void Powell::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint64_t>(phase_), 2);
  out.Put(line_, 16);
  out.Put(gainer_, 16);
  out.Put(any_trial_ ? 1 : 0, 1);
  for (const double value : {step_, gain_, next_}) PutReal(out, value);
  for (const Individual* one : {&here_, &best_, &start_}) PutGenome(out, one->genome, one->fitness);
  out.Put(tried_.size(), 8);
  for (const Trial& trial : tried_) {
    PutReal(out, trial.at);
    out.Put(std::bit_cast<std::uint32_t>(trial.fitness), 32);
  }
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    out.Put(static_cast<std::uint64_t>(axes_[i]), 16);
    out.Put(directions_[i].empty() ? 0 : 1, 1);
    for (const float component : directions_[i]) out.Put(std::bit_cast<std::uint32_t>(component), 32);
  }
}

bool Powell::LoadState(BitReader& in) {
  const std::size_t genes = Space().shape.Genes();
  phase_ = static_cast<Phase>(in.Take(2));
  line_ = static_cast<std::size_t>(in.Take(16));
  gainer_ = static_cast<std::size_t>(in.Take(16));
  any_trial_ = in.Take(1) != 0;
  bool good = line_ < genes && gainer_ < genes;
  for (double* value : {&step_, &gain_, &next_}) {
    *value = std::bit_cast<double>(in.Take(64));  // a gain over an unscored start is infinite
    good = good && !std::isnan(*value);
  }
  good = good && step_ >= kMinStep && step_ <= 1.0 && std::abs(next_) <= 1.0;
  for (Individual* one : {&here_, &best_, &start_}) {
    good = TakeGenome(in, one->genome, one->fitness, genes) && good;
    good = good && one->genome.empty() == (phase_ == Phase::kFirst);
  }
  tried_.clear();
  const auto tried = in.Take(8);
  good = good && tried <= kMaxTrials + 1 && (tried > 0) == (phase_ != Phase::kFirst);
  for (std::uint64_t i = 0; good && i < tried; ++i) {
    Trial trial{};
    good = TakeReal(in, trial.at);
    trial.fitness = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
    good = good && trial.fitness < std::numeric_limits<float>::infinity();
    tried_.push_back(trial);
  }
  for (std::size_t i = 0; good && i < genes && !in.Overrun(); ++i) {
    axes_[i] = static_cast<int>(in.Take(16));
    directions_[i].assign(in.Take(1) != 0 ? genes : 0, 0.0f);
    good = std::cmp_less(axes_[i], genes);
    for (float& component : directions_[i]) {
      component = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
      good = good && std::abs(component) <= 1.0f;
    }
  }
  return good;
}

std::unique_ptr<Search> MakePowell(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<Powell>(settings, space);
}

}  // namespace gaitsmith
