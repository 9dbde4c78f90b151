// SPDX-License-Identifier: MIT
// Stands in for parts of Dear ImGui that the page never runs, but that the linker would keep. The linker's
// --wrap (shell/CMakeLists.txt) sends their calls here.
#include <imgui.h>

// Dear ImGui's own typeface, 12 KB that do not compress. Its atlas would fall back to it, but the page always
// has Inter.
ImFont* NoDefaultFont(ImFontAtlas*,
                      const ImFontConfig*) asm("__wrap__ZN11ImFontAtlas14AddFontDefaultEPK12ImFontConfig");
ImFont* NoDefaultFont(ImFontAtlas*, const ImFontConfig*) { return nullptr; }

// Dear ImGui reads its settings file with sscanf, and the page has none. Nothing else in the page may call
// it.
extern "C" int __wrap_sscanf(const char* /*text*/, const char* /*format*/, ...) { __builtin_trap(); }
