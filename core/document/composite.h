// SPDX-License-Identifier: MIT
// Simulates composite motions again after a change, without repeating what both documents have in common.
#pragma once

#include "core/document/document.h"

namespace gaitsmith {

/// The first step at which two documents' motions may differ. Before it, the same figure does the same on the
/// same ground. @return 0 if they have at most the start in common
[[nodiscard]] int PartingStep(const Document&, const Document&);

/// Like Simulate(document), with the same bits, but faster. @param known the motion of `before`
[[nodiscard]] Motion SimulateAnew(const Document& document, const Document& before, Motion known);

}  // namespace gaitsmith
