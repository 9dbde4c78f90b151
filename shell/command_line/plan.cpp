// SPDX-License-Identifier: MIT
// gaitsmith plan: the motion that fulfils a document's keyframes and costs least.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "core/document/json.h"
#include "core/planning/plan_tracking.h"
#include "core/planning/planning.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"

namespace gaitsmith::shell {

namespace {

/// What a planned motion does at every step, as a table.
std::string TableOf(const PlannedMotion& motion) {
  std::string text("time_s,centre_x,centre_y");
  const int endpoints = motion.Scene().skeleton.endpoints, joints = motion.Scene().skeleton.joints;
  for (int k = 0; k < endpoints; ++k) {
    for (const std::string_view name : {"x_", "y_", "force_x_", "force_y_"})
      text.append(",").append(name).append(std::to_string(k));
  }
  for (int j = 1; j <= joints; ++j)
    text.append(",angle_").append(std::to_string(j)).append(",torque_").append(std::to_string(j));
  text += "\n";
  const auto add = [&text](double value) {
    std::array<char, 32> number;
    std::snprintf(number.data(), number.size(), ",%.9g", value);
    text += number.data();
  };
  for (int step = 0; step <= motion.Scene().plan.steps; ++step) {
    const double time_s = step * static_cast<double>(kStep);
    const PlannedMotion::Instant at = motion.At(time_s);
    text += std::to_string(step / 100);
    text += step % 100 < 10 ? ".0" : ".";
    text += std::to_string(step % 100);
    add(at.centre.x);
    add(at.centre.y);
    for (std::size_t k = 0; k < at.endpoints.size(); ++k) {
      add(at.endpoints[k].x);
      add(at.endpoints[k].y);
      add(at.forces[k].x);
      add(at.forces[k].y);
    }
    for (std::size_t j = 0; j < at.angle_rad.size(); ++j) {
      add(at.angle_rad[j]);
      add(at.torque_nm[j]);
    }
    text += "\n";
  }
  return text;
}

/// The greatest moment that is not explained, between the points where none is [M g l].
double ResidualOf(const PlannedMotion& motion) {
  double worst = 0.0;
  for (int i = 0; i <= 10 * motion.Scene().plan.steps; ++i)
    worst = std::max(worst, std::abs(motion.At(0.1 * i * static_cast<double>(kStep)).moment_residual));
  return worst;
}

}  // namespace

Outcome PlanCommand(Words words) {
  static constexpr std::array<std::string_view, 5> kOptions = {"degree", "motion", "out", "pieces", "rules"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  if (arguments->Positional().size() != 1)
    return Fail(ErrorCode::kMissing, "DOC", "give exactly one document");
  PlanGrid grid = kFinePlan;
  const auto whole = [&](std::string_view name, int least, int most, int& value) -> Outcome {
    if (!arguments->Has(name)) return {};
    const auto given = ParseWhole(arguments->Last(name), least, most, "--" + std::string(name));
    if (!given) return std::unexpected(given.error());
    value = static_cast<int>(*given);
    return {};
  };
  if (auto taken = whole("degree", 3, 5, grid.degree); !taken) return taken;
  if (auto taken = whole("pieces", 2, 64, grid.pieces_per_second); !taken) return taken;
  const auto document = ReadDocument(arguments->Positional()[0]);
  if (!document) return std::unexpected(document.error());
  if (auto planned = CanBePlanned(*document); !planned) return planned;

  PlanReport last;
  Document solved;
  CarryOutPlan(*document, grid, [&](const PlanReport& report) {
    if (report.stage == PlanReport::Stage::kFine) solved = report.document;
    last = report;
    return true;
  });
  if (last.stage == PlanReport::Stage::kRefused) {
    if (last.misses.empty())
      return Fail(ErrorCode::kStructure, "plan", "no motion was found that fulfils it");
    return std::unexpected(ErrorOf(last.misses.front()));
  }
  const PlannedMotion motion = SolvedMotion(solved);
  std::printf("iterations,cost,residual,played_miss,first_miss,corrections\n%d,%.9g,%.9g,%.9g,%.9g,%d\n",
              last.iterations, last.cost, ResidualOf(motion), last.played_miss_m, last.first_miss_m,
              last.corrections);
  if (arguments->Has("motion")) {
    if (auto written = WriteText(arguments->Last("motion"), TableOf(motion)); !written) return written;
  }
  if (arguments->Has("rules")) {
    const auto tracked = TrackPlan(last.document);
    if (!tracked) return std::unexpected(tracked.error());
    if (auto written = WriteText(arguments->Last("rules"), EncodeJson(*tracked)); !written) return written;
  }
  if (!arguments->Has("out")) return {};
  last.document.hash = Simulate(last.document).Hash();
  return WriteText(arguments->Last("out"), EncodeJson(last.document));
}

}  // namespace gaitsmith::shell
