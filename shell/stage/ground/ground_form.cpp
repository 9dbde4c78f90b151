// SPDX-License-Identifier: MIT
#include "shell/stage/ground/ground_form.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/world/terrain.h"
#include "shell/widgets/fold.h"
#include "shell/words/ground_words.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

void DrawPresets(Ui& ui, Session& session) {
  GroundEditor& ground = session.Ground();
  std::vector<std::string> names;
  names.reserve(kGroundPresets);
  for (const char* name : GroundNames()) names.emplace_back(Tr(name));
  const auto known = ground.Preset();
  int chosen = known ? static_cast<int>(known->preset) : -1;
  if (ui.Combo("world/ground", Tr("Shape"), names, chosen, GroundWords(known)))
    ground.Choose(static_cast<GroundPreset>(chosen), 1);
  if (!known || known->preset != GroundPreset::kRubble) return;
  ui.Gap(6.0f);
  auto seed = static_cast<int>(known->seed);
  ui.Number("world/rubble", Tr("Which rubble"), seed, 1, kMostRubble);
  if (seed != static_cast<int>(known->seed))
    ground.Choose(GroundPreset::kRubble, static_cast<std::uint32_t>(std::clamp(seed, 1, kMostRubble)));
}

void DrawChosenCorner(Ui& ui, GroundEditor& ground) {
  const std::vector<Corner>& corners = ground.Corners();
  const auto count = static_cast<int>(corners.size());
  int number = static_cast<int>(ground.Chosen().value_or(0)) + 1;
  ui.Number("world/corner", Tr("Corner"), number, 1, count);
  const auto index = static_cast<std::size_t>(std::clamp(number, 1, count)) - 1;
  if (number != static_cast<int>(ground.Chosen().value_or(0)) + 1) ground.ChooseCorner(index);
  const Corner corner = corners[index];
  const auto far = static_cast<double>(kMaxCornerX), high = static_cast<double>(kMaxCornerY);
  double x_m = static_cast<double>(corner.x_m), y_m = static_cast<double>(corner.y_m);
  const double left = index > 0 ? static_cast<double>(corners[index - 1].x_m) : std::max(-far, x_m - 10.0);
  const double right =
      index + 1 < corners.size() ? static_cast<double>(corners[index + 1].x_m) : std::min(far, x_m + 10.0);
  bool moved = ui.Slider("world/corner-along", Tr("Along the ground"), x_m,
                         {.low = left, .high = std::max(right, left + 0.01), .step = 0.01},
                         Fixed(corner.x_m, 2) + " m");
  constexpr double kUsual = 3.0;
  moved |= ui.Slider("world/corner-height", Tr("Height"), y_m,
                     {.low = std::max(-high, std::min(-kUsual, y_m)),
                      .high = std::min(high, std::max(kUsual, y_m)),
                      .step = 0.01},
                     Fixed(corner.y_m, 2) + " m");
  if (moved) {
    ground.ChooseCorner(index);
    ground.MoveCorner(index, {static_cast<float>(x_m), static_cast<float>(y_m)}, kLeastCornerStep);
  }
  ui.Gap(4.0f);
  if (ui.Button("world/corner-remove", ui.ControlRow(), Tr("Remove this corner"))) ground.RemoveCorner(index);
  ui.Gap(6.0f);
}

}  // namespace

void DrawGroundForm(Ui& ui, Session& session, GroundFormState& state) {
  GroundEditor& ground = session.Ground();
  ui.Heading(Tr("Ground"));
  DrawPresets(ui, session);
  ui.Gap(6.0f);
  const bool drawing = ground.Drawing();
  if (ui.Button("world/ground-draw", ui.ControlRow(), drawing ? Tr("End drawing") : Tr("Draw the ground")))
    ground.Draw(!drawing);
  ui.Gap(6.0f);
  const std::string count = std::to_string(ground.Corners().size());
  if (DrawFold(ui, "world/corners", Tr("Corners"), count, state.corners_open)) {
    if (!ground.Level()) DrawChosenCorner(ui, ground);
    if (ui.Button("world/corner-add", ui.ControlRow(), Tr("Add a corner"))) ground.AddCorner();
  }
  ui.Gap(6.0f);
}

}  // namespace gaitsmith::shell
