// SPDX-License-Identifier: MIT
#include "shell/script_answers.h"

#include <cstdio>

#include "core/document/json_value.h"
#include "core/document/link.h"
#include "shell/search_words.h"

namespace gaitsmith::shell {
namespace {

std::string Exact(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string SearchMembers(const SearchSettings& search, int evaluations) {
  return ",\"algorithm\":" + QuoteJson(kAlgorithmNames[static_cast<std::size_t>(search.algorithm)]) +
         ",\"seed\":" + std::to_string(search.seed) + ",\"evaluations\":" + std::to_string(evaluations);
}

}  // namespace

std::string QueueJson(const SearchQueue& queue) {
  std::string json = "[";
  for (const SearchQueue::Entry& entry : queue.Waiting()) {
    if (json.size() > 1) json += ",\n";
    const SearchSettings& search = entry.document.search;
    json += "{\"title\":" + QuoteJson(SearchName(entry.document)) +
            SearchMembers(search, search.evaluations) + "}";
  }
  return json + "]";
}

std::string FoundJson(const FoundMotions& found) {
  std::string json = "[";
  for (const FoundMotions::Entry* entry : found.Sorted(FoundMotions::Order::kNewest)) {
    if (json.size() > 1) json += ",\n";
    const FoundMotion& motion = entry->motion;
    const bool scored = motion.Score() > kVoidScore;
    json += "{\"id\":" + QuoteJson(entry->id) + ",\"title\":" + QuoteJson(motion.document.title) +
            (motion.name.empty() ? "" : ",\"name\":" + QuoteJson(motion.name)) +
            ",\"origin\":" + QuoteJson(NameOf(motion.origin)) +
            ",\"score\":" + (scored ? Exact(static_cast<double>(motion.Score()), 9) : "null") +
            SearchMembers(motion.document.search, motion.evaluations) +
            ",\"kept\":" + (motion.kept ? "true" : "false") + ",\"when\":" + Exact(motion.when_s, 15) +
            ",\"hash\":" + QuoteJson(motion.document.hash ? HashText(*motion.document.hash) : "") +
            ",\"link\":" + QuoteJson(EncodeLink(motion.document)) + "}";
  }
  return json + "]";
}

}  // namespace gaitsmith::shell
