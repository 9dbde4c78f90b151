// SPDX-License-Identifier: MIT
#include "shell/command_line/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gaitsmith::shell {

Result<Arguments> Arguments::Parse(std::span<const std::string_view> words,
                                   std::span<const std::string_view> known,
                                   std::span<const std::string_view> flags) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      arguments.positional_.emplace_back(words[i]);
      continue;
    }
    std::string_view option = words[i].substr(2);
    const auto equals = option.find('=');
    const std::string_view name = option.substr(0, equals);
    if (std::ranges::find(flags, name) != flags.end()) {
      if (equals != std::string_view::npos) {
        return Fail(ErrorCode::kSyntax, "--" + std::string(name), "takes no value");
      }
      arguments.options_[std::string(name)].emplace_back();
      continue;
    }
    if (std::ranges::find(known, name) == known.end()) {
      return Fail(ErrorCode::kUnknownName, "--" + std::string(name), "this command has no such option");
    }
    if (equals != std::string_view::npos) {
      arguments.options_[std::string(name)].emplace_back(option.substr(equals + 1));
    } else if (i + 1 < words.size()) {
      arguments.options_[std::string(name)].emplace_back(words[++i]);
    } else {
      return Fail(ErrorCode::kMissing, "--" + std::string(name), "needs a value");
    }
  }
  return arguments;
}

Result<Arguments> Arguments::ParseOptions(std::span<const std::string_view> words,
                                          std::span<const std::string_view> known) {
  auto arguments = Parse(words, known);
  if (arguments && !arguments->Positional().empty())
    return Fail(ErrorCode::kSyntax, arguments->Positional()[0], "does not belong here");
  return arguments;
}

const std::vector<std::string>& Arguments::All(std::string_view option) const {
  static const std::vector<std::string> kNone;
  const auto found = options_.find(option);
  return found == options_.end() ? kNone : found->second;
}

std::string Arguments::Last(std::string_view option, std::string_view fallback) const {
  return Has(option) ? All(option).back() : std::string(fallback);
}

Result<long long> Arguments::Integer(std::string_view option, long long low, long long high,
                                     long long fallback) const {
  if (!Has(option)) return fallback;
  return ParseWhole(All(option).back(), low, high, "--" + std::string(option));
}

Result<long long> ParseWhole(std::string_view text, long long low, long long high, std::string_view what) {
  long long value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || end != text.data() + text.size() || value < low || value > high) {
    return Fail(ErrorCode::kOutOfRange, std::string(what),
                "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
                    ", is \"" + std::string(text) + "\"");
  }
  return value;
}

Result<int> IndexOf(std::span<const std::string_view> names, std::string_view name, std::string_view where) {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  std::string known;
  for (const std::string_view option : names) known += (known.empty() ? "" : ", ") + std::string(option);
  return Fail(ErrorCode::kUnknownName, std::string(where),
              "\"" + std::string(name) + "\" is unknown: choose from " + known);
}

Result<double> ParseNumber(std::string_view text, std::string_view what) {
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return Fail(ErrorCode::kSyntax, std::string(what), "must be a number, is \"" + std::string(text) + "\"");
  }
  return value;
}

}  // namespace gaitsmith::shell
