// SPDX-License-Identifier: MIT
// Stands in for Dear ImGui's own typeface, 12 KB that do not compress. The page always has Inter
// (page_typeface.cpp), but Dear ImGui's atlas would fall back to its own, so the linker keeps it.
#include <imgui.h>

// The linker's --wrap (shell/CMakeLists.txt) sends calls of ImFontAtlas::AddFontDefault here.
ImFont* NoDefaultFont(ImFontAtlas*,
                      const ImFontConfig*) asm("__wrap__ZN11ImFontAtlas14AddFontDefaultEPK12ImFontConfig");
ImFont* NoDefaultFont(ImFontAtlas*, const ImFontConfig*) { return nullptr; }
