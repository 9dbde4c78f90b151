// SPDX-License-Identifier: MIT
// Small animated pictures of motions for lists: a few poses as in a film strip, and the figure moving along
// them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "shell/body/figure_look.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// A motion reduced to poses at equal intervals from start to end.
struct MotionStrip {
  FigureLook look;
  std::vector<std::vector<ImVec2>> poses;  // endpoints [m]: x from the centre of mass, y from the ground
  ImRect extent;                           // bounds of all poses [m]
  bool leftward = false;
  std::size_t highest = 0;  // the pose whose endpoints are highest on average, after the start
};

/// A cache of recently drawn strips, by name. Each needs a simulation, so at most one is made per frame.
class MotionStrips {
 public:
  void BeginFrame() { made_ = waiting_ = false; }
  /// Whether a requested strip is not ready yet.
  [[nodiscard]] bool Waiting() const { return waiting_; }
  /// @return null: not ready, ask again in the next frame
  /// @param document called if the strip has to be made
  [[nodiscard]] const MotionStrip* Of(const std::string& name, const std::function<Document()>& document);

 private:
  static constexpr std::size_t kMax = 400;

  std::map<std::string, MotionStrip, std::less<>> strips_;
  bool made_ = false;  // whether one was made in this frame
  bool waiting_ = false;
};

/// @param share progress of the moving figure, [0, 1]; below 0: no figure is drawn
void DrawMotionStrip(const Ui&, const MotionStrip&, const ImRect&, float share);

/// Draws the highest pose alone, as large as it fits. @param behind the colour it is drawn on
void DrawMotionPose(const Ui&, const MotionStrip&, const ImRect&, ImU32 behind);

}  // namespace gaitsmith::shell
