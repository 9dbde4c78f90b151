// SPDX-License-Identifier: MIT
// Base class of all archives: the path to the present field, the first fault found, and the checks of single
// values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith {

class Archive {
 public:
  [[nodiscard]] bool Ok() const { return !error_; }
  [[nodiscard]] const std::optional<Error>& Fault() const { return error_; }

 protected:
  /// Records a fault at a field. Only the first fault is kept.
  void FailAt(std::string_view name, ErrorCode code, std::string what);

  void Enter(std::string_view name);
  void EnterElement(std::size_t index);
  void Leave() { path_.pop_back(); }

  /// Checks of single values, shared by all archives.
  void CheckReal(std::string_view name, float& value, float low, float high);
  void CheckInteger(std::string_view name, std::int64_t value, std::int64_t low, std::int64_t high);
  void CheckModel(std::string_view name, std::int64_t model);
  void CheckText(std::string_view name, const std::string& text);
  void CheckCount(std::string_view name, std::size_t count, std::size_t most);

 private:
  [[nodiscard]] std::string PathOf(std::string_view name) const;

  std::vector<std::string> path_;
  std::optional<Error> error_;
};

/// The shortest text that reads back as the same float.
[[nodiscard]] std::string RealText(float value);

/// Checks everything that concerns more than one field: the figure is a tree, and the controllers of clips
/// and the endpoints of pushes exist.
[[nodiscard]] Result<void> CheckReferences(const Document&);

}  // namespace gaitsmith
