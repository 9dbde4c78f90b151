// SPDX-License-Identifier: MIT
// Evaluators of every width, in a file of their own: a program that asks for none does not carry them.
#include "core/physics/evaluator_herd.h"

namespace gaitsmith {

Evaluator::Evaluator(const Problem& problem, int lanes, bool with_hash)
    : Evaluator(problem,
                lanes == 1   ? &EvaluateHerd<1>
                : lanes == 2 ? &EvaluateHerd<2>
                : lanes == 4 ? &EvaluateHerd<4>
                : lanes == 8 ? &EvaluateHerd<8>
                             : &EvaluateHerd<16>,
                with_hash) {}

}  // namespace gaitsmith
