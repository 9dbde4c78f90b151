// SPDX-License-Identifier: MIT
// Breeds the children of a nursery, on this thread.
#pragma once

#include <vector>

#include "core/breeding/litter.h"

namespace gaitsmith::test {

/// @param nursery valid
std::vector<Brood::Member> ChildrenOf(const Document& nursery);

}  // namespace gaitsmith::test
