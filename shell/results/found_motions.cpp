// SPDX-License-Identifier: MIT
// The list. Text encoding of entries is in found_text.cpp.
#include "shell/results/found_motions.h"

#include <algorithm>
#include <numeric>

#include "core/document/binary.h"
#include "shell/results/search_queue.h"
#include "shell/words/language.h"
#include "shell/words/motion_name.h"
#include "shell/words/search_words.h"

namespace gaitsmith::shell {

float FoundMotion::Score() const { return Moves() ? Fitness(document.task, terms) : kVoidScore; }

std::string FoundId(const Document& document) {
  // FNV-1a.
  std::uint64_t sum = 0xcbf29ce484222325u;
  Document bare = document;
  bare.view = {};
  bare.title.clear();
  for (Controller& controller : bare.controllers) controller.name.clear();
  for (const std::uint8_t byte : EncodeBinary(bare)) sum = (sum ^ byte) * 0x100000001b3u;
  return HashText(sum);
}

Document FoundDocument(const Document& searched, Genome genes) {
  Document found = SearchOf(searched);
  found.controllers.push_back(TakeFound(found, std::move(genes), found));
  const auto added = static_cast<int>(found.controllers.size()) - 1;
  found.controllers.back().name = MotionName(found, added);
  found.timeline = {{.controller = added, .start_step = 0}};
  found.title = FoundTitle(found.figure.name, found);
  return found;
}

FoundMotion Measured(Document document, Origin origin, int evaluations) {
  FoundMotion found{.origin = origin, .evaluations = evaluations};
  const Motion motion = Simulate(document);
  document.hash = motion.Hash();
  found.terms = motion.TermsAt(motion.Frames() - 1);
  document.view = {};
  found.document = std::move(document);
  return found;
}

std::string FoundMotions::Add(FoundMotion motion, const std::string& in_place_of) {
  Entry entry{FoundId(motion.document), std::move(motion), 0};
  if (const auto same = std::ranges::find(entries_, entry.id, &Entry::id); same != entries_.end()) {
    entry.motion.kept = entry.motion.kept || same->motion.kept;
    if (entry.motion.name.empty()) entry.motion.name = same->motion.name;
    entries_.erase(same);
  }
  if (const auto old = std::ranges::find(entries_, in_place_of, &Entry::id);
      old != entries_.end() && !old->motion.kept) {
    entries_.erase(old);
    if (on_change) on_change(in_place_of, "");
  }
  // New entries stay newest even if the machine's clock was set back.
  if (!entries_.empty()) entry.motion.when_s = std::max(entry.motion.when_s, entries_.back().motion.when_s);
  entry.bytes = EncodeFound(entry.motion).size();
  if (!MakeRoom(entry.bytes)) return {};
  entries_.push_back(std::move(entry));
  Notify(entries_.back());
  return entries_.back().id;
}

std::string FoundMotions::Restore(std::string_view text) {
  auto motion = DecodeFound(text);
  if (!motion) return {};
  Entry entry{FoundId(motion->document), std::move(*motion), text.size()};
  const std::string id = entry.id;
  if (Find(id) != nullptr) return id;
  const auto place = std::ranges::upper_bound(entries_, entry.motion.when_s, {},
                                              [](const Entry& one) { return one.motion.when_s; });
  entries_.insert(place, std::move(entry));
  MakeRoom(0);
  return id;
}

void FoundMotions::Remove(const std::string& id) {
  const auto entry = std::ranges::find(entries_, id, &Entry::id);
  if (entry == entries_.end()) return;
  removed_ = std::move(*entry);
  entries_.erase(entry);
  if (on_change) on_change(removed_->id, "");
}

bool FoundMotions::BringBack() {
  if (!removed_) return false;
  const Entry entry = *removed_;
  if (Find(entry.id) == nullptr) {
    if (!MakeRoom(entry.bytes)) return false;
    const auto place = std::ranges::upper_bound(entries_, entry.motion.when_s, {},
                                                [](const Entry& one) { return one.motion.when_s; });
    Notify(*entries_.insert(place, entry));
  }
  removed_.reset();
  return true;
}

bool FoundMotions::Keep(const std::string& id, bool kept) {
  const auto entry = std::ranges::find(entries_, id, &Entry::id);
  if (entry == entries_.end()) return false;
  if (entry->motion.kept == kept) return true;
  entry->motion.kept = kept;
  Notify(*entry);
  return true;
}

std::string FoundMotions::Rename(const std::string& id, const std::string& name) {
  const auto entry = std::ranges::find(entries_, id, &Entry::id);
  if (entry == entries_.end()) return Tr("That motion is no longer in the results.");
  if (entry->motion.name == name) return {};
  if (const auto good = CheckName(name); !good) return TrError(good.error());
  entry->motion.name = name;
  entry->bytes = EncodeFound(entry->motion).size();
  Notify(*entry);
  return {};
}

const FoundMotions::Entry* FoundMotions::Find(std::string_view id) const {
  const auto entry = std::ranges::find(entries_, id, &Entry::id);
  return entry == entries_.end() ? nullptr : &*entry;
}

namespace {

/// A motion's value of the quantity that an order sorts by.
float Amount(FoundMotions::Order order, const FoundMotion& motion) {
  if (!motion.Moves() || motion.terms.broke_physics) return kVoidScore;
  switch (order) {
    case FoundMotions::Order::kNewest:
      return 0.0f;
    case FoundMotions::Order::kBest:
      return motion.Score();
    case FoundMotions::Order::kHighest:
      return motion.terms.max_cm_height_m;
    case FoundMotions::Order::kMaxTurns:
      return motion.terms.rotations;
    case FoundMotions::Order::kMinSlip:
      return -motion.terms.slip_sum_m;
  }
  return 0.0f;
}

}  // namespace

std::vector<const FoundMotions::Entry*> FoundMotions::Sorted(Order order) const {
  std::vector<const Entry*> sorted;
  sorted.reserve(entries_.size());
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) sorted.push_back(&*entry);
  if (order == Order::kNewest) return sorted;
  // Equal motions are sorted newest first: entries_ holds the newest last.
  std::ranges::sort(sorted, std::ranges::greater{},
                    [order](const Entry* entry) { return std::pair(Amount(order, entry->motion), entry); });
  return sorted;
}

const FoundMotions::Entry* FoundMotions::Best(const Document& like) const {
  const Entry* best = nullptr;
  bool best_alike = false;
  for (const Entry* entry : Sorted(Order::kBest)) {
    const Document& d = entry->motion.document;
    const bool alike = d.figure.name == like.figure.name && d.task.kind == like.task.kind;
    if (!entry->motion.Moves() || (best != nullptr && (best_alike || !alike))) continue;
    best = entry;
    best_alike = alike;
  }
  return best;
}

bool FoundMotions::MakeRoom(std::size_t bytes) {
  const std::size_t more = bytes > 0 ? 1 : 0;
  std::size_t motions = more, size = bytes;
  for (const Entry& entry : entries_) {
    motions += entry.motion.kept ? 1 : 0;
    size += entry.motion.kept ? entry.bytes : 0;
  }
  if (motions > limits_.motions || size > limits_.bytes) return false;
  size = std::accumulate(entries_.begin(), entries_.end(), bytes,
                         [](std::size_t sum, const Entry& entry) { return sum + entry.bytes; });
  while (entries_.size() + more > limits_.motions || size > limits_.bytes) {
    const auto oldest = std::ranges::find(entries_, false, [](const Entry& one) { return one.motion.kept; });
    const std::string id = oldest->id;
    size -= oldest->bytes;
    entries_.erase(oldest);
    if (on_change) on_change(id, "");
  }
  return true;
}

void FoundMotions::Notify(const Entry& entry) const {
  if (on_change) on_change(entry.id, EncodeFound(entry.motion));
}

}  // namespace gaitsmith::shell
