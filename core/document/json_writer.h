// SPDX-License-Identifier: MIT
// Walks a document and writes it as JSON. Only for json.cpp.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/document/archive.h"
#include "core/document/json_value.h"
#include "core/document/schema.h"

namespace gaitsmith {

class JsonWriter : public Archive {
 public:
  void Real(std::string_view name, float& value, float, float, float standard) override {
    Note(value == standard);
    Field(name, RealText(value));
  }
  void Integer(std::string_view name, int& value, int, int, int standard) override {
    Note(value == standard);
    Field(name, std::to_string(value));
  }
  void Model(std::string_view name, int& model) override { Field(name, std::to_string(model)); }
  void Natural(std::string_view name, std::uint32_t& value, std::uint32_t standard) override {
    Note(value == standard);
    Field(name, std::to_string(value));
  }
  void Flag(std::string_view name, bool& value, bool standard) override {
    Note(value == standard);
    Field(name, value ? "true" : "false");
  }
  void Text(std::string_view name, std::string& text) override {
    Note(text.empty());
    Field(name, QuoteJson(text));
  }
  void Hash(std::string_view name, std::optional<std::uint64_t>& hash) override {
    Note(!hash);
    if (hash) Field(name, QuoteJson(HashText(*hash)));
  }
  void Genes(Controller& controller, const PortCount& ports) override {
    const ControllerShape shape = controller.Shape(ports);
    Field(RowOf(controller.kind).components, "");
    Open('[');
    for (int component = 0; component < shape.Components(); ++component) {
      Separate();
      out_ += ComponentText(controller, shape.GroupsOf(component), ports);
    }
    Close(']');
  }
  void Begin() { Open('{'); }
  [[nodiscard]] std::string Finish() {
    Close('}');
    return out_ + "\n";
  }

 private:
  void Index(std::string_view name, int& index, std::span<const std::string_view> names,
             int standard) override {
    Note(index == standard);
    Field(name, QuoteJson(names[static_cast<std::size_t>(index)]));
  }
  /// Later fields are written only if at least one of them has a non-standard value.
  bool BeginSince(int) override {
    outside_.push_back({out_.size(), first_, std::exchange(all_standard_, true)});
    return true;
  }
  void EndSince() override {
    const Outside outside = outside_.back();
    outside_.pop_back();
    if (all_standard_) {
      out_.resize(outside.size);
      first_ = outside.first;
    }
    all_standard_ = all_standard_ && outside.all_standard;
  }
  bool BeginGroup(std::string_view name) override {
    Field(name, "");
    Open('{');
    return true;
  }
  void EndGroup() override { Close('}'); }
  bool BeginList(std::string_view name, std::size_t& size, int) override {
    Field(name, "");
    Note(size == 0);
    if (size == 0) {
      out_ += "[]";
      return false;
    }
    Open('[');
    return true;
  }
  bool BeginItem(std::size_t) override {
    Separate();
    Open('{');
    return true;
  }
  void EndItem() override { Close('}'); }
  void EndList() override { Close(']'); }

  /// All on one line: a rule or a node.
  static std::string ComponentText(const Controller& controller, const GeneGroups& groups,
                                   const PortCount& ports) {
    std::string text;
    for (const GeneGroup& group : groups) {
      const std::span<const Gene> genes = group.Of(controller.genes);
      text += (text.empty() ? "{" : ", ") + QuoteJson(group.name) + ": ";
      if (group.role == GeneRole::kNumber) {
        text += std::to_string(genes.front());
      } else if (group.role == GeneRole::kList) {
        text += ListText(genes);
      } else {
        text += StimulusText(controller.senses.kind, ports, genes);
      }
    }
    return text + "}";
  }
  /// The senses that are used, by their names.
  static std::string StimulusText(SenseKind kind, const PortCount& ports, std::span<const Gene> intervals) {
    std::string text;
    for (std::size_t i = 0; i < intervals.size(); i += 2) {
      if (!Cares(intervals[i], intervals[i + 1])) continue;
      text += (text.empty() ? "" : ", ") + QuoteJson(SenseName(kind, ports, static_cast<int>(i / 2))) + ": " +
              ListText(intervals.subspan(i, 2));
    }
    return "{" + text + "}";
  }
  static std::string ListText(std::span<const Gene> genes) {
    std::string text;
    for (const Gene gene : genes) text += (text.empty() ? "" : ", ") + std::to_string(gene);
    return "[" + text + "]";
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
  void Open(char bracket) {
    out_ += bracket;
    ++depth_;
    first_ = true;
  }
  void Close(char bracket) {
    first_ = false;
    --depth_;
    out_ += "\n" + std::string(static_cast<std::size_t>(depth_) * 2, ' ') + bracket;
  }

  void Note(bool standard) { all_standard_ = all_standard_ && standard; }

  // As it was before a Since.
  struct Outside {
    std::size_t size;
    bool first, all_standard;
  };

  std::string out_;
  bool all_standard_ = true;  // since the start of the innermost Since
  std::vector<Outside> outside_;
  int depth_ = 0;
  bool first_ = true;
};

}  // namespace gaitsmith
