// SPDX-License-Identifier: MIT
#include "core/document/json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/archive.h"
#include "core/document/json_value.h"
#include "core/document/schema.h"

namespace gaitsmith {

namespace {

class JsonWriter : public Archive {
 public:
  void Real(std::string_view name, float& value, float, float, float standard) {
    Note(value == standard);
    Field(name, RealText(value));
  }
  void Integer(std::string_view name, int& value, int, int, int standard) {
    Note(value == standard);
    Field(name, std::to_string(value));
  }
  void Model(std::string_view name, int& model) { Field(name, std::to_string(model)); }
  void Natural(std::string_view name, std::uint32_t& value, std::uint32_t standard) {
    Note(value == standard);
    Field(name, std::to_string(value));
  }
  void Flag(std::string_view name, bool& value, bool standard) {
    Note(value == standard);
    Field(name, value ? "true" : "false");
  }
  template <class Enum, class Names>
  void Choice(std::string_view name, Enum& value, const Names& names, Enum standard) {
    Note(value == standard);
    Field(name, QuoteJson(names[static_cast<std::size_t>(value)]));
  }
  void Text(std::string_view name, std::string& text) {
    Note(text.empty());
    Field(name, QuoteJson(text));
  }
  /// Fields that came later are written only when one of them has a value of its own.
  template <class Fields>
  void Since(int, Fields fields) {
    const std::size_t size = out_.size();
    const bool first = first_;
    const bool outside = std::exchange(all_standard_, true);
    fields();
    if (all_standard_) {
      out_.resize(size);
      first_ = first;
    }
    all_standard_ = all_standard_ && outside;
  }
  template <class Fields>
  void Group(std::string_view name, Fields fields) {
    Field(name, "");
    Nested('{', '}', fields);
  }
  template <class Item, class Fields>
  void List(std::string_view name, std::vector<Item>& list, int, Fields fields) {
    Field(name, "");
    Note(list.empty());
    if (list.empty()) {
      out_ += "[]";
      return;
    }
    Nested('[', ']', [&] {
      for (Item& item : list) {
        Separate();
        Nested('{', '}', [&] { fields(item); });
      }
    });
  }
  void Hash(std::string_view name, std::optional<std::uint64_t>& hash) {
    Note(!hash);
    if (hash) Field(name, QuoteJson(HashText(*hash)));
  }
  void Rules(Controller& controller, int rods) {
    const BankShape shape(controller.rules, controller.senses.kind, rods);
    Field("rules", "");
    Nested('[', ']', [&] {
      for (int rule = 0; rule < shape.rules; ++rule) Rule(controller, shape, rods, rule);
    });
  }
  template <class Fields>
  std::string Whole(Fields fields) {
    Nested('{', '}', fields);
    return out_ + "\n";
  }

 private:
  void Rule(const Controller& controller, const BankShape& shape, int rods, int rule) {
    Separate();
    std::string when, pose;
    for (int sense = 0; sense < shape.senses; ++sense) {
      if (!shape.Cares(controller.genes, rule, sense)) continue;
      when += (when.empty() ? "" : ", ") + QuoteJson(SenseName(controller.senses.kind, rods, sense)) + ": [" +
              std::to_string(controller.genes[shape.Low(rule, sense)]) + ", " +
              std::to_string(controller.genes[shape.High(rule, sense)]) + "]";
    }
    for (int joint = 0; joint < shape.joints; ++joint) {
      pose += (joint == 0 ? "" : ", ") + std::to_string(controller.genes[shape.Target(rule, joint)]);
    }
    out_ += "{\"when\": {" + when + "}, \"pose\": [" + pose +
            "], \"tau\": " + std::to_string(controller.genes[shape.Tau(rule)]) + "}";
  }
  void Separate() {
    if (!first_) out_ += ",";
    first_ = false;
    out_ += "\n" + std::string(static_cast<std::size_t>(depth_) * 2, ' ');
  }
  void Field(std::string_view name, const std::string& value) {
    Separate();
    out_ += QuoteJson(name) + ": " + value;
  }
  template <class Fields>
  void Nested(char open, char close, Fields fields) {
    out_ += open;
    ++depth_;
    first_ = true;
    fields();
    first_ = false;
    --depth_;
    out_ += "\n" + std::string(static_cast<std::size_t>(depth_) * 2, ' ') + close;
  }

  void Note(bool standard) { all_standard_ = all_standard_ && standard; }

  std::string out_;
  bool all_standard_ = true;  // since the innermost Since began
  int depth_ = 0;
  bool first_ = true;
};

class JsonReader : public Archive {
 public:
  explicit JsonReader(const JsonValue& root) { Open(root); }

  void Real(std::string_view name, float& value, float low, float high, float standard) {
    value = standard;
    const JsonValue* given = Get(name, JsonValue::Kind::kNumber);
    if (given == nullptr) return;
    if (std::abs(given->number) > 3.4e38) return FailAt(name, ErrorCode::kOutOfRange, "is too large");
    value = static_cast<float>(given->number);
    CheckReal(name, value, low, high);
  }
  void Integer(std::string_view name, int& value, int low, int high, int standard) {
    value = standard;
    std::int64_t wide = 0;
    if (Whole(name, wide, low, high)) value = static_cast<int>(wide);
  }
  void Model(std::string_view name, int& model) {
    std::int64_t wide = 1;
    Whole(name, wide, 0, 1'000'000);
    if (Ok()) CheckModel(name, wide);
    if (Ok()) model = static_cast<int>(wide);
  }
  void Natural(std::string_view name, std::uint32_t& value, std::uint32_t standard) {
    value = standard;
    std::int64_t wide = 0;
    if (Whole(name, wide, 0, 0xffffffff)) value = static_cast<std::uint32_t>(wide);
  }
  void Flag(std::string_view name, bool& value, bool standard) {
    const JsonValue* given = Get(name, JsonValue::Kind::kBool);
    value = given == nullptr ? standard : given->boolean;
  }
  template <class Enum, class Names>
  void Choice(std::string_view name, Enum& value, const Names& names, Enum standard) {
    value = standard;
    const JsonValue* given = Get(name, JsonValue::Kind::kString);
    if (given == nullptr) return;
    const auto found = std::ranges::find(names, given->text);
    if (found == names.end()) {
      std::string known;
      for (const std::string_view option : names) known += (known.empty() ? "" : ", ") + std::string(option);
      return FailAt(name, ErrorCode::kUnknownName,
                    "\"" + given->text + "\" is not known; choose from " + known);
    }
    value = static_cast<Enum>(found - names.begin());
  }
  void Text(std::string_view name, std::string& text) {
    text.clear();
    const JsonValue* given = Get(name, JsonValue::Kind::kString);
    if (given == nullptr) return;
    text = given->text;
    CheckText(name, text);
  }
  template <class Fields>
  void Group(std::string_view name, Fields fields) {
    static const JsonValue kEmpty = OfKind(JsonValue::Kind::kObject);
    const JsonValue* given = Get(name, JsonValue::Kind::kObject);
    if (!Ok()) return;
    Enter(name);
    Open(given == nullptr ? kEmpty : *given);
    fields();
    Close();
    Leave();
  }
  template <class Item, class Fields>
  void List(std::string_view name, std::vector<Item>& list, int most, Fields fields) {
    list.clear();
    const JsonValue* given = Get(name, JsonValue::Kind::kArray);
    if (given == nullptr) return;
    CheckCount(name, given->items.size(), static_cast<std::size_t>(most));
    Enter(name);
    for (std::size_t i = 0; i < given->items.size() && Ok(); ++i) {
      EnterElement(i);
      if (given->items[i].kind != JsonValue::Kind::kObject) {
        FailAt("", ErrorCode::kSyntax, std::string("must be an object, is ") + given->items[i].KindName());
      } else {
        Open(given->items[i]);
        fields(list.emplace_back());
        Close();
      }
      Leave();
    }
    Leave();
  }
  void Hash(std::string_view name, std::optional<std::uint64_t>& hash) {
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
  void Rules(Controller& controller, int rods) {
    const JsonValue* given = Get("rules", JsonValue::Kind::kArray);
    if (!Ok()) return;
    if (given == nullptr || given->items.empty() || given->items.size() > kMaxRules) {
      return FailAt("rules", ErrorCode::kOutOfRange,
                    "a controller has 1 to " + std::to_string(kMaxRules) + " rules");
    }
    if (rods < 1) return FailAt("rules", ErrorCode::kStructure, "the figure has no rods");
    controller.rules = static_cast<int>(given->items.size());
    const BankShape shape(controller.rules, controller.senses.kind, rods);
    controller.genes.assign(shape.Genes(), 0);
    Enter("rules");
    for (std::size_t rule = 0; rule < given->items.size() && Ok(); ++rule) {
      EnterElement(rule);
      Rule(given->items[rule], controller, shape, rods, static_cast<int>(rule));
      Leave();
    }
    Leave();
  }
  template <class Fields>
  void Since(int, Fields fields) {
    fields();
  }
  void Finish() { Close(); }

 private:
  void Rule(const JsonValue& given, Controller& controller, const BankShape& shape, int rods, int rule) {
    if (given.kind != JsonValue::Kind::kObject) {
      return FailAt("", ErrorCode::kSyntax, std::string("must be an object, is ") + given.KindName());
    }
    Open(given);
    for (int sense = 0; sense < shape.senses; ++sense) controller.genes[shape.High(rule, sense)] = kGeneMax;
    Group("when", [&] {
      for (int sense = 0; sense < shape.senses; ++sense) {
        const std::string name = SenseName(controller.senses.kind, rods, sense);
        Gene interval[2] = {0, kGeneMax};
        if (!GeneList(name, interval, false)) continue;
        if (interval[0] > interval[1]) return FailAt(name, ErrorCode::kOutOfRange, "ends before it begins");
        controller.genes[shape.Low(rule, sense)] = interval[0];
        controller.genes[shape.High(rule, sense)] = interval[1];
      }
    });
    GeneList(
        "pose",
        std::span(controller.genes).subspan(shape.Target(rule, 0), static_cast<std::size_t>(shape.joints)),
        true);
    std::int64_t tau = 0;
    if (!Whole("tau", tau, 0, kGeneMax) && Ok()) FailAt("tau", ErrorCode::kMissing, "is missing");
    controller.genes[shape.Tau(rule)] = static_cast<Gene>(tau);
    Close();
  }

  /// Reads as many genes as there is room for. @return whether they were given
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

  static JsonValue OfKind(JsonValue::Kind kind) {
    JsonValue value;
    value.kind = kind;
    return value;
  }

  void Open(const JsonValue& object) { open_.push_back({&object, {}}); }
  /// Every member must have been asked for: whatever is left over is a field that does not exist.
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

}  // namespace

std::string EncodeJson(const Document& document) {
  JsonWriter writer;
  Document copy = document;
  return writer.Whole([&] { Describe(writer, copy); });
}

Result<Document> DecodeJson(std::string_view text) {
  constexpr std::size_t kMaxBytes = 16u << 20;
  if (text.size() > kMaxBytes) return Fail(ErrorCode::kTooMany, "", "the text is longer than 16 MiB");
  const auto json = ParseJson(text);
  if (!json) return std::unexpected(json.error());
  if (json->kind != JsonValue::Kind::kObject) {
    return Fail(ErrorCode::kSyntax, "",
                std::string("a document must be an object, this is ") + json->KindName());
  }
  JsonReader reader(*json);
  Document document;
  Describe(reader, document);
  reader.Finish();
  if (!reader.Ok()) return std::unexpected(*reader.Fault());
  if (auto references = CheckReferences(document); !references) return std::unexpected(references.error());
  return document;
}

Result<Figure> DecodeFigureJson(std::string_view text) {
  const auto json = ParseJson(text);
  if (!json) return std::unexpected(json.error());
  if (json->kind != JsonValue::Kind::kObject) {
    return Fail(ErrorCode::kSyntax, "",
                std::string("a figure must be an object, this is ") + json->KindName());
  }
  JsonReader reader(*json);
  Figure figure;
  Describe(reader, figure);
  reader.Finish();
  if (!reader.Ok()) return std::unexpected(*reader.Fault());
  if (auto valid = Validate(figure); !valid) return std::unexpected(valid.error());
  return figure;
}

}  // namespace gaitsmith
