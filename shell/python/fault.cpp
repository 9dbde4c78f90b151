// SPDX-License-Identifier: MIT
#include "shell/python/fault.h"

#include <pybind11/pybind11.h>

#include <chrono>

namespace gaitsmith::python {

namespace {

double SecondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

int InRange(const char* name, long long value, long long low, long long high) {
  if (value >= low && value <= high) return static_cast<int>(value);
  throw Fault(std::string(name) + ": must be from " + std::to_string(low) + " to " + std::to_string(high) +
              ", is " + std::to_string(value));
}

SignalWatch::SignalWatch() : looked_s_(SecondsNow()) {}

bool SignalWatch::operator()() {
  if (stopped_ || SecondsNow() - looked_s_ < 0.1) return stopped_;
  looked_s_ = SecondsNow();
  const pybind11::gil_scoped_acquire lock;
  // The handler's exception stays set until ThrowIfStopped.
  stopped_ = PyErr_CheckSignals() != 0;
  return stopped_;
}

void SignalWatch::ThrowIfStopped() const {
  if (stopped_) throw pybind11::error_already_set();
}

}  // namespace gaitsmith::python
