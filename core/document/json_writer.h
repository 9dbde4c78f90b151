// SPDX-License-Identifier: MIT
// Walks a document and writes it as JSON. Only for json.cpp.
#pragma once

#include <string>
#include <utility>

#include "core/document/archive.h"
#include "core/document/json_value.h"
#include "core/document/schema.h"

namespace gaitsmith {

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
  /// Later fields are written only if at least one of them has a non-standard value.
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
  void Genes(Controller& controller, const PortCount& ports) {
    const ControllerShape shape = controller.Shape(ports);
    const bool network = shape.Kind() == ControllerKind::kNetwork;
    Field(network ? "nodes" : "rules", "");
    Nested('[', ']', [&] {
      for (int component = 0; component < shape.Components(); ++component) {
        Separate();
        out_ += network ? NodeText(controller, shape.Network(), component)
                        : RuleText(controller, shape.Bank(), ports, component);
      }
    });
  }
  template <class Fields>
  std::string Whole(Fields fields) {
    Nested('{', '}', fields);
    return out_ + "\n";
  }

 private:
  static std::string RuleText(const Controller& controller, const BankShape& shape, const PortCount& ports,
                              int rule) {
    std::string when, pose;
    for (int sense = 0; sense < shape.senses; ++sense) {
      if (!shape.Cares(controller.genes, rule, sense)) continue;
      when += (when.empty() ? "" : ", ") + QuoteJson(SenseName(controller.senses.kind, ports, sense)) +
              ": [" + std::to_string(controller.genes[shape.Low(rule, sense)]) + ", " +
              std::to_string(controller.genes[shape.High(rule, sense)]) + "]";
    }
    for (int joint = 0; joint < shape.joints; ++joint) {
      pose += (joint == 0 ? "" : ", ") + std::to_string(controller.genes[shape.Target(rule, joint)]);
    }
    return "{\"when\": {" + when + "}, \"pose\": [" + pose +
           "], \"tau\": " + std::to_string(controller.genes[shape.Tau(rule)]) + "}";
  }
  static std::string NodeText(const Controller& controller, const NetworkShape& shape, int node) {
    const auto gene = [&](std::size_t at) { return std::to_string(controller.genes[at]); };
    std::string weights;
    for (int input = 0; input < shape.Inputs(); ++input) {
      weights += (input == 0 ? "" : ", ") + gene(shape.Weight(node, input));
    }
    std::string text = "{\"weights\": [" + weights + "], \"delay\": " + gene(shape.Delay(node));
    if (shape.IsActuator(node)) {
      text += ", \"threshold\": " + gene(shape.Threshold(node)) + ", \"targets\": [" +
              gene(shape.TargetEmpty(node)) + ", " + gene(shape.TargetFull(node)) +
              "], \"tau\": " + gene(shape.Tau(node));
    }
    return text + "}";
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
  bool all_standard_ = true;  // since the start of the innermost Since
  int depth_ = 0;
  bool first_ = true;
};

}  // namespace gaitsmith
