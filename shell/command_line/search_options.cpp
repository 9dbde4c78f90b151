// SPDX-License-Identifier: MIT
#include "shell/command_line/search_options.h"

#include <algorithm>
#include <cmath>

#include "core/document/archive.h"
#include "core/document/schema.h"
#include "shell/command_line/arguments.h"

namespace gaitsmith::shell {

namespace {

/// Visits the settings and changes the field with a given name. The seed, a natural number, has its own
/// option.
class OptionArchive : public Archive {
 public:
  OptionArchive(std::string name, std::string value) : name_(std::move(name)), value_(std::move(value)) {}
  [[nodiscard]] bool Found() const { return found_; }
  [[nodiscard]] const std::string& Names() const { return names_; }

  void Real(std::string_view name, float& field, float low, float high, float) override {
    if (!IsMeant(name)) return;
    const auto number = ParseNumber(value_, "");
    if (!number) return FailAt(name, number.error().code, number.error().what);
    field = static_cast<float>(std::clamp(*number, -1e30, 1e30));
    CheckReal(name, field, low, high);
  }
  void Integer(std::string_view name, int& field, int low, int high, int) override {
    if (!IsMeant(name)) return;
    const auto number = ParseNumber(value_, "");
    if (!number || *number != std::floor(*number) || std::abs(*number) > 9e15) {
      return FailAt(name, ErrorCode::kSyntax, "must be a whole number, is \"" + value_ + "\"");
    }
    CheckInteger(name, static_cast<std::int64_t>(*number), low, high);
    if (Ok()) field = static_cast<int>(*number);
  }

 private:
  void Index(std::string_view name, int& index, std::span<const std::string_view> names, int) override {
    if (!IsMeant(name)) return;
    const auto found = std::ranges::find(names, value_);
    if (found != names.end()) {
      index = static_cast<int>(found - names.begin());
      return;
    }
    std::string known;
    for (const std::string_view option : names) known += (known.empty() ? "" : ", ") + std::string(option);
    FailAt(name, ErrorCode::kUnknownName, "\"" + value_ + "\" is unknown: choose from " + known);
  }
  bool BeginGroup(std::string_view name) override {
    prefix_ = std::string(name) + ".";
    return true;
  }
  void EndGroup() override { prefix_.clear(); }
  bool BeginList(std::string_view, std::size_t&, int) override { return false; }  // no option holds a list
  bool IsMeant(std::string_view name) {
    // These have their own options.
    if (prefix_.empty() &&
        (name == "algorithm" || name == "evaluations" || name == "start" || name == "in_place_of"))
      return false;
    const std::string full = prefix_ + std::string(name);
    names_ += (names_.empty() ? "" : ", ") + full;
    if (full != name_) return false;
    found_ = true;
    return true;
  }

  std::string name_, value_, prefix_, names_;
  bool found_ = false;
};

}  // namespace

Result<void> SetSearchOption(const std::string& option, SearchSettings& search) {
  const auto equals = option.find('=');
  const std::string name = option.substr(0, equals);
  OptionArchive archive(name, equals == std::string::npos ? "" : option.substr(equals + 1));
  Describe(archive, search);
  if (!archive.Found()) {
    return Fail(ErrorCode::kUnknownName, "--search-option",
                "\"" + name + "\" is unknown: choose from " + archive.Names());
  }
  if (archive.Ok()) return {};
  return Fail(archive.Fault()->code, "--search-option " + name, archive.Fault()->what);
}

}  // namespace gaitsmith::shell
