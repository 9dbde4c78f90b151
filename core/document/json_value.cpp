// SPDX-License-Identifier: MIT
#include "core/document/json_value.h"

#include <cmath>
#include <cstdlib>

namespace gaitsmith {

const char* JsonValue::KindName() const {
  switch (kind) {
    case Kind::kNull:
      return "null";
    case Kind::kBool:
      return "true or false";
    case Kind::kNumber:
      return "a number";
    case Kind::kString:
      return "a text";
    case Kind::kArray:
      return "a list";
    case Kind::kObject:
      return "an object";
  }
  return "nothing";
}

const JsonValue* JsonValue::Find(std::string_view name) const {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return &items[i];
  }
  return nullptr;
}

namespace {

// Far above any document (64 controllers of 32 rules with 34 senses are under 200,000 values), but small
// enough that untrusted text takes neither minutes nor gigabytes.
constexpr int kMaxDepth = 32;
constexpr int kMaxValues = 300'000;

class Parser {
 public:
  Parser(std::string_view text, std::size_t most_members) : text_(text), most_members_(most_members) {}

  Result<JsonValue> ParseAll() {
    JsonValue value;
    if (!Value(value, 0)) return std::unexpected(error_);
    Space();
    if (at_ < text_.size()) {
      Fault("there is more text after the end of the document");
      return std::unexpected(error_);
    }
    return value;
  }

 private:
  bool Fault(std::string what) {
    std::size_t line = 1, column = 1;
    for (std::size_t i = 0; i < at_ && i < text_.size(); ++i) {
      column = text_[i] == '\n' ? 1 : column + 1;
      line += text_[i] == '\n' ? 1 : 0;
    }
    error_ = {ErrorCode::kSyntax, "line " + std::to_string(line) + ", column " + std::to_string(column),
              std::move(what)};
    return false;
  }
  void Space() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos)
      ++at_;
  }
  [[nodiscard]] bool Next(char c) const { return at_ < text_.size() && text_[at_] == c; }
  bool Expect(char c, const char* what) {
    Space();
    if (!Next(c)) return Fault(std::string("expected ") + what);
    ++at_;
    return true;
  }
  bool Word(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  bool Value(JsonValue& value, int depth) {
    if (depth > kMaxDepth) return Fault("is nested too deeply");
    if (++values_ > kMaxValues) return Fault("there are more values than any document has");
    Space();
    if (at_ >= text_.size()) return Fault("the text ends where a value should be");
    const char c = text_[at_];
    if (c == '{') return Object(value, depth);
    if (c == '[') return Array(value, depth);
    if (c == '"') {
      value.kind = JsonValue::Kind::kString;
      return String(value.text);
    }
    if (c == '-' || (c >= '0' && c <= '9')) return Number(value);
    value.kind = JsonValue::Kind::kBool;
    if (Word("true")) return value.boolean = true;
    if (Word("false")) return true;
    value.kind = JsonValue::Kind::kNull;
    if (Word("null")) return true;
    return Fault("expected a value");
  }

  bool Object(JsonValue& value, int depth) {
    value.kind = JsonValue::Kind::kObject;
    ++at_;
    Space();
    if (Next('}')) return ++at_ > 0;
    for (;;) {
      Space();
      if (!Next('"')) return Fault("expected the name of a field in quotes");
      std::string name;
      const std::size_t before = at_;
      if (!String(name)) return false;
      if (value.names.size() >= most_members_) return Fault("there are more fields than any object has");
      if (value.Find(name) != nullptr) {
        at_ = before;
        return Fault("the field \"" + name + "\" is there twice");
      }
      if (!Expect(':', "':' after the field's name")) return false;
      value.names.push_back(std::move(name));
      if (!Value(value.items.emplace_back(), depth + 1)) return false;
      Space();
      if (Next('}')) return ++at_ > 0;
      if (!Expect(',', "',' or '}'")) return false;
    }
  }

  bool Array(JsonValue& value, int depth) {
    value.kind = JsonValue::Kind::kArray;
    ++at_;
    Space();
    if (Next(']')) return ++at_ > 0;
    for (;;) {
      if (!Value(value.items.emplace_back(), depth + 1)) return false;
      Space();
      if (Next(']')) return ++at_ > 0;
      if (!Expect(',', "',' or ']'")) return false;
    }
  }

  bool Digits() {
    const std::size_t first = at_;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
    return at_ > first;
  }

  bool Number(JsonValue& value) {
    value.kind = JsonValue::Kind::kNumber;
    const std::size_t first = at_;
    if (Next('-')) ++at_;
    const bool zero = Next('0');
    const std::size_t digits = at_;
    if (!Digits()) return Fault("expected a digit");
    if (zero && at_ - digits > 1) return Fault("a number must not begin with 0");
    if (Next('.')) {
      ++at_;
      if (!Digits()) return Fault("expected a digit after the point");
    }
    if (Next('e') || Next('E')) {
      ++at_;
      if (Next('+') || Next('-')) ++at_;
      if (!Digits()) return Fault("expected a digit in the exponent");
    }
    value.text = std::string(text_.substr(first, at_ - first));
    // strtod rounds correctly on every supported platform. Programs that use core keep the "C" locale for
    // numbers.
    value.number = std::strtod(value.text.c_str(), nullptr);
    if (!std::isfinite(value.number)) {
      at_ = first;
      return Fault("the number is too large");
    }
    return true;
  }

  bool Hex4(unsigned& code) {
    code = 0;
    for (int i = 0; i < 4; ++i, ++at_) {
      const std::size_t digit = at_ < text_.size()
                                    ? std::string_view("0123456789abcdef0123456789ABCDEF").find(text_[at_])
                                    : std::string_view::npos;
      if (digit == std::string_view::npos) return Fault("expected four hexadecimal digits after \\u");
      code = code << 4 | static_cast<unsigned>(digit % 16);
    }
    return true;
  }

  static void AppendUtf8(std::string& out, unsigned code) {
    const auto put = [&](unsigned byte) { out.push_back(static_cast<char>(byte)); };
    if (code < 0x80) {
      put(code);
    } else if (code < 0x800) {
      put(0xc0 | code >> 6);
      put(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
      put(0xe0 | code >> 12);
      put(0x80 | (code >> 6 & 0x3f));
      put(0x80 | (code & 0x3f));
    } else {
      put(0xf0 | code >> 18);
      put(0x80 | (code >> 12 & 0x3f));
      put(0x80 | (code >> 6 & 0x3f));
      put(0x80 | (code & 0x3f));
    }
  }

  bool Escape(std::string& out) {
    if (at_ >= text_.size()) return Fault("the text ends inside quotes");
    const char c = text_[at_++];
    constexpr std::string_view kFrom = "\"\\/bfnrt", kTo = "\"\\/\b\f\n\r\t";
    if (const auto i = kFrom.find(c); i != std::string_view::npos) {
      out.push_back(kTo[i]);
      return true;
    }
    unsigned code = 0;
    if (c != 'u') return Fault("unknown escape");
    if (!Hex4(code)) return false;
    if (code >= 0xd800 && code < 0xdc00) {
      unsigned low = 0;
      if (!Word("\\u") || !Hex4(low) || low < 0xdc00 || low > 0xdfff)
        return Fault("half of a surrogate pair");
      code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
    } else if (code >= 0xdc00 && code < 0xe000) {
      return Fault("half of a surrogate pair");
    }
    AppendUtf8(out, code);
    return true;
  }

  bool String(std::string& out) {
    ++at_;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"') return ++at_ > 0;
      if (static_cast<unsigned char>(c) < 0x20) return Fault("a control character inside quotes");
      ++at_;
      if (c != '\\') {
        out.push_back(c);
      } else if (!Escape(out)) {
        return false;
      }
    }
    return Fault("the text ends inside quotes");
  }

  std::string_view text_;
  std::size_t most_members_;
  std::size_t at_ = 0;
  int values_ = 0;
  Error error_{};
};

}  // namespace

Result<JsonValue> ParseJson(std::string_view text, std::size_t most_members) {
  return Parser(text, most_members).ParseAll();
}

std::string QuoteJson(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out.push_back('\\');
      out.push_back(c);
    } else if (byte < 0x20) {
      constexpr std::string_view kHex = "0123456789abcdef";
      out += "\\u00";
      out.push_back(kHex[byte >> 4]);
      out.push_back(kHex[byte & 15u]);
    } else {
      out.push_back(c);
    }
  }
  return out + "\"";
}

}  // namespace gaitsmith
