// SPDX-License-Identifier: MIT
// The ground of the open document: presets, a line drawn by hand, and its corners. It is part of the
// document's world. Joints of limited strength alone know a drawn ground, so choosing one limits them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/world/ground_preset.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class GroundEditor {
 public:
  explicit GroundEditor(Workspace& workspace) : workspace_(workspace) {}

  [[nodiscard]] const std::vector<Corner>& Corners() const { return workspace_.Doc().environment.ground; }
  [[nodiscard]] bool Level() const { return Corners().empty(); }
  /// The preset that the ground is; nothing if it was drawn by hand.
  [[nodiscard]] std::optional<KnownGround> Preset() const;
  /// @param seed  of rubble, [1, kMostRubble]
  void Choose(GroundPreset, std::uint32_t seed);
  /// Another rubble than the present one.
  void ChooseOtherRubble();

  /// Whether drags on the stage draw. While they do, the motion rests at its start.
  [[nodiscard]] bool Drawing() const { return drawing_; }
  void Draw(bool on);
  /// Draws a line over a part of the ground. @param drawn  in order @param detail_m  as of WithStroke
  void DrawLine(std::span<const Corner> drawn, float detail_m);

  /// The corner that the buttons act on; nothing if there is none.
  [[nodiscard]] std::optional<std::size_t> Chosen() const;
  void ChooseCorner(std::optional<std::size_t> index) { chosen_ = index; }
  /// Moves a corner, no farther than its neighbours. Close to a place above or below one of them it is put
  /// there. @param near_m  how close
  void MoveCorner(std::size_t index, Corner target, float near_m);
  void RemoveCorner(std::size_t index);
  /// Adds a corner behind the chosen one and chooses it.
  void AddCorner();

  /// Call after each new motion. @param opened  another document replaced the present one
  void Follow(bool opened);

 private:
  /// @return false, with a sentence: a part is locked
  bool Set(std::vector<Corner> ground);

  Workspace& workspace_;
  bool drawing_ = false;
  std::optional<std::size_t> chosen_;
  // The answer of Preset, which is asked at every frame.
  mutable std::vector<Corner> known_for_;
  mutable std::optional<KnownGround> known_ = KnownGround{};
};

/// Whether joints without limits cannot be chosen, because the document's ground is drawn.
[[nodiscard]] inline bool GroundNeedsLimits(const Document& document) {
  return !document.environment.ground.empty();
}

}  // namespace gaitsmith::shell
