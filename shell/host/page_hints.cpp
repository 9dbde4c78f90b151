// SPDX-License-Identifier: MIT
// Takes the sentences of the tooltips from the page, which loads them after the first motion.
#include <emscripten.h>

#include "shell/words/hints.h"

extern "C" {

/// @param table of shell/words/hints, as JSON. @return 0: it is not such a table, and nothing has changed
EMSCRIPTEN_KEEPALIVE int gs_set_hints(const char* table) { return gaitsmith::shell::SetHints(table) ? 1 : 0; }

}  // extern "C"
