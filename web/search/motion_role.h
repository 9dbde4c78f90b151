// SPDX-License-Identifier: MIT
// What the engine's border keeps of an open motion.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/document/document.h"
#include "shell/body/figure_look.h"

namespace gaitsmith {

struct MotionRole {
  Document document;
  Motion motion;
  std::vector<int> starts = {};     // of each rod: the endpoint where it begins
  std::vector<float> numbers = {};  // all frames, one after another
  std::vector<float> ground = {};   // x and y of its corners
  shell::FigureLook look = {};
  std::vector<float> body = {};
  std::string text = {};
  std::string loop = "null";  // what is known of a loop, as JSON
  bool from_start = true;     // as the document's start says
};

/// @param motion of the document
MotionRole* OpenMotion(Document document, Motion motion);

/// Keeps a text for gs_motion_text_size(). @return it
inline const char* Keep(MotionRole* role, std::string text) {
  role->text = std::move(text);
  return role->text.data();
}

}  // namespace gaitsmith
