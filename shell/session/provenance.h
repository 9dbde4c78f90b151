// SPDX-License-Identifier: MIT
// Where the controllers of the open document come from: from what was opened, or from a search or breeding
// here. Goals of lessons ask for it (docs/embedding.md). It is asked of a document and not kept with it, so
// Undo needs no care. A reload forgets it: then everything counts as opened.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// Where a search comes from that found a controller.
enum class FoundBy { kPerson, kScript };

class Provenance {
 public:
  /// A document from outside, such as a link, a file or an example. What a script finds counts the same.
  void AddOpened(const Document&);
  /// A controller that a search shows. A search of a person's that starts from a motion continues it: what
  /// it finds is as new as its start.
  void AddFound(const Document& searched, const Controller& found, FoundBy by);
  /// A recording is new if the motion was, else it counts as opened.
  void AddRecorded(const Document& before, const Document& recorded);

  /// "opened": every rule or knot in the timeline's controllers was opened, and some may have been deleted.
  /// "new": none was opened. "changed": anything between. Empty: there is no motion.
  [[nodiscard]] std::string_view Of(const Document&) const;
  /// The seed that found the only controller of the timeline here, or that of the document's search.
  [[nodiscard]] std::uint32_t SeedOf(const Document&) const;
  /// Generations that were bred here, in the line of the shown round.
  [[nodiscard]] int GenerationsOf(const Document&) const;

 private:
  using Key = std::uint64_t;

  std::set<Key> opened_rules_;  // with the controller's senses: what they do
  std::set<Key> opened_genes_;  // of rules, without the senses
  std::vector<Lineage> opened_families_;
  std::map<Key, std::uint32_t> found_;  // seeds of new controllers
  std::set<Key> continued_;             // controllers of searches that started from something opened
};

}  // namespace gaitsmith::shell
