// SPDX-License-Identifier: MIT
// Pins: every field of a document, its range and its standard value. In a link a number takes the bits that
// its range needs, and a standard value takes one bit, so a changed range breaks every link. To bless again
// (only by a numbered decision in docs/design.md):
//   tests/golden/bless build/release/shell/gaitsmith build/dev/tests/gaitsmith_tests
#include <catch_amalgamated.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include <vector>

#include "core/document/archive.h"
#include "core/document/json.h"
#include "core/document/schema.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

/// An archive that lists the fields, one per line.
class FieldTable : public Archive {
 public:
  void Real(std::string_view name, float&, float low, float high, float standard) override {
    Line(name) << "real " << RealText(low) << " to " << RealText(high) << ", standard " << RealText(standard);
  }
  void Integer(std::string_view name, int&, int low, int high, int standard) override {
    Line(name) << "integer " << low << " to " << high << ", standard " << standard;
  }
  void Natural(std::string_view name, std::uint32_t&, std::uint32_t standard) override {
    Line(name) << "natural, standard " << standard;
  }
  void Flag(std::string_view name, bool&, bool standard) override {
    Line(name) << "flag, standard " << (standard ? "true" : "false");
  }
  void Text(std::string_view name, std::string&) override { Line(name) << "text"; }
  void Model(std::string_view name, int&) override { Line(name) << "model"; }
  void Hash(std::string_view name, std::optional<std::uint64_t>&) override { Line(name) << "hash"; }
  void Genes(Controller&, const PortCount&) override { Line("genes") << "genes"; }

  [[nodiscard]] std::string Table() const { return out_.str() + "\n"; }

 private:
  std::ostringstream& Line(std::string_view name) {
    out_ << (out_.view().empty() ? "" : "\n") << 'v' << since_.back() << ' ' << paths_.back() << name << ": ";
    return out_;
  }
  void Index(std::string_view name, int&, std::span<const std::string_view> names, int standard) override {
    std::ostringstream& line = Line(name);
    line << "choice of";
    for (const std::string_view choice : names) line << ' ' << choice;
    line << ", standard " << names[static_cast<std::size_t>(standard)];
  }
  bool BeginGroup(std::string_view name) override { return Inside(std::string(name) + "."); }
  void EndGroup() override { paths_.pop_back(); }
  bool BeginList(std::string_view name, std::size_t& size, int most) override {
    Line(name) << "list of at most " << most;
    size = 1;
    return Inside(std::string(name) + "[].");
  }
  void EndList() override { paths_.pop_back(); }
  bool BeginSince(int version) override {
    since_.push_back(version);
    return true;
  }
  void EndSince() override { since_.pop_back(); }
  bool Inside(const std::string& step) {
    paths_.push_back(paths_.back() + step);
    return true;
  }

  std::ostringstream out_;
  std::vector<std::string> paths_ = {""};
  std::vector<int> since_ = {1};  // last: version that added the present field
};

std::string Fields() {
  FieldTable table;
  Document document;
  Describe(table, document);
  return table.Table();
}

}  // namespace

TEST_CASE("golden: every field of a document keeps its name, range and standard", "[document][determinism]") {
  std::istringstream pinned(ReadFile("tests/golden/fields.txt")), found(Fields());
  int fields = 0;
  for (std::string was, is; std::getline(found, is); ++fields) {
    REQUIRE(std::getline(pinned, was));
    CHECK(is == was);
  }
  std::string more;
  CHECK_FALSE(std::getline(pinned, more));
  CHECK(fields > 90);
}

TEST_CASE("figure: what a rod may be is what a document says it may be", "[document][figure]") {
  const Document good = TwoClips();
  const auto agree = [&](float Rod::* field, float low, float high) {
    const float beyond = std::numeric_limits<float>::infinity();
    for (const float value : {low, high, std::nextafter(low, -beyond), std::nextafter(high, beyond)}) {
      CAPTURE(low, high, value);
      Figure figure = good.figure;
      figure.rods[1].*field = value;
      CHECK(Validate(figure).has_value() == (value >= low && value <= high));
    }
  };
  agree(&Rod::length_m, 0.001f, 1000.0f);
  agree(&Rod::mass_kg, 1e-6f, 1e6f);
  agree(&Rod::rest_rad, -6.2831855f, 6.2831855f);
  agree(&Rod::min_rad, -3.1415927f, 0.0f);
  agree(&Rod::max_rad, 0.0f, 3.1415927f);
}

TEST_CASE("bless the fields of a document", "[.bless]") { std::fputs(Fields().c_str(), stdout); }

}  // namespace gaitsmith::test
