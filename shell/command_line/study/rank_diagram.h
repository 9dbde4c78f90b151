// SPDX-License-Identifier: MIT
// A critical-difference diagram [Demsar 2006]: searches at their mean ranks on a line, and bars over those
// that nothing tells apart.
#pragma once

#include <span>
#include <string>

#include "shell/study/rank_order.h"

namespace gaitsmith::shell {

/// As SVG. @param names of the searches, as the order counts them. @param blocks over which ranks are means
[[nodiscard]] std::string RankDiagramSvg(const RankOrder&, std::span<const std::string> names,
                                         std::size_t blocks);

}  // namespace gaitsmith::shell
