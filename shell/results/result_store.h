// SPDX-License-Identifier: MIT
// The results: motions added when searches end, or saved by hand from the open document.
#pragma once

#include <optional>
#include <string>

#include "shell/results/found_motions.h"
#include "shell/search/search_progress.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class ResultStore {
 public:
  /// Passes each change to the host for storage.
  explicit ResultStore(Workspace&);

  [[nodiscard]] FoundMotions& Motions() { return motions_; }
  [[nodiscard]] const FoundMotions& Motions() const { return motions_; }

  /// Saves the shown motion to the results. Refused, with a sentence, if there is no motion or no room.
  bool KeepShown();
  /// Whether a found motion is the open document's motion.
  [[nodiscard]] bool IsShown(const FoundMotions::Entry&) const;
  /// Adds the result of a search when the search ends.
  /// @param in_place_of  the earlier result of the same search, or empty
  /// @return its id, empty if there is no room; nothing if there is no result to add
  std::optional<std::string> AddFound(const Document& searched, const SearchProgress& at_end,
                                      const std::string& in_place_of);

  /// Whether AskName can be answered.
  [[nodiscard]] bool CanAskName() const { return workspace_.TheHost().CanAskName(); }
  /// Asks the person for the name of a found motion.
  void AskName(const std::string& id) const;
  /// Whether the host learns what the person likes.
  [[nodiscard]] bool CanLearn() const { return workspace_.TheHost().CanLearn(); }
  /// The person wants more, or less, like a found motion.
  void LearnFrom(const std::string& id, bool more) const { workspace_.TheHost().LearnFrom(id, more); }

 private:
  Workspace& workspace_;
  FoundMotions motions_;
};

}  // namespace gaitsmith::shell
