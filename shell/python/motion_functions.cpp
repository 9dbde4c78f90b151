// SPDX-License-Identifier: MIT
// Motions as arrays: trajectories, their terms, and what controllers decided.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "core/rollout/decisions.h"
#include "shell/export/trajectory_table.h"
#include "shell/python/bindings.h"
#include "shell/python/fault.h"

namespace gaitsmith::python {

namespace py = pybind11;

namespace {

/// The columns of `gaitsmith measure`.
py::dict TermsDict(const Document& document, const Terms& terms) {
  py::dict dict;
  dict["travel"] = terms.travel_m;
  for (int term = 0; term < kStyleTerms; ++term) {
    const std::string name(kStyleTermNames[static_cast<std::size_t>(term)]);
    dict[name.c_str()] = terms.Style(static_cast<StyleTerm>(term));
  }
  dict["fitness"] = Fitness(document.task, terms);
  return dict;
}

/// @return the columns by name, the trajectory's hash, and the terms of the whole motion
py::tuple SimulateDocument(const std::string& json) {
  const Document document = DocumentOf(json);
  std::vector<shell::TrajectoryColumn> table;
  std::uint64_t hash = 0;
  Terms terms;
  {
    const py::gil_scoped_release released;
    const Motion motion = Simulate(document);
    table = shell::TrajectoryTable(document, motion);
    hash = motion.Hash();
    terms = motion.TermsAt(motion.Frames() - 1);
  }
  py::dict columns;
  for (const shell::TrajectoryColumn& column : table) {
    const auto frames = static_cast<py::ssize_t>(column.values.size());
    if (column.name == "rule") {
      py::array_t<std::int32_t> rules(frames);
      std::ranges::transform(column.values, rules.mutable_data(),
                             [](double rule) { return static_cast<std::int32_t>(rule); });
      columns[column.name.c_str()] = rules;
    } else {
      columns[column.name.c_str()] = py::array_t<double>(frames, column.values.data());
    }
  }
  return py::make_tuple(columns, HashText(hash), TermsDict(document, terms));
}

/// Rows of one kind of the decisions' numbers, as an array.
py::array_t<float> RowsOfDecisions(const std::vector<Decision>& decisions,
                                   std::vector<float> Decision::* numbers) {
  const std::size_t width = decisions.empty() ? 0 : (decisions.front().*numbers).size();
  py::array_t<float> rows({static_cast<py::ssize_t>(decisions.size()), static_cast<py::ssize_t>(width)});
  float* at = rows.mutable_data();
  for (const Decision& decision : decisions) at = std::ranges::copy(decision.*numbers, at).out;
  return rows;
}

py::dict DecisionsOf(const std::string& json, long long clip) {
  const Document document = DocumentOf(json);
  const auto clips = static_cast<long long>(document.timeline.size());
  if (clips == 0) throw Fault("document.timeline: has no clip");
  const int index = InRange("clip", clip, 0, clips - 1);
  std::vector<Decision> decisions;
  {
    const py::gil_scoped_release released;
    decisions = RecordDecisions(ScriptOf(document), static_cast<std::size_t>(index));
  }
  py::array_t<std::int32_t> steps(static_cast<py::ssize_t>(decisions.size())), rules(steps.size());
  const auto controller =
      static_cast<std::size_t>(document.timeline[static_cast<std::size_t>(index)].controller);
  // As in the table of a trajectory.
  const int first = document.controllers[controller].kind == ControllerKind::kNetwork ? 0 : 1;
  std::ranges::transform(decisions, steps.mutable_data(), &Decision::step);
  std::ranges::transform(decisions, rules.mutable_data(),
                         [first](const Decision& one) { return one.rule + first; });
  py::dict dict;
  dict["step"] = steps;
  dict["rule"] = rules;
  dict["senses"] = RowsOfDecisions(decisions, &Decision::senses);
  dict["target"] = RowsOfDecisions(decisions, &Decision::targets);
  dict["inverse_tau"] = RowsOfDecisions(decisions, &Decision::inverse_tau);
  dict["decay"] = RowsOfDecisions(decisions, &Decision::decay);
  return dict;
}

}  // namespace

void AddMotionFunctions(py::module_& core) {
  core.def("simulate", &SimulateDocument);
  core.def("decisions", &DecisionsOf);
}

}  // namespace gaitsmith::python
