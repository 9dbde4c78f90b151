// SPDX-License-Identifier: MIT
// Large opaque rectangles behind everything else, drawn by clearing. Clearing costs almost nothing, whereas
// Dear ImGui's textured, blended rectangles would take most of the frame time with software rendering.
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
  /// Fills an area in this frame. Later areas cover earlier ones, and Dear ImGui's drawing covers all areas.
  void Fill(const ImRect& rect, ImU32 colour) { areas_.push_back({rect, colour}); }
  [[nodiscard]] const std::vector<Area>& Areas() const { return areas_; }

 private:
  std::vector<Area> areas_;
};

}  // namespace gaitsmith::shell
