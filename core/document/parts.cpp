// SPDX-License-Identifier: MIT
#include "core/document/parts.h"

#include <array>
#include <bit>

#include "core/document/schema.h"

namespace gaitsmith {

namespace {

// Which part a field of the document belongs to. A group without fields of its own here is one part with all
// that is in it; a field that is named beside its group is the exception.
struct Place {
  std::string_view name;   // of the document's field
  std::string_view field;  // inside it; empty: all that no other line names
  Part part;
};
constexpr auto kPlaces = std::to_array<Place>({
    {"title", "", Part::kTitle},
    {"model", "", Part::kModel},
    {"figure", "", Part::kFigure},
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
    {"view", "", Part::kView},
    {"hash", "", Part::kHash},
});

// A field of the schema that has no place above belongs to no part, which parts_test.cpp does not let pass.
const Place* PlaceOf(std::string_view name, std::string_view field) {
  const Place* found = nullptr;
  for (const Place& place : kPlaces) {
    if (place.name != name) continue;
    if (place.field == field) return &place;
    if (place.field.empty()) found = &place;
  }
  return found;
}

// An archive that gives a visitor the fields of the parts that it wants, each with its part.
template <class Visitor>
class PartArchive {
 public:
  explicit PartArchive(Visitor& visitor) : visitor_(visitor) {}

  void Real(std::string_view name, float& value, float, float, float standard) {
    Field(name, value, standard);
  }
  void Integer(std::string_view name, int& value, int, int, int standard) { Field(name, value, standard); }
  void Model(std::string_view name, int& model) { Field(name, model, 0); }
  void Natural(std::string_view name, std::uint32_t& value, std::uint32_t standard) {
    Field(name, value, standard);
  }
  void Flag(std::string_view name, bool& value, bool standard) { Field(name, value, standard); }
  template <class Enum, class Names>
  void Choice(std::string_view name, Enum& value, const Names&, Enum standard) {
    Field(name, value, standard);
  }
  void Text(std::string_view name, std::string& text) { Field(name, text, std::string()); }
  void Hash(std::string_view name, std::optional<std::uint64_t>& hash) {
    Field(name, hash, std::optional<std::uint64_t>());
  }
  void Genes(Controller& controller, const PortCount&) { visitor_.Genes(*part_, controller); }
  template <class Fields>
  void Since(int, Fields fields) {
    fields();
  }
  template <class Fields>
  void Group(std::string_view name, Fields fields) {
    if (depth_++ == 0) group_ = name;
    fields();
    --depth_;
  }
  template <class Item, class Fields>
  void List(std::string_view name, std::vector<Item>& list, int, Fields fields) {
    if (part_ != nullptr) return visitor_.List(*part_, list, fields);
    const Place* place = Find(name);
    if (place == nullptr || !visitor_.wanted.HasAny(place->part)) return;
    part_ = &place->part;
    visitor_.List(*part_, list, fields);
    part_ = nullptr;
  }

 private:
  [[nodiscard]] const Place* Find(std::string_view name) const {
    if (depth_ == 0) return PlaceOf(name, "");
    return PlaceOf(group_, depth_ == 1 ? name : "");
  }
  template <class Value>
  void Field(std::string_view name, Value& value, const Value& standard) {
    if (part_ != nullptr) return visitor_.Field(*part_, value, standard);
    const Place* place = Find(name);
    if (place != nullptr && visitor_.wanted.HasAny(place->part)) visitor_.Field(place->part, value, standard);
  }

  Visitor& visitor_;
  std::string_view group_;  // the outermost one
  int depth_ = 0;
  const Part* part_ = nullptr;  // of the list that is walked
};

// Each part's values, as bits: equal where both encodings would be.
class Contents {
 public:
  explicit Contents(Parts parts) : wanted(parts) {}
  Parts wanted;

  template <class Value>
  void Field(Part part, const Value& value, const Value&) {
    Put(part, static_cast<std::uint64_t>(value));
  }
  void Field(Part part, float value, float standard) {
    // -0 is not written where the standard is 0.
    Put(part, std::bit_cast<std::uint32_t>(value == standard ? standard : value));
  }
  void Field(Part part, const std::string& text, const std::string&) {
    Put(part, text.size());
    for (const char c : text) Put(part, static_cast<unsigned char>(c));
  }
  void Field(Part part, const std::optional<std::uint64_t>& hash, const std::optional<std::uint64_t>&) {
    Put(part, hash.has_value() ? 1 : 0);
    Put(part, hash.value_or(0));
  }
  template <class Item, class Fields>
  void List(Part part, std::vector<Item>& list, Fields fields) {
    Put(part, list.size());
    for (Item& item : list) fields(item);
  }
  void Genes(Part part, const Controller& controller) {
    Put(part, static_cast<std::uint64_t>(controller.rules));
    Put(part, controller.genes.size());
    for (const Gene gene : controller.genes) Put(part, gene);
  }
  [[nodiscard]] const std::vector<std::uint64_t>& Of(Part part) const {
    return bits_[static_cast<std::size_t>(part)];
  }

 private:
  void Put(Part part, std::uint64_t value) { bits_[static_cast<std::size_t>(part)].push_back(value); }

  std::array<std::vector<std::uint64_t>, kPartCount> bits_;
};

// Where the fields of some parts are.
class Addresses {
 public:
  struct Address {
    void* at;
    void (*copy)(const void* from, void* to);
  };
  explicit Addresses(Parts parts) : wanted(parts) {}
  Parts wanted;

  template <class Value>
  void Field(Part, Value& value, const Value&) {
    Add(value);
  }
  template <class Item, class Fields>
  void List(Part, std::vector<Item>& list, Fields) {
    Add(list);  // as a whole
  }
  void Genes(Part, Controller&) {}
  [[nodiscard]] const std::vector<Address>& All() const { return all_; }

 private:
  template <class Value>
  void Add(Value& value) {
    all_.push_back({&value, [](const void* from, void* to) {
                      *static_cast<Value*>(to) = *static_cast<const Value*>(from);
                    }});
  }
  std::vector<Address> all_;
};

template <class Visitor>
Visitor Walk(Document& document, Visitor visitor) {
  PartArchive<Visitor> archive(visitor);
  Describe(archive, document);
  return visitor;
}

}  // namespace

Parts DifferingParts(const Document& a, const Document& b, Parts among) {
  Document x = a, y = b;  // an archive may change what it walks
  const Contents in_x = Walk(x, Contents(among)), in_y = Walk(y, Contents(among));
  Parts differing({});
  for (int i = 0; i < kPartCount; ++i) {
    const auto part = static_cast<Part>(i);
    if (in_x.Of(part) != in_y.Of(part)) differing = {differing, part};
  }
  return differing;
}

bool SameParts(const Document& a, const Document& b, Parts parts) {
  return DifferingParts(a, b, parts).Empty();
}

void CopyParts(const Document& from, Parts parts, Document& to) {
  Document source = from;
  const Addresses there = Walk(source, Addresses(parts)), here = Walk(to, Addresses(parts));
  for (std::size_t i = 0; i < there.All().size(); ++i)
    there.All()[i].copy(there.All()[i].at, here.All()[i].at);
}

bool SameBehaviour(const Controller& a, const Controller& b) {
  return a.kind == b.kind && a.rules == b.rules && a.senses == b.senses && a.genes == b.genes;
}

}  // namespace gaitsmith
