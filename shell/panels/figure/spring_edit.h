// SPDX-License-Identifier: MIT
// Edits of a figure of springs: nodes and springs added, moved and taken away, on both sides at once where
// the figure is symmetric. Core validates the result.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "core/physics/figure.h"

namespace gaitsmith::shell {

/// What can be chosen of a figure of springs: a node, or a spring.
struct SpringPart {
  enum class Kind { kNode, kSpring } kind = Kind::kNode;
  int index = 0;

  bool operator==(const SpringPart&) const = default;
};

/// Where the mirror stands [m]; nothing: an edit is of one side only. What is within kOnMirror of it is on
/// it.
using Mirror = std::optional<float>;
inline constexpr float kOnMirror = 0.04f;

/// The node, or the spring between the nodes, at the other side of the mirror; -1: there is none.
[[nodiscard]] int ImageOfNode(const Figure&, int node, float mirror_m);
[[nodiscard]] int ImageOfSpring(const Figure&, int spring, float mirror_m);

/// The middle of the drawn figure [m].
[[nodiscard]] float MiddleOf(const Figure&);

/// A spring from here to there [m], to start a drawing.
[[nodiscard]] Figure SpringBetween(ImVec2 from, ImVec2 to);

/// With a node here, held by springs to the two nodes nearest to it.
[[nodiscard]] Figure WithNodeAt(const Figure&, ImVec2 place, Mirror);
/// With a node here, held by springs to `from` and to the node that is then nearest.
[[nodiscard]] Figure WithNodeFrom(const Figure&, int from, ImVec2 place, Mirror);
/// With a node beside this one, in a free direction.
[[nodiscard]] Figure WithNodeGrown(const Figure&, int node, Mirror);
/// With a spring between two nodes that have none.
[[nodiscard]] Figure WithSpring(const Figure&, int from, int to, Mirror);
[[nodiscard]] Figure WithNodeMoved(const Figure&, int node, ImVec2 place, Mirror);
/// A spring becomes a muscle, a muscle a spring.
[[nodiscard]] Figure WithMuscleToggled(const Figure&, int spring, Mirror);
/// Without a node and its springs, or without a spring. Nodes that nothing holds any more go, too.
[[nodiscard]] Figure Without(const Figure&, SpringPart, Mirror);

/// Every number of a node or a spring, given to its image, too.
[[nodiscard]] Figure WithNode(const Figure&, int node, const Node&, Mirror);
[[nodiscard]] Figure WithSpringAs(const Figure&, int spring, const Spring&, Mirror);

/// All springs as many times as stiff, as far as the figure's fastest vibration allows. Their damping grows
/// with the root, so that vibrations fade within as many of their cycles as before.
[[nodiscard]] Figure WithStiffness(const Figure&, float times);
/// "soft", "firm" or "stiff": by how far the figure's weight would press it together.
[[nodiscard]] const char* StiffnessWords(const Figure&);

/// Exchanges left and right.
[[nodiscard]] Figure MirroredSprings(const Figure&);

}  // namespace gaitsmith::shell
