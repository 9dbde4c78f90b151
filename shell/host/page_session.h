// SPDX-License-Identifier: MIT
// What page.cpp shares with the other files of the bridge between the canvas and the page.
#pragma once

#include "shell/app/window.h"
#include "shell/session/session.h"

namespace gaitsmith::shell {

// Of the one application in the page. Only after gs_running() has returned 1.
Session& TheSession();
Window& TheWindow();

}  // namespace gaitsmith::shell
