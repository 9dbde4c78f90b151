// SPDX-License-Identifier: MIT
#include "shell/host/script_options.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shell/words/control_modes.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

std::string ApplySearchOptions(const JsonValue& options, Document& document, int& workers) {
  for (std::size_t i = 0; i < options.names.size(); ++i) {
    const std::string& name = options.names[i];
    const JsonValue& value = options.items[i];
    const bool number = value.kind == JsonValue::Kind::kNumber && std::abs(value.number) < 2e9;
    const auto algorithm = std::ranges::find(kAlgorithmNames, value.text);
    if (name == "algorithm" && algorithm != kAlgorithmNames.end()) {
      document.search.algorithm = static_cast<Algorithm>(algorithm - kAlgorithmNames.begin());
    } else if (const auto* mode = std::ranges::find(kControlModes, value.text, &ControlModeRow::name);
               name == "sense" && mode != kControlModes.end()) {
      SetControlMode(document, *mode);
    } else if (name == "evaluations" && number) {
      document.search.evaluations = static_cast<int>(value.number);
    } else if (name == "seed" && number && value.number >= 0.0) {
      document.search.seed = static_cast<std::uint32_t>(value.number);
    } else if (name == "workers" && number && value.number >= 1.0 && value.number <= 64.0) {
      workers = static_cast<int>(value.number);
    } else if (name == "period" && number && std::abs(value.number) < 1e6) {
      document.senses.period_steps = static_cast<int>(std::lround(value.number / static_cast<double>(kStep)));
    } else {
      return "synthesize: unknown option or value: " + name;
    }
  }
  return {};
}

std::string ApplyLabOptions(const JsonValue& options, LabSettings& settings) {
  for (std::size_t i = 0; i < options.names.size(); ++i) {
    const std::string& name = options.names[i];
    const JsonValue& value = options.items[i];
    const bool number = value.kind == JsonValue::Kind::kNumber && value.number == std::floor(value.number);
    const bool small = number && std::abs(value.number) < 2e9;
    if (name == "trials" && small) {
      settings.trials = static_cast<int>(value.number);
    } else if (name == "evaluations" && small) {
      settings.evaluations = static_cast<int>(value.number);
    } else if (name == "firstSeed" && number && value.number >= 0.0 && value.number <= 4294967295.0) {
      settings.first_seed = static_cast<std::uint32_t>(value.number);
    } else if (name == "algorithms" && value.kind == JsonValue::Kind::kArray) {
      settings.chosen.fill(false);
      for (const JsonValue& item : value.items) {
        const auto algorithm = std::ranges::find(kAlgorithmNames, item.text);
        if (algorithm == kAlgorithmNames.end()) return "lab: unknown algorithm: " + item.text;
        settings.chosen[static_cast<std::size_t>(algorithm - kAlgorithmNames.begin())] = true;
      }
    } else {
      return "lab: unknown option or value: " + name;
    }
  }
  return {};
}

std::string ApplyArrangement(const JsonValue& options, Arrangement& arrangement) {
  Arrangement next = arrangement;
  for (std::size_t i = 0; i < options.names.size(); ++i) {
    const std::string& name = options.names[i];
    const JsonValue& value = options.items[i];
    const bool text = value.kind == JsonValue::Kind::kString;
    if (name == "panels" && text) {
      if (const auto wrong = ShowPanels(value.text, next))
        return Tr(
            "panels: “{1}” is not a panel. Choose from figure, controller, style, search, lab, timeline, "
            "all, none",
            *wrong);
    } else if (name == "lock" && text) {
      if (const auto wrong = LockParts(value.text, next))
        return Tr(
            "lock: “{1}” cannot be locked. Choose from figure, controller, style, search, timeline, world, "
            "all, none",
            *wrong);
    } else if (name == "live" && text) {
      if (value.text != "on" && value.text != "off")
        return Tr("live: “{1}” is neither on nor off", value.text);
      next.live = value.text == "on";
    } else {
      return "arrange: unknown option or value: " + name;
    }
  }
  arrangement = next;
  return {};
}

}  // namespace gaitsmith::shell
