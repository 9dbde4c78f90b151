// SPDX-License-Identifier: MIT
// Icons, drawn as shapes, so that they are sharp at any scale without an icon font.
#pragma once

#include <imgui.h>

namespace gaitsmith::shell {

enum class Icon {
  kPlay,
  kPause,
  kStepForward,
  kStepBack,
  kRestart,
  kPlus,
  kMinus,
  kClose,
  kChevronDown,
  kChevronUp,
  kCheck,
  kStop,
  kBookmark,  // an outline, and filled for saved motions
  kBookmarkFull,
  kPencil,
  kHeart,
  kNoHeart,  // struck through
  kSwap
};

/// @param size edge of the icon's square [points]; 14 suits 13 px type
void DrawIcon(ImDrawList*, Icon, ImVec2 centre, float size, ImU32 colour);

}  // namespace gaitsmith::shell
