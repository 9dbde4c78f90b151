// SPDX-License-Identifier: MIT
// Stands in for parts of Dear ImGui that the page does not use, but that the linker would keep. Its --wrap
// (shell/CMakeLists.txt) sends the calls here.
#include <imgui.h>

#include <cstdarg>
#include <cstdlib>
#include <string_view>

// Dear ImGui's own typeface, 12 KB that do not compress: the page always has Inter.
ImFont* NoDefaultFont(ImFontAtlas*,
                      const ImFontConfig*) asm("__wrap__ZN11ImFontAtlas14AddFontDefaultEPK12ImFontConfig");
ImFont* NoDefaultFont(ImFontAtlas*, const ImFontConfig*) { return nullptr; }

// Dear ImGui reads stored layouts of windows, and numbers typed into its own fields, with sscanf: the page
// has neither. It also reads the version of the shaders' language.
int ScanVersion(const char*, const char*, ...) asm("__wrap_sscanf");
int ScanVersion(const char* text, const char* format, ...) {
  constexpr std::string_view kVersion = "#version ";
  if (std::string_view(format) != "#version %d" || !std::string_view(text).starts_with(kVersion)) return 0;
  std::va_list arguments;
  va_start(arguments, format);
  *va_arg(arguments, int*) = std::atoi(text + kVersion.size());
  va_end(arguments);
  return 1;
}
