// SPDX-License-Identifier: MIT
// The words after a command: options with values, and what is left.
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
  /// @param known options this command has, without dashes, that take a value
  /// @param flags those that take none
  [[nodiscard]] static Result<Arguments> Parse(std::span<const std::string_view> words,
                                               std::span<const std::string_view> known,
                                               std::span<const std::string_view> flags = {});

  /// Of a command that takes options alone.
  [[nodiscard]] static Result<Arguments> ParseOptions(std::span<const std::string_view> words,
                                                      std::span<const std::string_view> known);

  [[nodiscard]] const std::vector<std::string>& Positional() const { return positional_; }
  /// All values given for an option, in order.
  [[nodiscard]] const std::vector<std::string>& All(std::string_view option) const;
  [[nodiscard]] bool Has(std::string_view option) const { return !All(option).empty(); }
  /// The last value given for an option, or a fallback.
  [[nodiscard]] std::string Last(std::string_view option, std::string_view fallback = "") const;
  /// A whole number in a range; the fallback when the option is absent.
  [[nodiscard]] Result<long long> Integer(std::string_view option, long long low, long long high,
                                          long long fallback) const;

 private:
  std::vector<std::string> positional_;
  std::map<std::string, std::vector<std::string>, std::less<>> options_;
};

/// The place of a name among those that are known, or a sentence that lists them.
[[nodiscard]] Result<int> IndexOf(std::span<const std::string_view> names, std::string_view name,
                                  std::string_view where);

/// The whole text as a number, or what is wrong with it.
[[nodiscard]] Result<double> ParseNumber(std::string_view text, std::string_view what);

}  // namespace gaitsmith::shell
