// SPDX-License-Identifier: MIT
// The catalogue is valid JSON with every row of every table, and the page's module is a subset of it. Does
// not pin the rows themselves.
#include "shell/catalogue/catalogue.h"

#include <catch_amalgamated.hpp>
#include <fstream>
#include <iterator>

#include "core/document/json_value.h"
#include "core/rollout/task.h"
#include "core/search/search.h"
#include "shell/export/exporters.h"
#include "shell/workspace/panels.h"

namespace gaitsmith::shell::test {
namespace {

std::vector<std::string> NamesIn(const JsonValue& catalogue, std::string_view table) {
  std::vector<std::string> names;
  const JsonValue* rows = catalogue.Find(table);
  REQUIRE(rows != nullptr);
  names.reserve(rows->items.size());
  for (const JsonValue& row : rows->items)
    names.push_back(row.kind == JsonValue::Kind::kString ? row.text : row.Find("name")->text);
  return names;
}

template <class Table, class Member>
std::vector<std::string> Names(const Table& table, Member member) {
  std::vector<std::string> names;
  names.reserve(std::size(table));
  for (const auto& row : table) names.emplace_back(row.*member);
  return names;
}

std::string Text(const std::string& path) {
  std::ifstream file(std::string(GAITSMITH_SOURCE_DIR "/") + path);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("catalogue: has every row of every table, in order", "[catalogue]") {
  const auto catalogue = ParseJson(CatalogueJson());
  REQUIRE(catalogue);
  CHECK(NamesIn(*catalogue, "algorithms") == Names(kAlgorithms, &AlgorithmRow::name));
  CHECK(NamesIn(*catalogue, "terms") == Names(kStyleTable, &StyleTermRow::name));
  CHECK(NamesIn(*catalogue, "panels") == Names(kPanels, &PanelRow::id));
  CHECK(NamesIn(*catalogue, "exporters") == Names(kExporters, &ExporterRow::id));
  CHECK(NamesIn(*catalogue, "tasks") == std::vector<std::string>(kTaskNames.begin(), kTaskNames.end()));
  CHECK(NamesIn(*catalogue, "senses") == std::vector<std::string>{"angle", "force", "height", "rise", "timer",
                                                                  "angle", "force", "height", "rise", "ahead",
                                                                  "corner"});
  CHECK(catalogue->Find("panels")->items.back().Find("number")->number == 6.0);
}

TEST_CASE("catalogue: the page's module has a list for each table that it reads", "[catalogue]") {
  const std::string module = CatalogueModule();
  CHECK(module.contains("\nexport const algorithms=[{\"name\":\"rgt\",\"label\":\"RG&T\"},"));
  CHECK(module.contains("\nexport const terms=[{\"name\":\"max_cm_height\"},"));
  const ExporterRow& last = kExporters.back();
  CHECK(module.contains(",\"group\":\"programs\",\"label\":" + QuoteJson(last.label) +
                        ",\"note\":" + QuoteJson(last.note) + "}];\n"));
}

TEST_CASE("catalogue: the page's types name each table and member of its module, and no other",
          "[catalogue]") {
  const std::string module = CatalogueModule(), types = Text("web/catalogue/catalogue.d.ts");
  const std::string table = "export const ", member = "readonly ";
  std::vector<std::string> written, typed;
  for (std::size_t at = module.find(table); at != std::string::npos; at = module.find(table, at)) {
    at += table.size();
    const std::size_t equals = module.find('=', at);
    written.push_back(module.substr(at, equals - at) + ":");
    const auto first_row = ParseJson(module.substr(equals + 2, module.find('}', equals) - equals - 1));
    REQUIRE(first_row);
    written.insert(written.end(), first_row->names.begin(), first_row->names.end());
  }
  for (std::size_t at = 0; at < types.size(); ++at) {
    for (const std::string& before : {table, member}) {
      if (types.compare(at, before.size(), before) != 0) continue;
      const std::size_t name = at + before.size(), colon = types.find(':', name);
      if (types[name] != '{') typed.push_back(types.substr(name, colon - name + (before == table ? 1 : 0)));
    }
  }
  CHECK(typed == written);
}

TEST_CASE("catalogue: for each table, a page of the docs has one row per name", "[catalogue]") {
  const auto explains = [](const char* page, const auto& names) {
    const std::string text = Text(std::string("docs/") + page);
    for (const std::string_view name : names) {
      CAPTURE(page, name);
      CHECK(text.contains("\n| `" + std::string(name) + "` |"));
    }
  };
  explains("search.md", kAlgorithmNames);
  explains("style.md", kTaskNames);
  explains("style.md", kStyleTermNames);
  std::vector<std::string> options;
  options.reserve(std::size(kExporters));
  for (const ExporterRow& row : kExporters) options.push_back("--" + std::string(row.id));
  explains("command-line.md", options);
}

TEST_CASE("catalogue: a panel's id is its tab's label in lower case, as docs/embedding.md says",
          "[catalogue]") {
  for (const PanelRow& row : kPanels) {
    std::string label = row.label;
    label[0] = static_cast<char>(label[0] - 'A' + 'a');
    CHECK(row.id == label);
  }
}

}  // namespace gaitsmith::shell::test
