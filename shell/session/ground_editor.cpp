// SPDX-License-Identifier: MIT
#include "shell/session/ground_editor.h"

#include <algorithm>
#include <utility>

#include "core/document/joints.h"
#include "core/world/terrain.h"
#include "shell/session/ground_stroke.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

std::optional<KnownGround> GroundEditor::Preset() const {
  if (known_for_ != Corners()) {
    known_for_ = Corners();
    known_ = PresetOf(known_for_);
  }
  return known_;
}

bool GroundEditor::Set(std::vector<Corner> ground) {
  const bool limits = !ground.empty() && workspace_.Doc().model < kFirstDrawnGround;
  const bool set = workspace_.Change([&](Document& d) {
    d.environment.ground = std::move(ground);
    if (limits) LimitJoints(d);
  });
  if (set && limits)
    workspace_.Say(Tr("Drawn ground needs joints of limited strength, so they are limited now."));
  return set;
}

void GroundEditor::Choose(GroundPreset preset, std::uint32_t seed) {
  chosen_.reset();
  Set(GroundOf(preset, seed));
}

void GroundEditor::ChooseOtherRubble() {
  const auto known = Preset();
  const bool rubble = known && known->preset == GroundPreset::kRubble;
  Choose(GroundPreset::kRubble, rubble ? known->seed % kMostRubble + 1 : 1);
}

void GroundEditor::Draw(bool on) {
  drawing_ = on;
  chosen_.reset();
  if (!on) return;
  workspace_.Player().Play(false);
  workspace_.Player().Seek(0.0);
}

void GroundEditor::DrawLine(std::span<const Corner> drawn, float detail_m) {
  auto ground = WithStroke(Corners(), drawn, detail_m);
  if (!ground) return;
  chosen_.reset();
  Set(std::move(*ground));
}

std::optional<std::size_t> GroundEditor::Chosen() const {
  return chosen_ && *chosen_ < Corners().size() ? chosen_ : std::nullopt;
}

void GroundEditor::MoveCorner(std::size_t index, Corner target, float near_m) {
  std::vector<Corner> ground = Corners();
  if (index >= ground.size()) return;
  Corner& corner = ground[index];
  const Corner before = corner;
  corner = OnGrid(target);
  if (index > 0) {
    const Corner& left = ground[index - 1];
    const bool free = index < 2 || ground[index - 2].x_m != left.x_m;
    if (corner.x_m < left.x_m + (free ? near_m : 2.0f * kLeastCornerStep))
      corner.x_m = free ? left.x_m : OnGrid({left.x_m + 2.0f * kLeastCornerStep, 0.0f}).x_m;
  }
  if (index + 1 < ground.size()) {
    const Corner& right = ground[index + 1];
    const bool free = (index + 2 >= ground.size() || ground[index + 2].x_m != right.x_m) &&
                      (index == 0 || ground[index - 1].x_m != corner.x_m);
    if (corner.x_m > right.x_m - (free ? near_m : 2.0f * kLeastCornerStep))
      corner.x_m = free ? right.x_m : OnGrid({right.x_m - 2.0f * kLeastCornerStep, 0.0f}).x_m;
  }
  if (corner == before || !Validate(ground)) return;
  Set(std::move(ground));
}

void GroundEditor::RemoveCorner(std::size_t index) {
  std::vector<Corner> ground = Corners();
  if (index >= ground.size()) return;
  ground.erase(ground.begin() + static_cast<std::ptrdiff_t>(index));
  if (std::ranges::all_of(ground, [](const Corner& c) { return c.y_m == 0.0f; })) ground.clear();
  chosen_.reset();
  Set(std::move(ground));
}

void GroundEditor::AddCorner() {
  constexpr float kRoom = 0.1f, kBeyond = 1.0f;
  std::vector<Corner> ground = Corners();
  if (ground.empty()) {
    // The ends of a stretch in front of the figure. The second one is chosen, to be raised.
    if (Set({{kLevelStart, 0.0f}, {kLevelStart + kBeyond, 0.0f}})) chosen_ = 1;
    return;
  }
  if (ground.size() == kMaxCorners)
    return workspace_.Say(Tr("A ground has at most {1} corners.", std::to_string(kMaxCorners)));
  std::size_t at = Chosen().value_or(ground.size() - 1);
  while (at + 1 < ground.size() && ground[at + 1].x_m - ground[at].x_m < kRoom) ++at;
  const Corner& from = ground[at];
  const bool last = at + 1 == ground.size();
  const Corner to = last ? Corner{from.x_m + 2.0f * kBeyond, from.y_m} : ground[at + 1];
  const Corner middle = OnGrid({0.5f * (from.x_m + to.x_m), 0.5f * (from.y_m + to.y_m)});
  ground.insert(ground.begin() + static_cast<std::ptrdiff_t>(at) + 1, middle);
  if (!Validate(ground)) return;
  if (Set(std::move(ground))) chosen_ = at + 1;
}

void GroundEditor::Follow(bool opened) {
  if (opened) Draw(false);
}

}  // namespace gaitsmith::shell
