// SPDX-License-Identifier: MIT
// Parses the words after a command: options with their values, and positional arguments.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/numeric/error.h"

namespace gaitsmith::shell {

class Arguments {
 public:
  /// @param known the command's options that take a value, without dashes
  /// @param flags options without a value
  [[nodiscard]] static Result<Arguments> Parse(std::span<const std::string_view> words,
                                               std::span<const std::string_view> known,
                                               std::span<const std::string_view> flags = {});

  /// For a command without positional arguments.
  [[nodiscard]] static Result<Arguments> ParseOptions(std::span<const std::string_view> words,
                                                      std::span<const std::string_view> known);

  [[nodiscard]] const std::vector<std::string>& Positional() const { return positional_; }
  /// All values given for an option, in order.
  [[nodiscard]] const std::vector<std::string>& All(std::string_view option) const;
  [[nodiscard]] bool Has(std::string_view option) const { return !All(option).empty(); }
  /// The last value given for an option, or a fallback.
  [[nodiscard]] std::string Last(std::string_view option, std::string_view fallback = "") const;
  /// A whole number in [low, high]; the fallback if the option is absent.
  [[nodiscard]] Result<long long> Integer(std::string_view option, long long low, long long high,
                                          long long fallback) const;

 private:
  std::vector<std::string> positional_;
  std::map<std::string, std::vector<std::string>, std::less<>> options_;
};

/// The index of a name, or an error that lists the known names. @param where for the error
[[nodiscard]] Result<int> IndexOf(std::span<const std::string_view> names, std::string_view name,
                                  std::string_view where);

/// The whole text as a whole number in [low, high]. @param what for the error
[[nodiscard]] Result<long long> ParseWhole(std::string_view text, long long low, long long high,
                                           std::string_view what);

/// The whole text as a number. @param what for the error
[[nodiscard]] Result<double> ParseNumber(std::string_view text, std::string_view what);

}  // namespace gaitsmith::shell
