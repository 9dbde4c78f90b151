// SPDX-License-Identifier: MIT
// A problem of a document with what evaluates its genomes.
#pragma once

#include <optional>
#include <string>

#include "core/document/document.h"
#include "core/rollout/evaluator.h"

namespace gaitsmith::python {

/// The document with a genome that its search found as its motion, as `gaitsmith synthesize` writes it.
/// @throws Fault if the document has no room for another controller
Document DocumentWith(const Document& searched, const Genome& found);

}  // namespace gaitsmith::python
