// SPDX-License-Identifier: MIT
// Puts JSON together, part by part. Numbers have 9 significant digits, which give back the same float.
#pragma once

#include <string>
#include <string_view>

#include "core/document/json_value.h"
#include "shell/export/number_text.h"

namespace gaitsmith::shell {

/// An object's members, or the elements of a list, with commas between them.
class JsonParts {
 public:
  void Add(const std::string& text) { text_ += (text_.empty() ? "" : separator_) + text; }
  void AddJson(std::string_view name, const std::string& json) { Add(QuoteJson(name) + ": " + json); }
  void Add(std::string_view name, float value) { AddJson(name, Digits(static_cast<double>(value), 9)); }
  void Add(std::string_view name, int value) { AddJson(name, std::to_string(value)); }
  void Add(std::string_view name, std::string_view word) { AddJson(name, QuoteJson(word)); }

  [[nodiscard]] std::string Object() const { return "{" + text_ + "}"; }
  [[nodiscard]] std::string List() const { return "[" + text_ + "]"; }
  /// Between lines of their own.
  [[nodiscard]] std::string ObjectOfLines() const { return "{\n" + text_ + "\n}"; }
  [[nodiscard]] std::string ListOfLines() const { return "[\n" + text_ + "\n]"; }

  /// A part in each line.
  static JsonParts Lines() {
    JsonParts parts;
    parts.separator_ = ",\n";
    return parts;
  }

 private:
  std::string text_, separator_ = ", ";
};

}  // namespace gaitsmith::shell
