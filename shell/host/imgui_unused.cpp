// SPDX-License-Identifier: MIT
// Stands in for parts of Dear ImGui that the page does not use, but that the linker would keep. Its --wrap
// (shell/CMakeLists.txt) sends the calls here.
#include <imgui.h>

// Dear ImGui's own typeface, 12 KB that do not compress: the page always has Inter.

ImFont* NoDefaultFont(ImFontAtlas*,
                      const ImFontConfig*) asm("__wrap__ZN11ImFontAtlas14AddFontDefaultEPK12ImFontConfig");
ImFont* NoDefaultFont(ImFontAtlas*, const ImFontConfig*) { return nullptr; }

// Reads stored layouts of windows, and numbers typed into Dear ImGui's own fields: the page has neither.
int NoScan(const char*, const char*, ...) asm("__wrap_sscanf");
int NoScan(const char*, const char*, ...) { return 0; }
