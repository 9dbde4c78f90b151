// SPDX-License-Identifier: MIT
#include "shell/words/ground_words.h"

#include "shell/words/language.h"

namespace gaitsmith::shell {

const std::array<const char*, kGroundPresets>& GroundNames() {
  static constexpr std::array<const char*, kGroundPresets> kNames = {
      TrLater("Level"), TrLater("Step"),    TrLater("Stairs"), TrLater("Ramp"),
      TrLater("Gap"),   TrLater("Hurdles"), TrLater("Rubble")};
  return kNames;
}

std::string GroundWords(const std::optional<KnownGround>& known) {
  if (!known) return Tr("Hand-drawn");
  const char* name = Tr(GroundNames()[static_cast<std::size_t>(known->preset)]);
  if (known->preset != GroundPreset::kRubble) return name;
  return name + (" " + std::to_string(known->seed));
}

}  // namespace gaitsmith::shell
