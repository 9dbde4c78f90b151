// SPDX-License-Identifier: MIT
// A motion as a table of numbers, which CSV files and Python's arrays share: docs/command-line.md documents
// the columns.
#pragma once

#include <string>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

struct TrajectoryColumn {
  std::string name;            // such as "theta_1"
  int digits;                  // significant ones that give back the same number
  std::vector<double> values;  // by frame
};

/// @param motion of the document
[[nodiscard]] std::vector<TrajectoryColumn> TrajectoryTable(const Document& document, const Motion& motion);

}  // namespace gaitsmith::shell
