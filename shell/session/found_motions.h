// SPDX-License-Identifier: MIT
// Motions that searches have found and a person has kept: each a document of its own, with what is known of
// it. Bounded; where room is short the oldest ones that nobody has kept go. What is stored of them, and
// where, is not its concern: it says which entries have changed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

enum class Origin {
  kDone,
  kStopped,
  kFailed,
  kByHand
};  // of a search that ended so; or kept as it was shown

/// "done", "stopped", "failed", "by-hand"
[[nodiscard]] std::string_view NameOf(Origin);

struct FoundMotion {
  Document document =
      {};  // with its trajectory's hash; without a controller: a search that failed with nothing
  Origin origin = Origin::kDone;
  int evaluations = 0;    // that the search had made; 0: kept by hand
  Terms terms = {};       // of the whole motion
  double when_s = 0.0;    // since 1970, on this machine's clock
  bool kept = false;      // a person wants it to stay
  std::string name = {};  // that a person gave it, at most kMaxNameBytes; empty: none

  [[nodiscard]] bool Moves() const { return !document.timeline.empty(); }
  /// kVoidScore where nothing moves.
  [[nodiscard]] float Score() const;
};

/// An id that follows from the document alone, whatever the names in it, so that the same motion of the same
/// search has it wherever and whenever it is found: 16 hexadecimal digits.
[[nodiscard]] std::string FoundId(const Document&);

/// A document of one controller, alone from the start, as a search has found it: its own problem and settings
/// with it, its title and its hash.
/// @param searched valid. @param genes of its controllers
[[nodiscard]] Document FoundDocument(const Document& searched, Genome genes);
/// What is known of it by looking at it: simulates it once.
[[nodiscard]] FoundMotion Measured(Document document, Origin origin, int evaluations);

class FoundMotions {
 public:
  struct Limits {
    std::size_t motions = 100;
    std::size_t bytes = 200'000;  // as text
  };
  struct Entry {
    std::string id;
    FoundMotion motion;
    std::size_t bytes;
  };
  enum class Order { kNewest, kBest, kHighest, kMostTurns, kLeastSlip };

  FoundMotions() = default;
  explicit FoundMotions(const Limits& limits) : limits_(limits) {}

  /// Told of every entry that is new or has changed, with its text, and with an empty text of every one that
  /// went.
  std::function<void(const std::string& id, const std::string& text)> on_change;

  /// The newest from now on. One that is there already is replaced, and stays kept if it was.
  /// @param in_place_of  an entry that this one makes superfluous, unless it is kept
  /// @return its id; empty: what is kept leaves no room for it, and all is as it was
  std::string Add(FoundMotion motion, const std::string& in_place_of = "");
  /// What was stored before, under its own time. Tells nobody, unless it has no room. @return its
  /// id; empty: not of ours
  std::string Restore(std::string_view text);
  void Remove(const std::string& id);
  /// The entry that Remove took away last comes back. @return false: there is none, or no room
  bool BringBack();
  [[nodiscard]] const Entry* Removed() const { return removed_ ? &*removed_ : nullptr; }
  /// @return false: there is no such entry
  bool Keep(const std::string& id, bool kept);

  [[nodiscard]] bool Empty() const { return entries_.empty(); }
  [[nodiscard]] std::size_t Count() const { return entries_.size(); }
  [[nodiscard]] const Entry* Find(std::string_view id) const;
  /// A name is given, or taken away where it is empty. @return why not; empty: it is done
  [[nodiscard]] std::string Rename(const std::string& id, const std::string& name);
  /// Those first that have most of what the order says; equals: the newer first.
  [[nodiscard]] std::vector<const Entry*> Sorted(Order) const;
  /// The best of those with this document's figure and task; of all when there is none. Null: nothing moves.
  [[nodiscard]] const Entry* Best(const Document& like) const;

 private:
  /// Lets old ones go until another of so many bytes fits (0: until these do). @return false: what is kept
  /// leaves no room, and nothing has gone
  bool MakeRoom(std::size_t bytes);
  void Tell(const Entry&) const;

  Limits limits_;
  std::vector<Entry> entries_;  // by time, the oldest first
  std::optional<Entry> removed_;
};

/// An entry as JSON: {"link", "origin", "evaluations", "when", "kept", "terms"}, and "name" where it has one.
/// Reading it gives the same bits.
[[nodiscard]] std::string EncodeFound(const FoundMotion&);
[[nodiscard]] Result<FoundMotion> DecodeFound(std::string_view text);

}  // namespace gaitsmith::shell
