// SPDX-License-Identifier: MIT
#include <cstdio>

#include "shell/export/exporters.h"
#include "shell/export/trajectory_table.h"

namespace gaitsmith::shell {

std::string TrajectoryCsv(const Document& document, const Motion& motion) {
  const std::vector<TrajectoryColumn> table = TrajectoryTable(document, motion);
  std::string csv;
  for (const TrajectoryColumn& column : table) csv.append(csv.empty() ? "" : ",").append(column.name);
  csv += "\n";
  for (std::size_t i = 0; i < static_cast<std::size_t>(motion.Frames()); ++i) {
    for (const TrajectoryColumn& column : table) {
      char text[40];
      std::snprintf(text, sizeof text, "%s%.*g", csv.back() == '\n' ? "" : ",", column.digits,
                    column.values[i]);
      csv += text;
    }
    csv += "\n";
  }
  return csv;
}

}  // namespace gaitsmith::shell
