// SPDX-License-Identifier: MIT
// Rasterises Inter and draws lines of text.
#include "shell/widgets/fonts.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "shell/embedded/embedded.h"

namespace gaitsmith::shell {
namespace {

// Dear ImGui sizes fonts by ascent − descent, designers by the em. For Inter this is the ratio.
constexpr float kHeightPerEm = 1.2102f;
constexpr float kCapitalHeightPerEm = 0.727f;

struct Face {
  float em;
  bool semibold;
};
constexpr std::array<Face, kTypes> kFaces = {{{11.0f, false},
                                              {12.0f, false},
                                              {13.0f, false},
                                              {13.0f, true},
                                              {15.0f, true},
                                              {22.0f, true},
                                              {30.0f, true}}};

// The characters that the interface uses. Others are drawn as '?', also in documents' names.
constexpr ImWchar kRanges[] = {0x20,   0x7e,   0xa0,   0xff,   0x394,  0x394,  0x3a3,  0x3a3,  0x3b8,
                               0x3b8,  0x3bc,  0x3bc,  0x3c0,  0x3c0,  0x3c4,  0x3c4,  0x3c6,  0x3c6,
                               0x3c9,  0x3c9,  0x2013, 0x2014, 0x2018, 0x2019, 0x201c, 0x201e, 0x2026,
                               0x2026, 0x2190, 0x2193, 0x2212, 0x2212, 0x2264, 0x2265, 0};

// The large types are only used for what the stage says. Other characters would take a fifth of the atlas.
constexpr ImWchar kLargeRanges[] = {0x20,   0x7e,   0xb7,   0xb7,   0xc0,   0xff,   0x2013, 0x2014, 0x2018,
                                    0x2019, 0x201c, 0x201e, 0x2026, 0x2026, 0x2212, 0x2212, 0};

// Gives all ten digits the same width, so that changing numbers do not jitter.
void MakeTabular(ImFont* font) {
  float width = 0.0f;
  for (ImFontGlyph& glyph : font->Glyphs) {
    if (glyph.Codepoint >= '0' && glyph.Codepoint <= '9') width = std::max(width, glyph.AdvanceX);
  }
  for (ImFontGlyph& glyph : font->Glyphs) {
    if (glyph.Codepoint < '0' || glyph.Codepoint > '9') continue;
    const float shift = 0.5f * (width - glyph.AdvanceX);
    glyph.X0 += shift;
    glyph.X1 += shift;
    glyph.AdvanceX = width;
  }
  font->BuildLookupTable();
}

// Decodes one UTF-8 character and moves `at` past it.
unsigned NextCharacter(std::string_view text, std::size_t& at) {
  unsigned character = 0;
  const int length = ImTextCharFromUtf8(&character, text.data() + at, text.data() + text.size());
  at += static_cast<std::size_t>(std::max(length, 1));
  return character;
}

}  // namespace

void Fonts::Build(float density) {
  density_ = density;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.Flags = ImFontAtlasFlags_NoPowerOfTwoHeight | ImFontAtlasFlags_NoMouseCursors;
  for (std::size_t i = 0; i < kFaces.size(); ++i) {
    const auto bytes = kFaces[i].semibold ? InterSemiBold() : InterRegular();
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.RasterizerDensity = density;
    config.OversampleH = density < 1.75f ? 3 : 2;
    config.OversampleV = 1;
    config.GlyphRanges = i >= static_cast<std::size_t>(Type::kLarge) ? kLargeRanges : kRanges;
    // The atlas only reads the bytes, although its interface lacks const.
    fonts_[i] =
        atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(bytes.data()), static_cast<int>(bytes.size()),
                                   kFaces[i].em * kHeightPerEm, &config);
  }
  ImGui::GetIO().FontDefault = Raw(Type::kBody);
  atlas.Build();
  for (ImFont* font : fonts_) MakeTabular(font);
}

float Fonts::Width(Type type, std::string_view text) const {
  const ImFont* font = Raw(type);
  float width = 0.0f;
  for (std::size_t at = 0; at < text.size();) {
    width += font->GetCharAdvance(static_cast<ImWchar>(NextCharacter(text, at)));
  }
  return width;
}

void Fonts::Draw(ImDrawList* list, Type type, ImVec2 position, ImU32 colour, std::string_view text,
                 Align align) const {
  const ImFont* font = Raw(type);
  float x = position.x;
  if (align == Align::kCentre) x -= 0.5f * Width(type, text);
  if (align == Align::kRight) x -= Width(type, text);
  const float em = kFaces[static_cast<std::size_t>(type)].em;
  const float baseline = std::round((position.y + 0.5f * kCapitalHeightPerEm * em) * density_) / density_;
  const float top = baseline - std::round(font->Ascent);
  x = std::round(x * density_) / density_;
  for (std::size_t at = 0; at < text.size();) {
    const ImFontGlyph* glyph = font->FindGlyph(static_cast<ImWchar>(NextCharacter(text, at)));
    if (glyph == nullptr) continue;
    if (glyph->Visible != 0) {
      list->PrimReserve(6, 4);
      list->PrimRectUV({x + glyph->X0, top + glyph->Y0}, {x + glyph->X1, top + glyph->Y1},
                       {glyph->U0, glyph->V0}, {glyph->U1, glyph->V1}, colour);
    }
    x += glyph->AdvanceX;
  }
}

void Fonts::DrawElided(ImDrawList* list, Type type, ImVec2 position, float width, ImU32 colour,
                       std::string_view text) const {
  if (Width(type, text) <= width) {
    Draw(list, type, position, colour, text);
    return;
  }
  const float room = width - Width(type, "…");
  float used = 0.0f;
  std::size_t end = 0;
  while (end < text.size()) {
    std::size_t next = end;
    used += Raw(type)->GetCharAdvance(static_cast<ImWchar>(NextCharacter(text, next)));
    if (used > room) break;
    end = next;
  }
  Draw(list, type, position, colour, text.substr(0, end));
  Draw(list, type, {position.x + Width(type, text.substr(0, end)), position.y}, colour, "…");
}

std::size_t Fonts::FitLine(Type type, std::string_view text, float width) const {
  std::size_t end = 0;
  float used = 0.0f;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t start = at;
    used += Raw(type)->GetCharAdvance(static_cast<ImWchar>(NextCharacter(text, at)));
    if (used > width && end > 0) return end;
    if (at == text.size() || (text[start] != ' ' && text[at] == ' ')) end = at;
  }
  return text.size();
}

float Fonts::LineHeight(Type type) { return std::round(1.42f * kFaces[static_cast<std::size_t>(type)].em); }

}  // namespace gaitsmith::shell
