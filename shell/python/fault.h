// SPDX-License-Identifier: MIT
// Errors of the engine as exceptions of Python, and signals of Python for the engine.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/numeric/error.h"

namespace gaitsmith::python {

/// Python's gaitsmith.Error, which is a ValueError.
class Fault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The value of a result. @throws Fault with the error's sentence
template <class T>
T Take(Result<T> result) {
  if (!result) throw Fault(result.error().Sentence());
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// A whole number that must lie within limits. @throws Fault
int InRange(const char* name, long long value, long long low, long long high);

/// A callback for work without the interpreter's lock, on the thread that released it: at most ten times a
/// second it looks whether a signal such as Ctrl-C has come. Then it is true, and the caller ends its work
/// and calls ThrowIfStopped with the lock.
class SignalWatch {
 public:
  SignalWatch();
  [[nodiscard]] bool operator()();
  /// @throws what the signal's handler raised, such as KeyboardInterrupt
  void ThrowIfStopped() const;

 private:
  double looked_s_;
  bool stopped_ = false;
};

}  // namespace gaitsmith::python
