# Third-party code: Eigen always, and SDL2, imgui, lodepng and catch2 if Gaitsmith is the main project. After ./dev setup the
# sources are in .toolchain. Otherwise CMake fetches the same releases.
include(FetchContent)
if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/../.toolchain/deps.cmake")
  include("${CMAKE_CURRENT_LIST_DIR}/../.toolchain/deps.cmake")
endif()

# Fetches a library's sources without its own build: SOURCE_SUBDIR names a folder without CMakeLists.txt.
function(gaitsmith_fetch name repository tag)
  FetchContent_Declare(${name} GIT_REPOSITORY ${repository} GIT_TAG ${tag} GIT_SHALLOW ON SOURCE_SUBDIR none)
  FetchContent_MakeAvailable(${name})
  set(${name}_SOURCE_DIR "${${name}_SOURCE_DIR}" PARENT_SCOPE)
endfunction()

# Third-party code is built only if linked, without warnings, linting or debug stepping.
function(gaitsmith_foreign target)
  set_target_properties(${target} PROPERTIES CXX_CLANG_TIDY "" EXCLUDE_FROM_ALL ON)
  target_compile_options(${target} PRIVATE -w -g0)
endfunction()

if(NOT TARGET Eigen3::Eigen)
  gaitsmith_fetch(eigen https://gitlab.com/libeigen/eigen.git 3.4.0)
  add_library(Eigen3::Eigen INTERFACE IMPORTED GLOBAL)
  target_include_directories(Eigen3::Eigen SYSTEM INTERFACE "${eigen_SOURCE_DIR}")
endif()

if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()

# SDL2: Emscripten's port for WASM, the system's package natively. None for another processor, where only the command
# line and the tests of core are built.
add_library(SDL2 INTERFACE)
if(EMSCRIPTEN)
  target_compile_options(SDL2 INTERFACE -sUSE_SDL=2)
  target_link_options(SDL2 INTERFACE -sUSE_SDL=2)
elseif(NOT CMAKE_CROSSCOMPILING)
  find_package(SDL2 REQUIRED CONFIG)
  find_package(OpenGL REQUIRED)
  target_link_libraries(SDL2 INTERFACE SDL2::SDL2)
endif()

# Dear ImGui with its SDL2 and OpenGL 3 backends (WebGL 2 in the browser). IMGUI_ENABLE_TEST_ENGINE makes it
# report every widget to the ImGuiTestEngineHook_* functions, which shell/ defines.
gaitsmith_fetch(imgui https://github.com/ocornut/imgui.git v1.90.1)
add_library(imgui STATIC
  "${imgui_SOURCE_DIR}/imgui.cpp"
  "${imgui_SOURCE_DIR}/imgui_demo.cpp"
  "${imgui_SOURCE_DIR}/imgui_draw.cpp"
  "${imgui_SOURCE_DIR}/imgui_tables.cpp"
  "${imgui_SOURCE_DIR}/imgui_widgets.cpp"
  "${imgui_SOURCE_DIR}/backends/imgui_impl_opengl3.cpp"
  "${imgui_SOURCE_DIR}/backends/imgui_impl_sdl2.cpp")
gaitsmith_foreign(imgui)
target_include_directories(imgui SYSTEM PUBLIC "${imgui_SOURCE_DIR}" "${imgui_SOURCE_DIR}/backends")
target_compile_definitions(imgui PUBLIC
  IMGUI_DISABLE_DEBUG_TOOLS IMGUI_DISABLE_DEMO_WINDOWS IMGUI_DISABLE_FILE_FUNCTIONS IMGUI_DISABLE_OBSOLETE_FUNCTIONS
  IMGUI_ENABLE_TEST_ENGINE)
target_link_libraries(imgui PUBLIC SDL2)
if(EMSCRIPTEN)
  target_compile_definitions(imgui PUBLIC IMGUI_IMPL_OPENGL_ES3)
  target_compile_options(imgui PRIVATE -Oz -emit-llvm)
  # shell/host/webgl_state.cpp defines and explains these functions.
  set_source_files_properties("${imgui_SOURCE_DIR}/backends/imgui_impl_opengl3.cpp" PROPERTIES
    COMPILE_DEFINITIONS "glGetIntegerv=gaitsmith_webgl_state;glGenVertexArrays=gaitsmith_webgl_vertex_array;glDeleteVertexArrays=gaitsmith_webgl_keep")
  target_link_options(imgui INTERFACE -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2)
elseif(NOT CMAKE_CROSSCOMPILING)
  target_link_libraries(imgui PUBLIC OpenGL::GL ${CMAKE_DL_LIBS})
endif()

# Pictures of exported motions: LodePNG, and the rasteriser that comes with Dear ImGui, a header without a window.
gaitsmith_fetch(lodepng https://github.com/lvandeve/lodepng.git c45ed7951fb9df607351013d288d71faef6eea87)
add_library(lodepng STATIC "${lodepng_SOURCE_DIR}/lodepng.cpp")
gaitsmith_foreign(lodepng)
target_include_directories(lodepng SYSTEM PUBLIC "${lodepng_SOURCE_DIR}")
target_compile_definitions(lodepng PUBLIC
  LODEPNG_NO_COMPILE_DISK LODEPNG_NO_COMPILE_DECODER LODEPNG_NO_COMPILE_ANCILLARY_CHUNKS LODEPNG_NO_COMPILE_ERROR_TEXT)
if(EMSCRIPTEN)
  target_compile_options(lodepng PRIVATE -Os)
endif()
add_library(stb_truetype INTERFACE)
target_include_directories(stb_truetype SYSTEM INTERFACE "${imgui_SOURCE_DIR}")

# Catch2 with its main, and catch_discover_tests. It throws exceptions, so its users must enable them on WASM.
gaitsmith_fetch(catch2 https://github.com/catchorg/Catch2.git v3.7.1)
add_library(catch2 STATIC "${catch2_SOURCE_DIR}/extras/catch_amalgamated.cpp")
gaitsmith_foreign(catch2)
target_include_directories(catch2 SYSTEM PUBLIC "${catch2_SOURCE_DIR}/extras")
if(EMSCRIPTEN)
  target_compile_options(catch2 PUBLIC -fwasm-exceptions)
  target_link_options(catch2 PUBLIC -fwasm-exceptions)
endif()
list(APPEND CMAKE_MODULE_PATH "${catch2_SOURCE_DIR}/extras")
include(Catch)
