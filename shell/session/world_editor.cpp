// SPDX-License-Identifier: MIT
#include "shell/session/world_editor.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/document/joints.h"
#include "core/document/parts.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

bool WorldEditor::Push(int endpoint, float impulse_x_ns, float impulse_y_ns) {
  const int step = std::min(workspace_.Player().Frame(), kMaxSteps - 1);
  const bool pushed = workspace_.Change([&](Document& d) {
    const gaitsmith::Push push{
        .step = step, .endpoint = endpoint, .impulse_x_ns = impulse_x_ns, .impulse_y_ns = impulse_y_ns};
    const auto after = std::ranges::upper_bound(d.pushes, step, {}, &gaitsmith::Push::step);
    d.pushes.insert(after, push);
  });
  if (pushed) {
    workspace_.Report(Tr("Pushed with {1} N s at {2} s.", Fixed(std::hypot(impulse_x_ns, impulse_y_ns), 1),
                         Fixed(static_cast<float>(step) * kStep, 2)));
  }
  return pushed;
}

void WorldEditor::Shove() {
  constexpr float kChange = 1.5f;  // of the velocity of the centre of mass [m/s]
  Playback& player = workspace_.Player();
  const double before_s = player.TimeS();
  // Late in the motion nobody could see what follows.
  if (player.TimeS() > 0.8 * player.DurationS()) player.Seek(0.3 * player.DurationS());
  const double moved_m = player.CentreAt(player.TimeS()).x_m - player.CentreAt(player.TimeS() - 0.5).x_m;
  const float against = moved_m < 0.0 ? 1.0f : -1.0f;
  if (Push(kCentreOfMass, against * kChange * player.Shown().Bones().mass_kg, 0.0f)) {
    player.Play(true);
  } else {
    player.Seek(before_s);
  }
}

void WorldEditor::RemovePush(std::size_t index) {
  workspace_.Change(
      [&](Document& d) { d.pushes.erase(d.pushes.begin() + static_cast<std::ptrdiff_t>(index)); });
}

bool WorldEditor::Changed() const {
  // Compared member by member: this runs at every frame.
  const Document& shown = workspace_.Doc();
  const auto strength = [](const Rod& a, const Rod& b) { return a.strength == b.strength; };
  return shown.environment != as_opened_.environment || shown.pushes != as_opened_.pushes ||
         shown.model != as_opened_.model ||
         (HasLimitedJoints(shown) &&
          !std::ranges::equal(shown.figure.rods, as_opened_.figure.rods, strength));
}

void WorldEditor::Reset() {
  workspace_.Change([&](Document& d) {
    CopyParts(as_opened_, {Part::kEnvironment, Part::kPushes, Part::kModel}, d);
    for (std::vector<Rod>* rods : {&d.figure.rods, &d.drawn}) {
      for (std::size_t i = 0; i < rods->size(); ++i) (*rods)[i].strength = as_opened_.figure.rods[i].strength;
    }
  });
}

void WorldEditor::LimitJoints(bool limited) {
  workspace_.Change([limited](Document& d) { limited ? gaitsmith::LimitJoints(d) : FreeJoints(d); });
}

void WorldEditor::SetJointStrength(float strength) {
  workspace_.Change([strength](Document& d) { gaitsmith::SetJointStrength(strength, d); });
}

void WorldEditor::Follow(bool opened) {
  const Document& shown = workspace_.Doc();
  // Edits of another figure's world do not apply to this one.
  if (opened || !SameTree(as_opened_.figure, shown.figure)) as_opened_ = shown;
}

}  // namespace gaitsmith::shell
