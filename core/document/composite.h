// SPDX-License-Identifier: MIT
// Composite motions anew after a change: what two documents have in common is not simulated twice.
#pragma once

#include "core/document/document.h"

namespace gaitsmith {

/// The first step at which two documents' motions may part: until then the same figure on the same ground
/// does the same. @return 0: they have nothing in common but, maybe, the start
[[nodiscard]] int PartingStep(const Document&, const Document&);

/// As Simulate(document), with the same bits. @param known the motion of `before`
[[nodiscard]] Motion SimulateAnew(const Document& document, const Document& before, Motion known);

}  // namespace gaitsmith
