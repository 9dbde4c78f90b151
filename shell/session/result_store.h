// SPDX-License-Identifier: MIT
// The results: found motions, noted as searches end, or kept by hand from what is open.
#pragma once

#include <optional>
#include <string>

#include "shell/search/search_progress.h"
#include "shell/session/found_motions.h"
#include "shell/session/workspace.h"

namespace gaitsmith::shell {

class ResultStore {
 public:
  /// The host stores what changes.
  explicit ResultStore(Workspace&);

  [[nodiscard]] FoundMotions& Motions() { return motions_; }
  [[nodiscard]] const FoundMotions& Motions() const { return motions_; }

  /// Keeps the shown motion. Refused, with a sentence: there is none, or no room.
  bool KeepShown();
  /// Whether a found motion is what is open now.
  [[nodiscard]] bool IsShown(const FoundMotions::Entry&) const;
  /// Notes what a search has found when it ends.
  /// @param in_place_of  what was noted of the same search before, or empty
  /// @return its id, empty where there is no room; nothing: there is nothing to note
  std::optional<std::string> AddFound(const Document& searched, const SearchProgress& at_end,
                                      const std::string& in_place_of);

  /// Whether AskName can be answered.
  [[nodiscard]] bool CanAskName() const { return workspace_.TheHost().CanAskName(); }
  /// The person is asked for the name of a found motion.
  void AskName(const std::string& id) const;

 private:
  Workspace& workspace_;
  FoundMotions motions_;
};

}  // namespace gaitsmith::shell
