// SPDX-License-Identifier: MIT
// A strict JSON reader [RFC 8259]. Ours, because core may use the standard library and Eigen only, and
// because a person who writes a document by hand must be told line and column of what is wrong, without
// exceptions.
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
  std::string text;                // of a string, or a number as it was written
  std::vector<std::string> names;  // of an object's members, unique and in order
  std::vector<JsonValue> items;    // of a list, or of an object's members

  /// The member of this name, or null.
  [[nodiscard]] const JsonValue* Find(std::string_view name) const;
  /// "a number", "an object"...
  [[nodiscard]] const char* KindName() const;
};

/// More members than any object of a document has.
inline constexpr std::size_t kMostMembers = 64;

/// @param most_members of one object: text from a stranger must cost no time
/// @return the value, or a syntax error whose `where` is "line 3, column 14"
[[nodiscard]] Result<JsonValue> ParseJson(std::string_view text, std::size_t most_members = kMostMembers);

/// A string with its quotes and escapes.
[[nodiscard]] std::string QuoteJson(std::string_view text);

}  // namespace gaitsmith
