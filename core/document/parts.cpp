// SPDX-License-Identifier: MIT
#include "core/document/parts.h"

#include <array>
#include <bit>

#include "core/document/schema.h"

namespace gaitsmith {

namespace {

// The part of a document that a field belongs to. A row without `field` covers all fields of a group, except
// those that have their own row.
struct FieldRow {
  std::string_view name;   // of a field or a group of the document
  std::string_view field;  // inside the group, or empty
  Part part;
};
constexpr auto kFieldRows = std::to_array<FieldRow>({
    {"title", "", Part::kTitle},
    {"model", "", Part::kModel},
    {"figure", "", Part::kFigure},
    {"drawn", "", Part::kFigure},
    {"environment", "", Part::kEnvironment},
    {"start", "", Part::kStart},
    {"pushes", "", Part::kPushes},
    {"task", "", Part::kGoal},
    {"task", "duration_steps", Part::kTaskLength},
    {"senses", "", Part::kSought},
    {"rules", "", Part::kSought},
    {"kind", "", Part::kSought},
    {"search", "", Part::kSearch},
    {"search", "start", Part::kSearchStart},
    {"search", "in_place_of", Part::kTakeover},
    {"search", "handovers", Part::kTakeover},
    {"controllers", "", Part::kControllers},
    {"timeline", "", Part::kTimeline},
    {"duration_steps", "", Part::kDuration},
    {"plan", "", Part::kPlan},
    {"view", "", Part::kView},
    {"lineage", "", Part::kLineage},
    {"hash", "", Part::kHash},
});

// Null if the field has no row. parts_test.cpp fails if a field of the schema has none.
const FieldRow* FieldRowOf(std::string_view name, std::string_view field) {
  const FieldRow* found = nullptr;
  for (const FieldRow& row : kFieldRows) {
    if (row.name != name) continue;
    if (row.field == field) return &row;
    if (row.field.empty()) found = &row;
  }
  return found;
}

// The values of each part, in the order of its fields. Equal where both encodings would be.
using Values = std::array<std::vector<std::uint64_t>, kPartCount>;

// Takes the values of the wanted parts out of a document, or puts them into one.
class PartArchive : public Archive {
 public:
  PartArchive(Parts wanted, Values& values, bool filling)
      : wanted_(wanted), values_(values), filling_(filling) {}

  void Real(std::string_view name, float& value, float, float, float standard) override {
    // -0 is not written where the standard is 0.
    const float written = value == standard ? standard : value;
    if (!Enters(name)) return;
    value = std::bit_cast<float>(static_cast<std::uint32_t>(Pass(std::bit_cast<std::uint32_t>(written))));
  }
  void Integer(std::string_view name, int& value, int, int, int) override { Whole(name, value); }
  void Model(std::string_view name, int& model) override { Whole(name, model); }
  void Natural(std::string_view name, std::uint32_t& value, std::uint32_t) override { Whole(name, value); }
  void Flag(std::string_view name, bool& value, bool) override { Whole(name, value); }
  void Text(std::string_view name, std::string& text) override {
    if (!Enters(name)) return;
    text.resize(PassSize(text.size()));
    for (char& c : text) c = static_cast<char>(Pass(static_cast<unsigned char>(c)));
  }
  void Hash(std::string_view name, std::optional<std::uint64_t>& hash) override {
    if (!Enters(name)) return;
    const bool given = Pass(hash.has_value() ? 1 : 0) != 0;
    const std::uint64_t value = Pass(hash.value_or(0));
    hash = given ? std::optional(value) : std::nullopt;
  }
  void Genes(Controller& controller, const PortCount&) override {
    controller.rules = static_cast<int>(Pass(static_cast<std::uint64_t>(controller.rules)));
    controller.genes.resize(PassSize(controller.genes.size()));
    for (Gene& gene : controller.genes) gene = static_cast<Gene>(Pass(gene));
  }

 private:
  void Index(std::string_view name, int& index, std::span<const std::string_view>, int) override {
    Whole(name, index);
  }
  bool BeginGroup(std::string_view name) override {
    if (depth_++ == 0) group_ = name;
    return true;
  }
  void EndGroup() override { --depth_; }
  [[nodiscard]] bool Reads() const override { return filling_; }
  bool BeginList(std::string_view name, std::size_t& size, int) override {
    if (lists_ == 0 && !Enters(name)) return false;
    ++lists_;
    size = PassSize(size);
    return true;
  }
  void EndList() override { --lists_; }

  // Whether a field belongs to a wanted part. If so, its part becomes the present one. Fields inside a list
  // belong to the part of the list.
  bool Enters(std::string_view name) {
    if (lists_ > 0) return true;
    const FieldRow* row =
        depth_ == 0 ? FieldRowOf(name, "") : FieldRowOf(group_, depth_ == 1 ? name : std::string_view());
    if (row == nullptr || !wanted_.HasAny(row->part)) return false;
    part_ = static_cast<std::size_t>(row->part);
    return true;
  }
  template <class Value>
  void Whole(std::string_view name, Value& value) {
    if (Enters(name)) value = static_cast<Value>(Pass(static_cast<std::uint64_t>(value)));
  }
  std::uint64_t Pass(std::uint64_t value) {
    if (filling_) return values_[part_][next_[part_]++];
    values_[part_].push_back(value);
    return value;
  }

  std::size_t PassSize(std::size_t size) { return static_cast<std::size_t>(Pass(size)); }

  Parts wanted_;
  Values& values_;
  bool filling_;
  std::array<std::size_t, kPartCount> next_{};  // value to put in
  std::string_view group_;                      // the outermost one
  int depth_ = 0;
  int lists_ = 0;  // around the present field
  std::size_t part_ = 0;
};

Values ValuesOf(const Document& document, Parts wanted) {
  Values values;
  Document copy = document;  // an archive may change what it walks
  PartArchive archive(wanted, values, false);
  Describe(archive, copy);
  return values;
}

}  // namespace

Parts DifferingParts(const Document& a, const Document& b, Parts among) {
  const Values in_a = ValuesOf(a, among), in_b = ValuesOf(b, among);
  Parts differing({});
  for (int i = 0; i < kPartCount; ++i) {
    if (in_a[static_cast<std::size_t>(i)] != in_b[static_cast<std::size_t>(i)])
      differing = {differing, static_cast<Part>(i)};
  }
  return differing;
}

bool SameParts(const Document& a, const Document& b, Parts parts) {
  return DifferingParts(a, b, parts).Empty();
}

void CopyParts(const Document& from, Parts parts, Document& to) {
  Values values = ValuesOf(from, parts);
  PartArchive archive(parts, values, true);
  Describe(archive, to);
}

bool SameBehaviour(const Controller& a, const Controller& b) { return SameShape(a, b) && a.genes == b.genes; }

}  // namespace gaitsmith
