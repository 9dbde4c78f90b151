// SPDX-License-Identifier: MIT
// Batches cut into pieces for threads that stay alive during the whole search.
#include "shell/search/parallel_search.h"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <thread>

#include "core/numeric/bit_stream.h"
#include "core/search/evaluation_score.h"

namespace gaitsmith::shell {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Crew {
 public:
  /// @param scorer must outlive the crew
  Crew(const Scorer& scorer, int threads) : scorer_(scorer), start_(threads), finish_(threads) {
    // The calling thread is one of the threads.
    for (int i = 1; i < threads; ++i) {
      helpers_.emplace_back([this] {
        for (;;) {
          start_.arrive_and_wait();
          if (leaving_) return;
          TakePieces();
          finish_.arrive_and_wait();
        }
      });
    }
  }
  ~Crew() {
    leaving_ = true;
    start_.arrive_and_wait();
  }
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  const std::vector<Score>& Evaluate(const std::vector<Genome>& genomes) {
    if (genomes.size() <= kPiece) return scores_ = scorer_.ScoresOf(genomes);
    genomes_ = &genomes;
    scores_.assign(genomes.size(), {.fitness = kVoidScore});
    next_ = 0;
    start_.arrive_and_wait();
    TakePieces();
    finish_.arrive_and_wait();
    return scores_;
  }

 private:
  static constexpr std::size_t kPiece = Evaluator::kDefaultLanes;  // genomes that are simulated side by side

  // Evaluates pieces of the batch until none is left.
  void TakePieces() {
    for (std::size_t at = next_.fetch_add(kPiece); at < genomes_->size(); at = next_.fetch_add(kPiece)) {
      const std::size_t count = std::min(kPiece, genomes_->size() - at);
      const auto results = scorer_.ForPieces().Evaluate(std::span(*genomes_).subspan(at, count));
      for (std::size_t i = 0; i < count; ++i) scores_[at + i] = ScoreOf(results[i]);
    }
  }

  const Scorer& scorer_;
  std::barrier<> start_, finish_;
  std::atomic<std::size_t> next_ = 0;
  const std::vector<Genome>* genomes_ = nullptr;
  std::vector<Score> scores_;
  bool leaving_ = false;  // written before start_ is passed
  std::vector<std::jthread>
      helpers_;  // last, so that the threads are joined before the members they use are destroyed
};

}  // namespace

void SearchControl::Pause(bool paused) {
  const std::lock_guard lock(mutex_);
  paused_ = paused;
  changed_.notify_all();
}

void SearchControl::Cancel() {
  const std::lock_guard lock(mutex_);
  cancelled_ = true;
  changed_.notify_all();
}

bool SearchControl::Cancelled() const {
  const std::lock_guard lock(mutex_);
  return cancelled_;
}

bool SearchControl::Paused() const {
  const std::lock_guard lock(mutex_);
  return paused_;
}

bool SearchControl::Proceed() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !paused_ || cancelled_; });
  return !cancelled_;
}

int Cores() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

SearchProgress RunParallelSearch(const Problem& problem, const SearchSettings& settings, int threads,
                                 SearchControl& control,
                                 const std::function<void(const SearchProgress&)>& report,
                                 const Genome& start) {
  const Scorer scorer(problem);
  const auto search = MakeSearch(settings, scorer.Space(start));
  return RunToEnd(scorer, *search, settings.evaluations, threads, control, report);
}

SearchProgress RunToEnd(const Scorer& scorer, Search& search, int budget, int threads, SearchControl& control,
                        const std::function<void(const SearchProgress&)>& report) {
  Crew crew(scorer, threads);
  SearchProgress progress{.state = SearchState::kRunning, .budget = budget, .workers = threads};
  double working_s = 0.0;
  auto last_report = Clock::now() - std::chrono::seconds(1);

  const auto update = [&] {
    progress.evaluations = search.Evaluations();
    progress.evaluations_per_second = working_s > 0.0 ? progress.evaluations / working_s : 0.0;
    progress.seconds_left = progress.evaluations_per_second > 0.0
                                ? (progress.budget - progress.evaluations) / progress.evaluations_per_second
                                : 0.0;
    progress.best_fitness = search.BestFitness();
    progress.best_genome = search.BestGenome();
    progress.curve = search.Curve();
    progress.spread = SpreadOf(search.PopulationFitness());
  };

  // Five rounds of lanes for each thread: enough work for all, and little waste when a climb improves.
  const int wanted = threads * Evaluator::kDefaultLanes * 5;
  while (!search.Done()) {
    if (control.Paused() && !control.Cancelled()) {
      progress.state = SearchState::kPaused;
      update();
      report(progress);
    }
    if (!control.Proceed()) break;
    progress.state = SearchState::kRunning;

    const auto batch_start = Clock::now();
    const std::vector<Genome> genomes = search.Ask(wanted);
    if (genomes.empty()) break;
    search.Tell(crew.Evaluate(genomes));
    working_s += SecondsSince(batch_start);
    if (SecondsSince(last_report) < 1.0 / 30.0) continue;
    last_report = Clock::now();
    update();
    progress.attempt = genomes.front();
    report(progress);
  }
  progress.attempt.clear();
  progress.state = search.Done() ? SearchState::kDone : SearchState::kStopped;
  update();
  BitWriter state;
  search.Save(state);
  progress.saved = state.Bytes();
  report(progress);
  return progress;
}

}  // namespace gaitsmith::shell
