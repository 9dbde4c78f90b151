// SPDX-License-Identifier: MIT
#include "shell/catalogue/catalogue.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/control/controller.h"
#include "core/control/sense_table.h"
#include "core/document/json_value.h"
#include "core/document/schema.h"
#include "shell/embedded/embedded.h"
#include "shell/export/exporters.h"
#include "shell/words/algorithm_words.h"
#include "shell/words/control_modes.h"
#include "shell/words/style_words.h"
#include "shell/workspace/arrangement.h"
#include "shell/workspace/panels.h"

namespace gaitsmith::shell {
namespace {

/// A value as JSON writes it.
std::string Json(std::string_view text) { return QuoteJson(text); }
std::string Json(const char* text) { return QuoteJson(text); }
std::string Json(const std::string& text) { return QuoteJson(text); }
std::string Json(bool value) { return value ? "true" : "false"; }
template <class Number>
  requires std::is_arithmetic_v<Number>
std::string Json(Number number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

/// A row of a table: an object, or a name alone.
class Row {
 public:
  template <class T>
  Row& With(std::string_view name, const T& value) {
    members_.emplace_back(name, Json(value));
    return *this;
  }
  static Row Name(std::string_view name) {
    Row row;
    row.alone_ = Json(name);
    return row;
  }

  /// @param space after commas and colons, or empty @param most members, the first ones
  [[nodiscard]] std::string Text(std::string_view space, std::size_t most) const {
    if (!alone_.empty()) return alone_;
    std::string text = "{";
    for (const auto& [name, value] : std::span(members_).first(std::min(most, members_.size()))) {
      if (text.size() > 1) text.append(",").append(space);
      text.append(Json(name)).append(":").append(space).append(value);
    }
    return text + "}";
  }

 private:
  std::vector<std::pair<std::string_view, std::string>> members_;
  std::string alone_;
};

struct Table {
  std::string_view name;
  std::size_t page_members;  // of each row, the first ones, that the page reads; 0: it reads none
  std::vector<Row> rows;
};

template <class Names>
std::vector<Row> NamesOf(const Names& names) {
  std::vector<Row> rows;
  rows.reserve(names.size());
  for (const auto& name : names) rows.push_back(Row::Name(name));
  return rows;
}

std::vector<Row> Algorithms() {
  std::vector<Row> rows;
  for (const Algorithm algorithm : AlgorithmColumn(&AlgorithmRow::algorithm)) {
    const auto i = static_cast<std::size_t>(algorithm);
    rows.push_back(Row()
                       .With("name", kAlgorithmNames[i])
                       .With("label", WordsOf(algorithm).name)
                       .With("title", WordsOf(algorithm).title)
                       .With("refines_one", kRefinesOne[i]));
  }
  return rows;
}

std::vector<Row> Terms() {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < kStyleTable.size(); ++i) {
    const StyleTermRow& row = kStyleTable[i];
    rows.push_back(Row()
                       .With("name", row.name)
                       .With("label", TermTexts()[i].label)
                       .With("unit", row.unit)
                       .With("since", row.since)
                       .With("usual_weight", row.usual_weight)
                       .With("gentle_weight", row.gentle_weight));
  }
  return rows;
}

std::string_view NameOf(SensePer per) {
  return per == SensePer::kActuator ? "actuator" : per == SensePer::kContact ? "contact" : "body";
}

std::vector<Row> Senses() {
  std::vector<Row> rows;
  for (std::size_t kind = 0; kind < kSenseKindNames.size(); ++kind) {
    for (const SenseGroup& group : SenseGroupsOf(static_cast<SenseKind>(kind))) {
      rows.push_back(Row()
                         .With("name", group.name)
                         .With("kind", kSenseKindNames[kind])
                         .With("unit", group.unit)
                         .With("per", NameOf(group.per)));
    }
  }
  return rows;
}

std::vector<Row> ControlModes() {
  std::vector<Row> rows;
  rows.reserve(kControlModes.size());
  for (const ControlModeRow& row : kControlModes) {
    rows.push_back(Row()
                       .With("name", row.name)
                       .With("words", row.words)
                       .With("controller_kind", RowOf(row.kind).name)
                       .With("sense_kind", kSenseKindNames[static_cast<std::size_t>(row.senses)]));
  }
  return rows;
}

/// The groups of all components of the smallest controller of each kind, each name once.
std::vector<Row> GeneGroupRows() {
  std::vector<Row> rows;
  for (const ControllerKindRow& kind : kControllerKinds) {
    const ControllerShape shape(kind.kind, 1, SenseKind::kPhysical, PortCount(1, 1));
    std::set<std::string_view> seen;
    for (int component = 0; component < shape.Components(); ++component) {
      for (const GeneGroup& group : shape.GroupsOf(component)) {
        if (!seen.insert(group.name).second) continue;
        rows.push_back(Row()
                           .With("name", group.name)
                           .With("controller_kind", kind.name)
                           .With("role", kGeneRoleNames[static_cast<std::size_t>(group.role)]));
      }
    }
  }
  return rows;
}

std::vector<Row> Panels() {
  std::vector<Row> rows;
  rows.reserve(kPanels.size());
  for (const PanelRow& row : kPanels) {
    rows.push_back(Row()
                       .With("name", row.id)
                       .With("label", row.label)
                       .With("number", row.Number())
                       .With("tab_on_desk", row.tab_on_desk));
  }
  return rows;
}

std::vector<Row> Exporters() {
  std::vector<Row> rows;
  rows.reserve(std::size(kExporters));
  for (const ExporterRow& row : kExporters) {
    rows.push_back(Row()
                       .With("name", row.id)
                       .With("ending", row.ending)
                       .With("type", row.type)
                       .With("springs", row.springs)
                       .With("group", kExportGroupNames[static_cast<std::size_t>(row.group)])
                       .With("label", row.label)
                       .With("note", row.note));
  }
  return rows;
}

std::vector<Row> LanguageRows() {
  std::vector<Row> rows;
  for (const Language& language : Languages())
    rows.push_back(Row().With("code", language.code).With("name", language.name));
  return rows;
}

std::vector<Table> Tables() {
  return {
      {"algorithms", 2, Algorithms()},
      {"tasks", 0, NamesOf(kTaskNames)},
      {"terms", 1, Terms()},
      {"senses", 0, Senses()},
      {"sense_kinds", 0, NamesOf(kSenseKindNames)},
      {"control_modes", 2, ControlModes()},
      {"controller_kinds", 0, NamesOf(kControllerKindNames)},
      {"panels", 2, Panels()},
      {"locks", 0, NamesOf(kLockedPartNames)},
      {"exporters", 7, Exporters()},
      {"languages", 2, LanguageRows()},
      {"gene_groups", 0, GeneGroupRows()},
  };
}

constexpr std::size_t kAll = 1000;

}  // namespace

std::string CatalogueJson() {
  std::string json = "{\n";
  for (const Table& table : Tables()) {
    if (json.size() > 2) json += ",\n";
    json += "  " + Json(table.name) + ": [";
    for (const Row& row : table.rows)
      json += (json.ends_with('[') ? "\n    " : ",\n    ") + row.Text(" ", kAll);
    json += "\n  ]";
  }
  return json + "\n}\n";
}

std::string CatalogueModule() {
  std::string module = "// SPDX-License-Identifier: MIT\n";
  for (const Table& table : Tables()) {
    if (table.page_members == 0) continue;
    module.append("export const ").append(table.name).append("=[");
    for (const Row& row : table.rows)
      module += (module.ends_with('[') ? "" : ",") + row.Text("", table.page_members);
    module += "];\n";
  }
  return module;
}

}  // namespace gaitsmith::shell
