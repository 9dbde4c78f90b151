// SPDX-License-Identifier: MIT
// Small moving pictures of motions, for lists: a few poses as in a film strip, and the figure itself walking
// along them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// A motion, thinned out: poses at equal distances in time from the start to the end.
struct MotionStrip {
  Skeleton bones;
  std::vector<std::vector<ImVec2>> poses;  // endpoints about the centre of mass, which is at x = 0; y from
                                           // the ground up [m]
  ImRect extent;                           // of all poses
  bool leftward = false;
};

/// Those that were drawn lately, by name. Making one takes a simulation, so there is one a frame at most.
class MotionStrips {
 public:
  void BeginFrame() { made_ = waiting_ = false; }
  /// One was asked for and is not there yet.
  [[nodiscard]] bool Waiting() const { return waiting_; }
  /// @return null: not yet, ask again in the next frame
  [[nodiscard]] const MotionStrip* Of(const std::string& name, const Document& document);

 private:
  static constexpr std::size_t kMost = 120;

  std::map<std::string, MotionStrip, std::less<>> strips_;
  bool made_ = false;  // in this frame
  bool waiting_ = false;
};

/// @param share of the motion that the walking figure has done, in [0, 1]; below 0: it is not drawn
void DrawMotionStrip(const Ui&, const MotionStrip&, const ImRect&, float share);

}  // namespace gaitsmith::shell
