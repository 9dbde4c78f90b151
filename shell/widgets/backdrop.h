// SPDX-License-Identifier: MIT
// Large plain rectangles behind everything else. Clearing a part of the window costs next to nothing; a
// rectangle drawn by Dear ImGui is textured and blended pixel by pixel, which is most of a frame where
// graphics are software.
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
  /// In this frame. Later areas lie over earlier ones, and whatever Dear ImGui draws over all of them.
  void Fill(const ImRect& rect, ImU32 colour) { areas_.push_back({rect, colour}); }
  [[nodiscard]] const std::vector<Area>& Areas() const { return areas_; }

 private:
  std::vector<Area> areas_;
};

}  // namespace gaitsmith::shell
