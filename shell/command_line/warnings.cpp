// SPDX-License-Identifier: MIT
#include "shell/command_line/warnings.h"

#include <cstdio>

#include "core/document/joints.h"

namespace gaitsmith::shell {

void WarnOfMasses(const std::string& name, const Document& document) {
  if (!HasUnequalRods(document)) return;
  std::fprintf(stderr,
               "warning: %s%sthe heaviest rod weighs %.0f times as much as the lightest. Above %.0f, motions "
               "with limited joints may fail.\n",
               name.c_str(), name.empty() ? "" : ": ", static_cast<double>(MassRatio(document.figure)),
               static_cast<double>(kMostMassRatio));
}

}  // namespace gaitsmith::shell
