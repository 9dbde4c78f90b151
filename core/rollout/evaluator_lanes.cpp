// SPDX-License-Identifier: MIT
// Evaluators of every width, in a file of their own: a program that asks for none does not carry them.
#include "core/rollout/evaluator_width.h"

namespace gaitsmith {

Evaluator::Evaluator(const Problem& problem, int lanes, bool with_hash)
    : Evaluator(problem,
                lanes == 1   ? Width{1, &EvaluateWidth<1>}
                : lanes == 2 ? Width{2, &EvaluateWidth<2>}
                : lanes == 4 ? Width{4, &EvaluateWidth<4>}
                : lanes == 8 ? Width{8, &EvaluateWidth<8>}
                             : Width{16, &EvaluateWidth<16>},
                with_hash) {}

}  // namespace gaitsmith
