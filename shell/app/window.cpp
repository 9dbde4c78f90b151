// SPDX-License-Identifier: MIT
// Dear ImGui on SDL2 and OpenGL (in the browser: OpenGL ES 3, that is WebGL 2).
#include "shell/app/window.h"

#include <imgui_impl_opengl3.h>
#include <imgui_impl_sdl2.h>
#if defined(__EMSCRIPTEN__)
#include <SDL_opengles2.h>
#else
#include <SDL_opengl.h>
#endif

#include <cmath>

namespace gaitsmith::shell {
namespace {

#if defined(__EMSCRIPTEN__)
constexpr const char* kShaderVersion = "#version 300 es";
#else
constexpr const char* kShaderVersion = "#version 130";
#endif

void ChooseContext() {
#if defined(__EMSCRIPTEN__)
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
#endif
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
  SDL_GL_SetAttribute(SDL_GL_STENCIL_SIZE, 0);
}

}  // namespace

std::unique_ptr<Window> Window::Open(const Options& options) {
  // Without this SDL captures the keys of the whole page, which disables its text fields.
  SDL_SetHint(SDL_HINT_EMSCRIPTEN_KEYBOARD_ELEMENT, "#canvas");
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return nullptr;
  ChooseContext();
  const auto pixels = [&](int points) {
    return static_cast<int>(std::lround(static_cast<float>(points) * options.scale));
  };
  SDL_Window* window = SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                        pixels(options.width), pixels(options.height),
                                        SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
  if (window == nullptr) return nullptr;
  const SDL_GLContext context = SDL_GL_CreateContext(window);
  if (context == nullptr) {
    SDL_DestroyWindow(window);
    return nullptr;
  }
#if !defined(__EMSCRIPTEN__)
  SDL_GL_SetSwapInterval(1);  // in a page the browser sets the pace of frames
#endif
  return std::unique_ptr<Window>(new Window(window, context, options.scale));
}

Window::Window(SDL_Window* window, SDL_GLContext context, float scale)
    : window_(window), context_(context), scale_(scale) {
  registry_.SetScale(scale);
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.ConfigInputTrickleEventQueue = true;  // a quick click spans two frames instead of being lost
  registry_.Attach();
  ImGui_ImplSDL2_InitForOpenGL(window_, context_);
  ImGui_ImplOpenGL3_Init(kShaderVersion);
  RasteriseType(Density());
  ImGui_ImplOpenGL3_CreateDeviceObjects();  // otherwise the first frame would build the
                                            // fonts again
  ImGui::GetIO().Fonts->ClearTexData();
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplSDL2_Shutdown();
  ImGui::DestroyContext();
  SDL_GL_DeleteContext(context_);
  SDL_DestroyWindow(window_);
  SDL_Quit();
}

float Window::Density() const {
  int points = 0;
  int pixels = 0;
  SDL_GetWindowSize(window_, &points, nullptr);
  SDL_GL_GetDrawableSize(window_, &pixels, nullptr);
  // A canvas of one point may have no pixel, and letters of no pixels have no width.
  if (points <= 0 || pixels <= 0) return theme_.density;
  return scale_ * static_cast<float>(pixels) / static_cast<float>(points);
}

// Rasterises the fonts again after a change of display or of the browser's zoom.
void Window::FollowDensity() {
  const float density = Density();
  if (std::abs(density - theme_.density) < 0.004f) return;
  RasteriseType(density);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  ImGui::GetIO().Fonts->ClearTexData();
}

void Window::RasteriseType(float density) {
  theme_.density = density;
  theme_.fonts.Build(density);
  ApplyStyle(theme_);
}

void Window::SetPalette(PaletteName name) {
  theme_.palette = PaletteOf(name);
  ApplyStyle(theme_);
  RequestFrame();
}

void Window::SetScale(float scale) {
  scale_ = scale;
  registry_.SetScale(scale);
  RequestFrame();
}

void Window::SetSize(int width, int height) {
  SDL_SetWindowSize(window_, width, height);
  RequestFrame();
}

bool Window::TakeEvents(int wait_ms, const EventFilter& filter) {
  SDL_Event event;
  bool more = wait_ms > 0 ? SDL_WaitEventTimeout(&event, wait_ms) != 0 : SDL_PollEvent(&event) != 0;
  for (; more; more = SDL_PollEvent(&event) != 0) {
    RequestFrame();
    if (event.type == SDL_QUIT) return false;
    if (!filter || !filter(event)) Handle(event);
  }
  return true;
}

void Window::Handle(SDL_Event event) {
  const auto scaled = [this](Sint32 pixels) {
    return static_cast<Sint32>(std::lround(static_cast<float>(pixels) / scale_));
  };
  switch (event.type) {
    case SDL_MOUSEMOTION:
      event.motion.x = scaled(event.motion.x);
      event.motion.y = scaled(event.motion.y);
      pointer_ = {static_cast<float>(event.motion.x), static_cast<float>(event.motion.y)};
      if (event.motion.which != SDL_TOUCH_MOUSEID) theme_.touch = false;
      break;
    case SDL_MOUSEWHEEL:
      // In browsers the backend divides by 100, which SDL does itself since 2.30.
      ImGui::GetIO().AddMouseWheelEvent(-event.wheel.preciseX, event.wheel.preciseY);
      return;
    case SDL_FINGERDOWN:
      theme_.touch = true;
      break;
    default:
      break;
  }
  ImGui_ImplSDL2_ProcessEvent(&event);
}

void Window::DrawBackdrop() {
  int width = 0;
  int height = 0;
  SDL_GL_GetDrawableSize(window_, &width, &height);
  const auto clear = [](ImU32 colour) {
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
    glClearColor(c.x, c.y, c.z, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  };
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  clear(theme_.palette.panel);
  glEnable(GL_SCISSOR_TEST);
  // Heights are from Dear ImGui's lowest point, since the canvas may be a pixel higher.
  const int drawn_height = static_cast<int>(ImGui::GetIO().DisplaySize.y * theme_.density);
  // Covers the pixels whose centres are inside, like rasterisation.
  const auto pixels = [this](float points) {
    return static_cast<int>(std::ceil(points * theme_.density - 0.5f));
  };
  for (const Backdrop::Area& area : backdrop_.Areas()) {
    const int left = pixels(area.rect.Min.x);
    const int bottom = pixels(area.rect.Max.y);
    const int across = pixels(area.rect.Max.x) - left;
    const int up = bottom - pixels(area.rect.Min.y);
    if (across <= 0 || up <= 0) continue;
    glScissor(left, drawn_height - bottom, across, up);
    clear(area.colour);
  }
  glDisable(GL_SCISSOR_TEST);
}

void Window::Draw(const std::function<void()>& contents) {
  if (frames_due_ > 0) --frames_due_;
  FollowDensity();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplSDL2_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  if (scale_ != 1.0f) {
    io.DisplaySize = {io.DisplaySize.x / scale_, io.DisplaySize.y / scale_};
    io.AddMousePosEvent(pointer_.x, pointer_.y);
  }
  io.DisplayFramebufferScale = {theme_.density, theme_.density};
  backdrop_.Clear();
  ImGui::NewFrame();
  registry_.BeginFrame();
  contents();
  registry_.EndFrame();
  if (registry_.Requests().Waiting()) RequestFrame();
  ImGui::Render();

  DrawBackdrop();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  SDL_GL_SwapWindow(window_);
}

}  // namespace gaitsmith::shell
