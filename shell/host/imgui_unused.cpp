// SPDX-License-Identifier: MIT
// Stands in for Dear ImGui's own typeface, 12 KB that do not compress. Its atlas would fall back to it, so
// the linker keeps it, but the page always has Inter. The linker's --wrap (shell/CMakeLists.txt) sends the
// call here.
#include <imgui.h>

ImFont* NoDefaultFont(ImFontAtlas*,
                      const ImFontConfig*) asm("__wrap__ZN11ImFontAtlas14AddFontDefaultEPK12ImFontConfig");
ImFont* NoDefaultFont(ImFontAtlas*, const ImFontConfig*) { return nullptr; }
