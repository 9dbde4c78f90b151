// SPDX-License-Identifier: MIT
// The only description of a document: its fields with names, ranges and standard values. Archives walk it to
// read, write or check, so JSON, links and validation always agree.
#pragma once

#include <array>
#include <string_view>

#include "core/document/archive.h"

namespace gaitsmith {

inline constexpr std::array<std::string_view, 2> kRodEndNames = {"start", "end"};
inline constexpr std::array<std::string_view, 3> kSenseKindNames = {"physical", "timer", "sight"};
inline constexpr std::array<std::string_view, 2> kFacingNames = {"right", "left"};
inline constexpr std::array<std::string_view, 2> kCurveEndNames = {"repeat", "rest"};

void Describe(Archive&, Figure&);
void Describe(Archive&, SearchSettings&);
void Describe(Archive&, Document&);

}  // namespace gaitsmith
