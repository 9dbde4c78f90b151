// SPDX-License-Identifier: MIT
// Motions that searches have found or a person has saved, each as a document with its measured
// values. The list is bounded: when it is full, the oldest unsaved motions are removed first. It does not
// store anything itself, but reports which entries have changed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

enum class Origin { kDone, kStopped, kFailed, kByHand };  // how the search ended; kByHand: saved as shown

/// "done", "stopped", "failed", "by-hand"
[[nodiscard]] std::string_view NameOf(Origin);

struct FoundMotion {
  Document document = {};  // with its trajectory's hash; no controller if the search found nothing
  Origin origin = Origin::kDone;
  int evaluations = 0;    // made by the search; 0: saved by hand
  Terms terms = {};       // of the whole motion
  double when_s = 0.0;    // since 1970, on this machine's clock
  bool kept = false;      // saved by a person: never removed to make room
  std::string name = {};  // given by a person, at most kMaxNameBytes; may be empty

  [[nodiscard]] bool Moves() const { return !document.timeline.empty(); }
  /// Whether its search can be run again. One that started from a motion and changed the body began with a
  /// body that no document has.
  [[nodiscard]] bool CanRepeat() const {
    return origin != Origin::kByHand &&
           (document.search.start < 0 || document.search.body == BodyFreedom::kNone);
  }
  /// kVoidScore if there is no motion.
  [[nodiscard]] float Score() const;
};

/// An id computed from the document alone, names excluded: the same motion of the same search has the same id
/// wherever and whenever it is found. 16 hexadecimal digits.
[[nodiscard]] std::string FoundId(const Document&);

/// A document with a single controller, as a search found it, with the problem, settings, title and hash.
/// @param searched valid. @param genes of its controllers
[[nodiscard]] Document FoundDocument(const Document& searched, Genome genes);
/// Simulates the document once to measure it.
[[nodiscard]] FoundMotion Measured(Document document, Origin origin, int evaluations);

class FoundMotions {
 public:
  struct Limits {
    std::size_t motions = 100;
    std::size_t bytes = 200'000;  // all entries as text
  };
  struct Entry {
    std::string id;
    FoundMotion motion;
    std::size_t bytes;
  };
  enum class Order { kNewest, kBest, kHighest, kMaxTurns, kMinSlip };

  FoundMotions() = default;
  explicit FoundMotions(const Limits& limits) : limits_(limits) {}

  /// Called with the text of every new or changed entry, and with an empty text for every removed entry.
  std::function<void(const std::string& id, const std::string& text)> on_change;

  /// Adds a motion as the newest. An equal entry is replaced, and stays saved if it was.
  /// @param in_place_of  an entry that the new one replaces, unless it is saved
  /// @return its id; empty if saved entries leave no room, and then nothing has changed
  std::string Add(FoundMotion motion, const std::string& in_place_of = "");
  /// Adds a stored entry under its own time. Calls on_change only if there is no room for it. @return its id;
  /// empty: the text is not a valid entry
  std::string Restore(std::string_view text);
  void Remove(const std::string& id);
  /// Restores the entry that Remove removed last. @return false: no such entry, or no room
  bool BringBack();
  [[nodiscard]] const Entry* Removed() const { return removed_ ? &*removed_ : nullptr; }
  /// @return false: there is no such entry
  bool Keep(const std::string& id, bool kept);

  [[nodiscard]] bool Empty() const { return entries_.empty(); }
  [[nodiscard]] std::size_t Count() const { return entries_.size(); }
  [[nodiscard]] const Entry* Find(std::string_view id) const;
  /// Gives an entry a name; an empty name removes it. @return the error; empty on success
  [[nodiscard]] std::string Rename(const std::string& id, const std::string& name);
  /// Entries with the greatest value of the order first. Of equal entries the newer comes first.
  [[nodiscard]] std::vector<const Entry*> Sorted(Order) const;
  /// The best motion with this document's figure and task. If there is none, the best of all motions. Null if
  /// the list holds no motion.
  [[nodiscard]] const Entry* Best(const Document& like) const;

 private:
  /// Removes the oldest entries until `bytes` more fit; 0 only enforces the limits. @return false: saved
  /// entries leave no room, and nothing was removed
  bool MakeRoom(std::size_t bytes);
  void Notify(const Entry&) const;

  Limits limits_;
  std::vector<Entry> entries_;  // by time, oldest first
  std::optional<Entry> removed_;
};

/// An entry as JSON: {"link", "origin", "evaluations", "when", "kept", "terms"}, and "name" if it has one.
/// Decoding restores the same bits.
[[nodiscard]] std::string EncodeFound(const FoundMotion&);
[[nodiscard]] Result<FoundMotion> DecodeFound(std::string_view text);

}  // namespace gaitsmith::shell
