// SPDX-License-Identifier: MIT
// Large plain rectangles behind everything else. Clearing a part of the window costs almost nothing. A
// rectangle drawn by Dear ImGui is textured and blended pixel by pixel, which takes most of a frame with
// software graphics.
#pragma once

#include <imgui_internal.h>

#include <vector>

namespace gaitsmith::shell {

class Backdrop {
 public:
  struct Area {
    ImRect rect;   // [points]
    ImU32 colour;  // opaque
  };

  void Clear() { areas_.clear(); }
  /// For this frame only. Later areas cover earlier ones, and everything drawn by Dear ImGui covers all
  /// areas.
  void Fill(const ImRect& rect, ImU32 colour) { areas_.push_back({rect, colour}); }
  [[nodiscard]] const std::vector<Area>& Areas() const { return areas_; }

 private:
  std::vector<Area> areas_;
};

}  // namespace gaitsmith::shell
