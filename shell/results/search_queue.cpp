// SPDX-License-Identifier: MIT
#include "shell/results/search_queue.h"

#include <algorithm>
#include <utility>

#include "core/document/parts.h"

namespace gaitsmith::shell {

namespace {

// Parts that do not affect a search, and parts that SearchOf recreates.
constexpr Parts kOutsideSearch = {Part::kTitle,    Part::kSearchStart, Part::kTakeover,
                                  Part::kTimeline, Part::kControllers, Part::kDuration,
                                  Part::kView,     Part::kHash,        Part::kPlan};

}  // namespace

Document SearchOf(const Document& document) {
  Document search;
  CopyParts(document, AllParts().Without(kOutsideSearch), search);
  if (document.search.start >= 0) {
    Controller start = document.controllers[static_cast<std::size_t>(document.search.start)];
    start.name.clear();
    search.controllers.push_back(std::move(start));
    search.search.start = 0;
  }
  // A family belongs to one body.
  if (search.search.body != BodyFreedom::kNone) search.lineage = {};
  // Without a controller to start from, nothing of what was found before counts, the body included.
  if (search.search.body != BodyFreedom::kNone && search.search.start < 0) {
    search.figure = AsDrawn(search);
    search.drawn.clear();
  }
  search.duration_steps = search.task.duration_steps;
  return search;
}

bool SameSearch(const Document& a, const Document& b) {
  return DifferingParts(SearchOf(a), SearchOf(b)).Empty();
}

bool SearchQueue::Add(const Document& document) {
  if (Full()) return false;
  removed_.clear();
  waiting_.push_back({++numbers_, SearchOf(document)});
  Notify();
  return true;
}

void SearchQueue::Restore(std::span<const Document> searches) {
  removed_.clear();
  for (const Document& search : searches) {
    if (waiting_.size() > kMax) break;
    waiting_.push_back({++numbers_, SearchOf(search)});
  }
  Notify();
}

void SearchQueue::Remove(int number) {
  const auto entry = std::ranges::find(waiting_, number, &Entry::number);
  if (entry == waiting_.end()) return;
  removed_.clear();
  removed_.push_back({static_cast<std::size_t>(entry - waiting_.begin()), std::move(*entry)});
  waiting_.erase(entry);
  Notify();
}

void SearchQueue::MoveUp(int number) {
  const auto entry = std::ranges::find(waiting_, number, &Entry::number);
  if (entry == waiting_.end() || entry == waiting_.begin()) return;
  std::iter_swap(entry, entry - 1);
  Notify();
}

void SearchQueue::Clear() {
  if (waiting_.empty()) return;
  removed_.clear();
  for (std::size_t place = 0; place < waiting_.size(); ++place)
    removed_.push_back({place, std::move(waiting_[place])});
  waiting_.clear();
  Notify();
}

void SearchQueue::BringBack() {
  for (Gone& gone : std::exchange(removed_, {})) {
    if (Full()) break;
    const std::size_t place = std::min(gone.place, waiting_.size());
    waiting_.insert(waiting_.begin() + static_cast<std::ptrdiff_t>(place), std::move(gone.entry));
  }
  Notify();
}

std::optional<Document> SearchQueue::TakeFirst() {
  if (waiting_.empty()) return std::nullopt;
  Document first = std::move(waiting_.front().document);
  waiting_.erase(waiting_.begin());
  Notify();
  return first;
}

std::vector<std::uint32_t> FreeSeeds(const Document& document, std::span<const Document> others, int count) {
  Document wanted = SearchOf(document);
  std::vector<std::uint32_t> taken;
  for (const Document& other : others) {
    wanted.search.seed = other.search.seed;
    if (SameSearch(wanted, other)) taken.push_back(other.search.seed);
  }
  std::vector<std::uint32_t> seeds;
  for (std::uint32_t seed = document.search.seed; std::cmp_less(seeds.size(), count); ++seed) {
    if (std::ranges::find(taken, seed) == taken.end()) seeds.push_back(seed);
    if (seed == 0xffffffffu) break;
  }
  return seeds;
}

}  // namespace gaitsmith::shell
