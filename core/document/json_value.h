// SPDX-License-Identifier: MIT
// A strict JSON reader [RFC 8259]. It is our own because core may only use the standard library and Eigen,
// and because faults in handwritten documents must be reported with line and column, without exceptions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/numeric/error.h"

namespace gaitsmith {

struct JsonValue {
  enum class Kind { kNull, kBool, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  bool boolean = false;
  double number = 0.0;
  std::string text;                // of a string, or of a number as written
  std::vector<std::string> names;  // of an object's members, unique and in order
  std::vector<JsonValue> items;    // of a list, or of an object's members

  /// The member of this name, or null.
  [[nodiscard]] const JsonValue* Find(std::string_view name) const;
  /// "a number", "an object"...
  [[nodiscard]] const char* KindName() const;
};

/// Limit of members per object, above that of any object in a document.
inline constexpr std::size_t kMaxMembers = 64;

/// @param most_members limit per object, so that untrusted text cannot waste time
/// @return the value, or a syntax error whose `where` is "line 3, column 14"
[[nodiscard]] Result<JsonValue> ParseJson(std::string_view text, std::size_t most_members = kMaxMembers);

/// A string with its quotes and escapes.
[[nodiscard]] std::string QuoteJson(std::string_view text);

}  // namespace gaitsmith
