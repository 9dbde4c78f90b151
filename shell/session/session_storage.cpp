// SPDX-License-Identifier: MIT
// What a session stores for a reload of its tab.
#include <utility>
#include <vector>

#include "core/document/binary.h"
#include "core/document/json_value.h"
#include "core/document/link.h"
#include "shell/session/session.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"

namespace gaitsmith::shell {
namespace {

// Most letters of the steps. Browsers give a page about five million for everything that a tab stores.
constexpr std::size_t kMaxLetters = 1'000'000;

std::string ListJson(const std::vector<std::string>& payloads) {
  std::string json = "[";
  for (const std::string& payload : payloads) json += (json.size() > 1 ? "," : "") + QuoteJson(payload);
  return json + "]";
}

// @return false: there is no such list of texts
bool Read(const JsonValue& object, std::string_view name, std::vector<std::string>& payloads) {
  const JsonValue* list = object.Find(name);
  if (list == nullptr || list->kind != JsonValue::Kind::kArray) return false;
  for (const JsonValue& item : list->items) {
    if (item.kind != JsonValue::Kind::kString) return false;
    payloads.push_back(item.text);
  }
  return true;
}

}  // namespace

std::string Session::StoreVisit() const {
  const History::Stored steps = workspace_.Past().Store(kMaxLetters);
  std::vector<std::string> queue;
  if (search_.RunsQueued()) queue.push_back(ToBase64Url(EncodeBinary(*search_.Searched())));
  for (const SearchQueue::Entry& entry : queue_.List().Waiting())
    queue.push_back(ToBase64Url(EncodeBinary(entry.document)));
  return R"({"undo":)" + ListJson(steps.past) + R"(,"redo":)" + ListJson(steps.future) + R"(,"queue":)" +
         ListJson(queue) + R"(,"simple":)" + (simple_ ? "true" : "false") +
         (live_.Chosen() ? std::string(R"(,"live":)") + (*live_.Chosen() ? "true" : "false") : "") + "}";
}

std::string Session::RestoreFound(std::string_view text) {
  std::string id = results_.Motions().Restore(text);
  if (const FoundMotions::Entry* entry = results_.Motions().Find(id); entry != nullptr)
    provenance_.AddOpened(entry->motion.document);
  return id;
}

bool Session::RestoreVisit(std::string_view text) {
  const auto json = ParseJson(text);
  History::Stored steps;
  std::vector<std::string> payloads;
  if (!json || !Read(*json, "undo", steps.past) || !Read(*json, "redo", steps.future) ||
      !Read(*json, "queue", payloads))
    return false;
  const JsonValue* simple = json->Find("simple");
  if (simple == nullptr || simple->kind != JsonValue::Kind::kBool) return false;
  const JsonValue* live = json->Find("live");
  if (live != nullptr && live->kind != JsonValue::Kind::kBool) return false;
  std::vector<Document> searches;
  for (const std::string& payload : payloads) {
    auto search = DecodeLink(payload);
    if (!search) return false;
    searches.push_back(std::move(*search));
  }
  if (!workspace_.Past().Restore(steps)) return false;
  for (const auto* side : {&steps.past, &steps.future}) {
    for (const std::string& payload : *side)
      if (const auto document = DecodeLink(payload)) provenance_.AddOpened(*document);
  }
  simple_ = simple->boolean;
  if (live != nullptr) live_.Switch(live->boolean);
  queue_.List().Restore(searches);
  workspace_.Redraw();
  const std::size_t waiting = queue_.List().Waiting().size();
  if (waiting > 0) workspace_.Report(Tr("{1} until you press Run queue.", WaitingWords(waiting)));
  return true;
}

}  // namespace gaitsmith::shell
