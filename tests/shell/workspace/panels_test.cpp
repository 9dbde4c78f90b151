// SPDX-License-Identifier: MIT
// The panel that a document or link selects by its number. Existing links keep showing the same panel when a
// panel is added. Does not pin how panels look.
#include "shell/workspace/panels.h"

#include <catch_amalgamated.hpp>
#include <vector>

#include "core/document/link.h"
#include "shell/session/commands.h"
#include "shell/session/session.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

std::vector<int> Tabs(std::span<const PanelRow> panels, bool phone) {
  std::vector<int> tabs;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (phone || panels[i].tab_on_desk) tabs.push_back(static_cast<int>(i));
  }
  return tabs;
}

std::string_view Shown(std::span<const PanelRow> panels, bool phone, int number) {
  return panels[static_cast<std::size_t>(NearestPanel(panels, Tabs(panels, phone), number))].id;
}

// By number. On a desk the timeline has no tab, and the nearest one opens.
constexpr std::array<std::string_view, 6> kOnAPhone = {"figure", "controller", "style",
                                                       "search", "lab",        "timeline"};
constexpr std::array<std::string_view, 6> kOnADesk = {"figure", "controller", "style",
                                                      "search", "lab",        "lab"};

}  // namespace

TEST_CASE("panels: existing numbers select the same panels as before", "[panels]") {
  for (int number = 0; number <= kMaxPanelNumber; ++number) {
    CAPTURE(number);
    // Numbers that are not given yet open the last panel.
    const bool known = number < static_cast<int>(kOnAPhone.size());
    CHECK(Shown(kPanels, true, number) ==
          (known ? kOnAPhone[static_cast<std::size_t>(number)] : "keyframes"));
    CHECK(Shown(kPanels, false, number) ==
          (known ? kOnADesk[static_cast<std::size_t>(number)] : "keyframes"));
  }
}

TEST_CASE("panels: the nearest shown panel opens", "[panels]") {
  const int few[] = {IndexOf(Panel::kController), IndexOf(Panel::kSearch)};
  CHECK(NearestPanel(kPanels, few, 0) == few[0]);
  CHECK(NearestPanel(kPanels, few, 2) == few[0]);  // of two equally near, the lower
  CHECK(NearestPanel(kPanels, few, 3) == few[1]);
  CHECK(NearestPanel(kPanels, few, 5) == few[1]);
}

TEST_CASE("panels: adding a panel at any position does not renumber the others", "[panels]") {
  for (std::size_t place = 0; place <= kPanels.size(); ++place) {
    std::vector<PanelRow> more(kPanels.begin(), kPanels.end());
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(place),
                {static_cast<Panel>(7), "notes", "Notes", true, ""});
    CAPTURE(place);
    CHECK(HaveOwnNumbers(more));
    for (int number = 0; number <= 5; ++number) {
      CHECK(Shown(more, true, number) == kOnAPhone[static_cast<std::size_t>(number)]);
      CHECK(Shown(more, false, number) == kOnADesk[static_cast<std::size_t>(number)]);
    }
    CHECK(Shown(more, true, 7) == "notes");
    CHECK(Shown(more, false, 7) == "notes");
  }
  std::vector<PanelRow> twice(kPanels.begin(), kPanels.end());
  twice.push_back(twice.front());
  CHECK_FALSE(HaveOwnNumbers(twice));
}

TEST_CASE("panels: links from before panels had stable numbers open the same panels", "[panels]") {
  constexpr std::array<std::string_view, 6> kLinks = {
      "ARUAAAEwkHojGwAAAAAAhNd-IJHXP8jcAwgB56o", "ARQAAAEwkHojGwAAAAAAeO0HEnn9g8w9IFLXhQ",
      "ARUAAAEwkHojGwAAAAAAlNd-IJHXP8jcA-CASY0", "ARUAAAEwkHojGwAAAAAAnNd-IJHXP8jcAxTAnp4",
      "ARUAAAEwkHojGwAAAAAApNd-IJHXP8jcA9gCuuU", "ARUAAAEwkHojGwAAAAAArNd-IJHXP8jcAyxCbfY"};
  for (std::size_t number = 0; number < kLinks.size(); ++number) {
    CAPTURE(number);
    const auto document = DecodeLink(kLinks[number]);
    REQUIRE(document);
    CHECK(Shown(kPanels, true, document->view.panel) == kOnAPhone[number]);
    CHECK(Shown(kPanels, false, document->view.panel) == kOnADesk[number]);
    CHECK(EncodeLink(*document) == kLinks[number]);
  }
}
TEST_CASE("panels: the command of a panel writes its number", "[panels]") {
  QuietHost host;
  Session session(host);
  for (const PanelRow& row : kPanels) {
    for (const Command& command : CommandsOf(session, true)) {
      if (command.id != std::string("panel/") + row.label) continue;
      command.run();
      CHECK(session.Doc().view.panel == row.Number());
    }
  }
}

}  // namespace gaitsmith::shell::test
