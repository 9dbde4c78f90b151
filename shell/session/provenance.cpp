// SPDX-License-Identifier: MIT
#include "shell/session/provenance.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>

#include "core/rollout/models.h"

namespace gaitsmith::shell {
namespace {

/// FNV-1a of the parts of a controller.
class Hash {
 public:
  Hash& Add(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte, value >>= 8) key_ = (key_ ^ (value & 0xff)) * 0x100000001b3ull;
    return *this;
  }
  Hash& Add(float value) { return Add(std::uint64_t{std::bit_cast<std::uint32_t>(value)}); }
  Hash& Add(std::span<const Gene> genes) {
    for (const Gene gene : genes) Add(std::uint64_t{gene});
    return *this;
  }
  [[nodiscard]] std::uint64_t Key() const { return key_; }

 private:
  std::uint64_t key_ = 0xcbf29ce484222325ull;
};

Hash OfSenses(const Controller& controller) {
  const SenseSpec& senses = controller.senses;
  Hash hash;
  hash.Add(static_cast<std::uint64_t>(controller.kind)).Add(static_cast<std::uint64_t>(senses.kind));
  if (senses.kind == SenseKind::kTimer) hash.Add(static_cast<std::uint64_t>(senses.period_steps));
  if (senses.kind == SenseKind::kSight)
    hash.Add(senses.sight_rods).Add(static_cast<std::uint64_t>(senses.facing));
  if (controller.kind == ControllerKind::kTrajectory) hash.Add(static_cast<std::uint64_t>(senses.at_end));
  return hash.Add(senses.tau_min_s)
      .Add(senses.tau_max_s)
      .Add(senses.force_weights)
      .Add(senses.height_rods)
      .Add(senses.velocity_mps);
}

std::uint64_t KeyOf(const Controller& controller) { return OfSenses(controller).Add(controller.genes).Key(); }

/// The genes of each rule or knot. A network is one part, because its nodes mean nothing alone.
std::vector<std::span<const Gene>> PartsOf(const Document& document, const Controller& controller) {
  const std::span<const Gene> genes = controller.genes;
  if (controller.kind == ControllerKind::kNetwork) return {genes};
  const ControllerShape shape = controller.Shape(CountPorts(document.model, document.figure));
  std::vector<std::span<const Gene>> parts;
  parts.reserve(static_cast<std::size_t>(controller.rules));
  for (int rule = 0; rule < controller.rules; ++rule)
    parts.push_back(genes.subspan(shape.Begin(rule), shape.Begin(rule + 1) - shape.Begin(rule)));
  return parts;
}

/// Whether a family is another one with more rounds, or the same.
bool Continues(const Lineage& family, const Lineage& other) {
  return other.rounds.size() <= family.rounds.size() &&
         std::ranges::equal(family.founders, other.founders, {}, KeyOf, KeyOf) &&
         std::equal(other.rounds.begin(), other.rounds.end(), family.rounds.begin(),
                    [](const BreedRound& a, const BreedRound& b) {
                      return a.parent == b.parent && a.picks == b.picks && a.seed == b.seed;
                    });
}

}  // namespace

void Provenance::AddOpened(const Document& document) {
  for (const Controller& controller : document.controllers) {
    for (const std::span<const Gene> part : PartsOf(document, controller)) {
      opened_rules_.insert(OfSenses(controller).Add(part).Key());
      opened_genes_.insert(Hash().Add(part).Key());
    }
  }
  if (!document.lineage.rounds.empty()) opened_families_.push_back(document.lineage);
}

void Provenance::AddFound(const Document& searched, const Controller& found, FoundBy by) {
  Document alone = searched;
  alone.controllers = {found};
  alone.timeline = {{.controller = 0, .start_step = 0}};
  if (by == FoundBy::kScript) {
    alone.lineage = {};
    return AddOpened(alone);
  }
  const SearchSettings& search = searched.search;
  bool anew = search.start < 0 && search.in_place_of < 0;
  if (!anew && search.start >= 0) {
    alone.controllers = {searched.controllers[static_cast<std::size_t>(search.start)]};
    anew = Of(alone) == "new";
  }
  if (anew) {
    found_[KeyOf(found)] = search.seed;
  } else {
    continued_.insert(KeyOf(found));
  }
}

void Provenance::AddRecorded(const Document& before, const Document& recorded) {
  if (Of(before) != "new") AddOpened(recorded);
}

std::string_view Provenance::Of(const Document& document) const {
  bool opened = true, anew = true;
  for (const Clip& clip : document.timeline) {
    const Controller& controller = document.controllers[static_cast<std::size_t>(clip.controller)];
    if (found_.contains(KeyOf(controller))) {
      opened = false;
      continue;
    }
    anew = anew && !continued_.contains(KeyOf(controller));
    for (const std::span<const Gene> part : PartsOf(document, controller)) {
      opened = opened && opened_rules_.contains(OfSenses(controller).Add(part).Key());
      anew = anew && !opened_genes_.contains(Hash().Add(part).Key());
    }
  }
  return document.timeline.empty() ? "" : opened ? "opened" : anew ? "new" : "changed";
}

std::uint32_t Provenance::SeedOf(const Document& document) const {
  if (document.timeline.size() != 1) return document.search.seed;
  const auto index = static_cast<std::size_t>(document.timeline[0].controller);
  const auto found = found_.find(KeyOf(document.controllers[index]));
  return found == found_.end() ? document.search.seed : found->second;
}

int Provenance::GenerationsOf(const Document& document) const {
  const Lineage& family = document.lineage;
  std::size_t opened = 0;
  for (const Lineage& other : opened_families_)
    if (Continues(family, other)) opened = std::max(opened, other.rounds.size());
  int generations = 0;
  for (int round = family.rounds.empty() ? -1 : family.shown; round >= 0;
       round = family.rounds[static_cast<std::size_t>(round)].parent)
    generations += static_cast<std::size_t>(round) >= opened ? 1 : 0;
  return generations;
}

}  // namespace gaitsmith::shell
