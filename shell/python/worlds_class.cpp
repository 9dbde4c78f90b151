// SPDX-License-Identifier: MIT
// The figures of a vector environment as arrays. gaitsmith/vector_env.py has the rules of episodes.
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "shell/python/array_check.h"
#include "shell/python/bindings.h"
#include "shell/python/fault.h"
#include "shell/python/figure_worlds.h"

namespace gaitsmith::python {

namespace py = pybind11;

namespace {

/// Which of the two observations a name means.
Observation ObservationOf(const std::string& name) {
  if (name == "senses") return Observation::kSenses;
  if (name == "state") return Observation::kState;
  throw Fault("observation: must be one of senses, state, is \"" + name + "\"");
}

/// The problem of a document, if worlds can have it.
Problem ProblemIn(const std::string& json) {
  Problem problem = ProblemOf(DocumentOf(json));
  if (!problem.beginnings.empty())
    throw Fault("document.search: an environment begins at the start, without handovers or clips before it");
  if (!problem.worlds.empty())
    throw Fault("document.search.worlds: an environment has one world, are several");
  return problem;
}

class WorldsClass {
 public:
  WorldsClass(const std::string& json, long long count, const std::string& observation, double tau_s,
              long long frame_skip)
      : count_(static_cast<std::size_t>(InRange("num_envs", count, 1, 65536))),
        frame_skip_(InRange("frame_skip", frame_skip, 1, 1000)) {
    if (!(tau_s >= 0.02 && tau_s <= 10.0))
      throw Fault("tau: must be from 0.02 to 10, is " + std::string(py::str(py::float_(tau_s))));
    worlds_ =
        MakeFigureWorlds(ProblemIn(json), count_, ObservationOf(observation), static_cast<float>(tau_s));
    limits_ = worlds_->JointLimits();
    width_ = worlds_->Names().size();
  }

  /// @param chosen worlds (n), bool @param noise to add to the start's velocity and spin (n, 3)
  void Reset(const py::object& chosen, const py::object& noise) {
    const auto n = static_cast<py::ssize_t>(count_);
    const auto mask = Floats("chosen", chosen, {n}), added = Floats("noise", noise, {n, 3});
    Alone([&] {
      for (std::size_t i = 0; i < count_; ++i) {
        const float* by = added.data() + 3 * i;
        if (mask.data()[i] != 0.0f) worlds_->Reset(i, by[0], by[1], by[2]);
      }
    });
  }

  py::array_t<float> Observe() {
    py::array_t<float> seen({count_, width_});
    float* numbers = seen.mutable_data();
    Alone([&] { Look(numbers); });
    return seen;
  }

  py::array_t<double> Travel() {
    py::array_t<double> travel(static_cast<py::ssize_t>(count_));
    double* numbers = travel.mutable_data();
    Alone([&] {
      for (std::size_t i = 0; i < count_; ++i) numbers[i] = worlds_->TravelOf(i);
    });
    return travel;
  }

  /// @param actions targets (n, joints) [rad] @param idle worlds (n) that do not move, bool
  /// @return observations, progress, terminated, truncated
  py::tuple Step(const py::object& actions, const py::object& idle) {
    const auto n = static_cast<py::ssize_t>(count_);
    const auto targets = Floats("actions", actions, {n, static_cast<py::ssize_t>(limits_.size())});
    const auto rests = Floats("idle", idle, {n});
    const std::size_t joints = limits_.size();
    for (std::size_t i = 0; i < count_ * joints; ++i) {
      if (rests.data()[i / joints] == 0.0f && !std::isfinite(targets.data()[i]))
        throw Fault("actions[" + std::to_string(i / joints) + ", " + std::to_string(i % joints) +
                    "]: must be finite");
    }
    py::array_t<float> seen({count_, width_});
    py::array_t<double> progress(n);
    py::array_t<bool> terminated(n), truncated(n);
    float* numbers = seen.mutable_data();
    double* gains = progress.mutable_data();
    bool *broken = terminated.mutable_data(), *over = truncated.mutable_data();
    Alone([&] {
      for (std::size_t i = 0; i < count_; ++i) {
        WorldStep step;
        if (rests.data()[i] == 0.0f)
          step = worlds_->Step(i, {targets.data() + i * joints, joints}, frame_skip_);
        gains[i] = step.progress;
        broken[i] = step.terminated;
        over[i] = step.truncated;
      }
      Look(numbers);
    });
    return py::make_tuple(seen, progress, terminated, truncated);
  }

  /// @return least and greatest angle of each joint (2, joints) [rad]
  [[nodiscard]] py::array_t<float> Limits() const {
    py::array_t<float> limits({std::size_t{2}, limits_.size()});
    for (std::size_t j = 0; j < limits_.size(); ++j) {
      limits.mutable_data()[j] = limits_[j][0];
      limits.mutable_data()[limits_.size() + j] = limits_[j][1];
    }
    return limits;
  }
  [[nodiscard]] std::vector<std::string> Names() const { return worlds_->Names(); }

 private:
  void Look(float* numbers) const {
    for (std::size_t i = 0; i < count_; ++i) worlds_->Observe(i, {numbers + i * width_, width_});
  }
  /// Calls without the interpreter's lock, one at a time.
  template <class Call>
  void Alone(Call call) {
    const py::gil_scoped_release released;
    const std::lock_guard lock(mutex_);
    call();
  }

  std::mutex mutex_;  // guards the worlds
  std::size_t count_;
  int frame_skip_;
  std::unique_ptr<FigureWorlds> worlds_;
  std::vector<std::array<float, 2>> limits_;
  std::size_t width_ = 0;  // of an observation
};

}  // namespace

void AddWorldsClass(py::module_& core) {
  py::class_<WorldsClass>(core, "Worlds")
      .def(py::init<const std::string&, long long, const std::string&, double, long long>())
      .def("reset", &WorldsClass::Reset)
      .def("observe", &WorldsClass::Observe)
      .def("travel", &WorldsClass::Travel)
      .def("step", &WorldsClass::Step)
      .def("limits", &WorldsClass::Limits)
      .def("names", &WorldsClass::Names);
}

}  // namespace gaitsmith::python
