// SPDX-License-Identifier: MIT
// Walks a document and fills it from JSON, checking everything. Only for json.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "core/document/archive.h"
#include "core/document/json_value.h"
#include "core/document/schema.h"

namespace gaitsmith {

class JsonReader : public Archive {
 public:
  explicit JsonReader(const JsonValue& root) { Open(root); }

  void Real(std::string_view name, float& value, float low, float high, float standard) override {
    value = standard;
    const JsonValue* given = Get(name, JsonValue::Kind::kNumber);
    if (given == nullptr) return;
    if (std::abs(given->number) > 3.4e38) return FailAt(name, ErrorCode::kOutOfRange, "is too large");
    value = static_cast<float>(given->number);
    CheckReal(name, value, low, high);
  }
  void Integer(std::string_view name, int& value, int low, int high, int standard) override {
    value = standard;
    std::int64_t wide = 0;
    if (Whole(name, wide, low, high)) value = static_cast<int>(wide);
  }
  void Model(std::string_view name, int& model) override {
    std::int64_t wide = 1;
    Whole(name, wide, 0, 1'000'000);
    if (Ok()) CheckModel(name, wide);
    if (Ok()) model = static_cast<int>(wide);
  }
  void Natural(std::string_view name, std::uint32_t& value, std::uint32_t standard) override {
    value = standard;
    std::int64_t wide = 0;
    if (Whole(name, wide, 0, 0xffffffff)) value = static_cast<std::uint32_t>(wide);
  }
  void Flag(std::string_view name, bool& value, bool standard) override {
    const JsonValue* given = Get(name, JsonValue::Kind::kBool);
    value = given == nullptr ? standard : given->boolean;
  }
  void Refuse(std::string_view name, const char* why) override { FailAt(name, ErrorCode::kStructure, why); }
  void Text(std::string_view name, std::string& text) override {
    text.clear();
    const JsonValue* given = Get(name, JsonValue::Kind::kString);
    if (given == nullptr) return;
    text = given->text;
    CheckText(name, text);
  }
  void Hash(std::string_view name, std::optional<std::uint64_t>& hash) override {
    hash.reset();
    const JsonValue* given = Get(name, JsonValue::Kind::kString);
    if (given == nullptr) return;
    std::uint64_t value = 0;
    bool good = given->text.size() == 16;
    for (const char c : given->text) {
      const auto digit = std::string_view("0123456789abcdef").find(c);
      good = good && digit != std::string_view::npos;
      value = value << 4 | (digit & 15u);
    }
    if (!good) return FailAt(name, ErrorCode::kSyntax, "must be 16 hexadecimal digits");
    hash = value;
  }
  void Genes(Controller& controller, const PortCount& ports) override {
    const std::string_view list = RowOf(controller.kind).components;
    const JsonValue* given = Get(list, JsonValue::Kind::kArray);
    if (!Ok()) return;
    if (ports.actuators < 0) return FailAt(list, ErrorCode::kStructure, "the figure has no rods");
    // Components whose number people do not choose, such as a network's actuators.
    const int outside = ControllerShape(controller.kind, 1, controller.senses.kind, ports).Components() - 1;
    const int least = 1 + outside;
    const int most = kMaxRules + outside;
    if (given == nullptr || std::cmp_less(given->items.size(), least) ||
        std::cmp_greater(given->items.size(), most)) {
      return FailAt(list, ErrorCode::kOutOfRange,
                    "there must be " + std::to_string(least) + " to " + std::to_string(most) +
                        std::string(RowOf(controller.kind).count_note));
    }
    controller.rules = static_cast<int>(given->items.size()) - outside;
    const ControllerShape shape = controller.Shape(ports);
    controller.genes.assign(shape.Genes(), 0);
    Enter(list);
    for (std::size_t i = 0; i < given->items.size() && Ok(); ++i) {
      EnterElement(i);
      const JsonValue& item = given->items[i];
      if (item.kind != JsonValue::Kind::kObject) {
        FailAt("", ErrorCode::kSyntax, std::string("must be an object, is ") + item.KindName());
      } else {
        Open(item);
        for (const GeneGroup& group : shape.GroupsOf(static_cast<int>(i)))
          Component(group, controller, ports);
        Close();
      }
      Leave();
    }
    Leave();
  }
  void Finish() { Close(); }

 private:
  void Index(std::string_view name, int& index, std::span<const std::string_view> names,
             int standard) override {
    index = standard;
    const JsonValue* given = Get(name, JsonValue::Kind::kString);
    if (given == nullptr) return;
    const auto found = std::ranges::find(names, given->text);
    if (found == names.end()) {
      std::string known;
      for (const std::string_view option : names) known += (known.empty() ? "" : ", ") + std::string(option);
      return FailAt(name, ErrorCode::kUnknownName,
                    "\"" + given->text + "\" is unknown: choose from " + known);
    }
    index = static_cast<int>(found - names.begin());
  }
  bool BeginGroup(std::string_view name) override {
    const JsonValue* given = Get(name, JsonValue::Kind::kObject);
    if (!Ok()) return false;
    Enter(name);
    Open(given == nullptr ? Nothing() : *given);
    return true;
  }
  void EndGroup() override {
    Close();
    Leave();
  }
  [[nodiscard]] bool Reads() const override { return true; }
  bool BeginList(std::string_view name, std::size_t& size, int most) override {
    const JsonValue* given = Get(name, JsonValue::Kind::kArray);
    size = given == nullptr ? 0 : given->items.size();
    CheckCount(name, size, static_cast<std::size_t>(most));
    Enter(name);
    Open(given == nullptr ? Nothing() : *given);
    return true;
  }
  bool BeginItem(std::size_t index) override {
    EnterElement(index);
    const JsonValue& item = open_.back().object->items[index];
    if (item.kind == JsonValue::Kind::kObject) {
      Open(item);
      return true;
    }
    FailAt("", ErrorCode::kSyntax, std::string("must be an object, is ") + item.KindName());
    Leave();
    return false;
  }
  void EndItem() override {
    Close();
    Leave();
  }
  void EndList() override {
    open_.pop_back();
    Leave();
  }
  void Component(const GeneGroup& group, Controller& controller, const PortCount& ports) {
    const std::span<Gene> genes = group.Of(controller.genes);
    if (group.role == GeneRole::kNumber) return OneGene(group.name, genes.front());
    if (group.role == GeneRole::kList) {
      GeneList(group.name, genes, true);
      return;
    }
    for (std::size_t i = 1; i < genes.size(); i += 2) genes[i] = kGeneMax;
    Group(group.name, [&] {
      for (std::size_t i = 0; i < genes.size(); i += 2) {
        const std::string name = SenseName(controller.senses.kind, ports, static_cast<int>(i / 2));
        Gene interval[2] = {0, kGeneMax};
        if (!GeneList(name, interval, false)) continue;
        if (interval[0] > interval[1]) return FailAt(name, ErrorCode::kOutOfRange, "ends before it begins");
        std::ranges::copy(interval, &genes[i]);
      }
    });
  }

  void OneGene(std::string_view name, Gene& gene) {
    std::int64_t value = 0;
    if (!Whole(name, value, 0, kGeneMax) && Ok()) FailAt(name, ErrorCode::kMissing, "is missing");
    gene = static_cast<Gene>(value);
  }
  /// Reads genes.size() genes. @return whether they were present
  bool GeneList(std::string_view name, std::span<Gene> genes, bool required) {
    const JsonValue* given = Get(name, JsonValue::Kind::kArray);
    if (given == nullptr) {
      if (required && Ok()) FailAt(name, ErrorCode::kMissing, "is missing");
      return false;
    }
    if (given->items.size() != genes.size()) {
      FailAt(
          name, ErrorCode::kStructure,
          "needs " + std::to_string(genes.size()) + " numbers, has " + std::to_string(given->items.size()));
      return false;
    }
    for (std::size_t i = 0; i < genes.size(); ++i) {
      const double number = given->items[i].number;
      if (given->items[i].kind != JsonValue::Kind::kNumber || number != std::floor(number) || number < 0 ||
          number > kGeneMax) {
        FailAt(name, ErrorCode::kOutOfRange, "must hold whole numbers from 0 to 65535");
        return false;
      }
      genes[i] = static_cast<Gene>(number);
    }
    return true;
  }

  bool Whole(std::string_view name, std::int64_t& value, std::int64_t low, std::int64_t high) {
    const JsonValue* given = Get(name, JsonValue::Kind::kNumber);
    if (given == nullptr) return false;
    if (given->number != std::floor(given->number) || std::abs(given->number) > 9e15) {
      FailAt(name, ErrorCode::kSyntax, "must be a whole number, is " + given->text);
      return false;
    }
    value = static_cast<std::int64_t>(given->number);
    CheckInteger(name, value, low, high);
    return Ok();
  }

  const JsonValue* Get(std::string_view name, JsonValue::Kind kind) {
    if (!Ok()) return nullptr;
    const JsonValue* value = open_.back().object->Find(name);
    if (value == nullptr) return nullptr;
    open_.back().asked.push_back(value);
    if (value->kind == kind) return value;
    FailAt(name, ErrorCode::kSyntax,
           std::string("must be ") + OfKind(kind).KindName() + ", is " + value->KindName());
    return nullptr;
  }

  static const JsonValue& Nothing() {
    static const JsonValue kNothing = OfKind(JsonValue::Kind::kObject);
    return kNothing;
  }
  static JsonValue OfKind(JsonValue::Kind kind) {
    JsonValue value;
    value.kind = kind;
    return value;
  }

  void Open(const JsonValue& object) { open_.push_back({&object, {}}); }
  /// Every member must have been read. A member that was not read is an unknown field.
  void Close() {
    const Level level = std::move(open_.back());
    open_.pop_back();
    if (!Ok()) return;
    for (std::size_t i = 0; i < level.object->names.size(); ++i) {
      if (std::ranges::find(level.asked, &level.object->items[i]) == level.asked.end()) {
        return FailAt(level.object->names[i], ErrorCode::kUnknownName, "there is no such field");
      }
    }
  }

  struct Level {
    const JsonValue* object;
    std::vector<const JsonValue*> asked;
  };
  std::vector<Level> open_;
};

}  // namespace gaitsmith
