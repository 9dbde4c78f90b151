// SPDX-License-Identifier: MIT
// The parts of a document: one list, made from the schema, of which field belongs to which part. Documents
// are compared and copied by parts, so that a new field of the schema belongs everywhere to the part that it
// is in.
#pragma once

#include <cstdint>
#include <utility>  // has std::initializer_list

#include "core/document/document.h"

namespace gaitsmith {

/// Each field of the schema belongs to exactly one of these.
enum class Part {
  kTitle,
  kModel,
  kFigure,
  kEnvironment,
  kStart,
  kPushes,
  kGoal,         // the task's kind and weights
  kTaskLength,   // the task's duration
  kSought,       // what the next search makes: senses, number of rules, kind of controller
  kSearch,       // the settings of the next search, but for the two that follow
  kSearchStart,  // the controller that it begins with
  kTakeover,     // the clip and the handovers that it makes a controller for
  kControllers,
  kTimeline,
  kDuration,  // of the motion shown
  kPlan,
  kView,
  kLineage,
  kHash,
};
inline constexpr int kPartCount = 19;

/// A set of parts.
class Parts {
 public:
  constexpr Parts(Part part) : bits_(std::uint32_t{1} << static_cast<int>(part)) {}
  constexpr Parts(std::initializer_list<Parts> sets) {
    for (const Parts& set : sets) bits_ |= set.bits_;
  }
  [[nodiscard]] constexpr bool HasAny(Parts others) const { return (bits_ & others.bits_) != 0; }
  [[nodiscard]] constexpr bool Empty() const { return bits_ == 0; }
  [[nodiscard]] constexpr Parts Without(Parts others) const {
    Parts left = *this;
    left.bits_ &= ~others.bits_;
    return left;
  }
  constexpr bool operator==(const Parts&) const = default;

 private:
  std::uint32_t bits_ = 0;
};

[[nodiscard]] constexpr Parts AllParts() {
  Parts all({});
  for (int i = 0; i < kPartCount; ++i) all = {all, static_cast<Part>(i)};
  return all;
}

/// What acts on the figure at every step, the physical model included.
inline constexpr Parts kScene = {Part::kModel, Part::kFigure, Part::kEnvironment, Part::kStart};
inline constexpr Parts kTask = {Part::kGoal, Part::kTaskLength};

/// The parts, among these, in which two documents would be encoded differently.
[[nodiscard]] Parts DifferingParts(const Document& a, const Document& b, Parts among = AllParts());
/// Whether two documents would be encoded alike, as far as these parts go.
[[nodiscard]] bool SameParts(const Document& a, const Document& b, Parts);
/// These parts of `to` become what they are in `from`; all others stay.
void CopyParts(const Document& from, Parts, Document& to);

/// Whether two controllers do the same, whatever they are called.
[[nodiscard]] bool SameBehaviour(const Controller&, const Controller&);

}  // namespace gaitsmith
