// SPDX-License-Identifier: MIT
// Stubs for parts of SDL that a WebGL canvas never uses: surface blitting, the 2D renderer, sound, game
// controllers, sensors and gestures. SDL's core files reference them, which would add 250 KB to the download.
// The linker takes a file from the archive only to resolve an undefined symbol, so these stubs keep those
// files out. The definitions are weak, so they do not conflict if another version of SDL links such a file
// anyway.
#include <SDL.h>

#define GS_UNUSED extern "C" __attribute__((weak))

// The real one refers to every WebGL function and would link the JavaScript of all. SDL looks up only
// optional functions with it.
GS_UNUSED void* eglGetProcAddress(const char* /*name*/) { return nullptr; }

// Surfaces.
GS_UNUSED int SDL_CalculateBlit(SDL_Surface* /*surface*/) { return -1; }
GS_UNUSED int SDL_RLESurface(SDL_Surface* /*surface*/) { return -1; }
GS_UNUSED void SDL_UnRLESurface(SDL_Surface* /*surface*/, int /*recode*/) {}
GS_UNUSED int Emscripten_CreateWindowFramebuffer(void* /*device*/, SDL_Window* /*window*/, Uint32* /*format*/,
                                                 void** /*pixels*/, int* /*pitch*/) {
  return -1;
}
GS_UNUSED int Emscripten_UpdateWindowFramebuffer(void* /*device*/, SDL_Window* /*window*/,
                                                 const SDL_Rect* /*rects*/, int /*count*/) {
  return -1;
}
GS_UNUSED void Emscripten_DestroyWindowFramebuffer(void* /*device*/, SDL_Window* /*window*/) {}

// The 2D renderer.
GS_UNUSED SDL_Renderer* SDL_CreateRenderer(SDL_Window* /*window*/, int /*index*/, Uint32 /*flags*/) {
  return nullptr;
}
GS_UNUSED void SDL_DestroyRenderer(SDL_Renderer* /*renderer*/) {}
GS_UNUSED void SDL_DestroyRendererWithoutFreeing(SDL_Renderer* /*renderer*/) {}
GS_UNUSED SDL_Renderer* SDL_GetRenderer(SDL_Window* /*window*/) { return nullptr; }
GS_UNUSED int SDL_GetRendererInfo(SDL_Renderer* /*renderer*/, SDL_RendererInfo* /*info*/) { return -1; }
GS_UNUSED int SDL_GetNumRenderDrivers() { return 0; }
GS_UNUSED int SDL_GetRenderDriverInfo(int /*index*/, SDL_RendererInfo* /*info*/) { return -1; }
GS_UNUSED SDL_Texture* SDL_CreateTexture(SDL_Renderer* /*renderer*/, Uint32 /*format*/, int /*access*/,
                                         int /*width*/, int /*height*/) {
  return nullptr;
}
GS_UNUSED void SDL_DestroyTexture(SDL_Texture* /*texture*/) {}
GS_UNUSED int SDL_UpdateTexture(SDL_Texture* /*texture*/, const SDL_Rect* /*rect*/, const void* /*pixels*/,
                                int /*pitch*/) {
  return -1;
}
GS_UNUSED int SDL_RenderCopy(SDL_Renderer* /*renderer*/, SDL_Texture* /*texture*/, const SDL_Rect* /*from*/,
                             const SDL_Rect* /*to*/) {
  return -1;
}
GS_UNUSED void SDL_RenderPresent(SDL_Renderer* /*renderer*/) {}
GS_UNUSED int SDL_RenderSetViewport(SDL_Renderer* /*renderer*/, const SDL_Rect* /*rect*/) { return -1; }

// Sound.
GS_UNUSED int SDL_AudioInit(const char* /*driver*/) { return -1; }
GS_UNUSED void SDL_AudioQuit() {}

// Game controllers. Dear ImGui calls the last three, and only if gamepad navigation is enabled.
GS_UNUSED int SDL_GameControllerInit() { return -1; }
GS_UNUSED void SDL_GameControllerQuit() {}
GS_UNUSED int SDL_JoystickInit() { return -1; }
GS_UNUSED void SDL_JoystickQuit() {}
GS_UNUSED int SDL_JoystickEventState(int /*state*/) { return SDL_IGNORE; }
GS_UNUSED void SDL_JoystickUpdate() {}
GS_UNUSED int SDL_NumJoysticks() { return 0; }
GS_UNUSED SDL_GameController* SDL_GameControllerOpen(int /*index*/) { return nullptr; }
GS_UNUSED Uint8 SDL_GameControllerGetButton(SDL_GameController* /*controller*/,
                                            SDL_GameControllerButton /*button*/) {
  return 0;
}
GS_UNUSED Sint16 SDL_GameControllerGetAxis(SDL_GameController* /*controller*/,
                                           SDL_GameControllerAxis /*axis*/) {
  return 0;
}

// Sensors and gestures.
GS_UNUSED int SDL_SensorInit() { return -1; }
GS_UNUSED void SDL_SensorQuit() {}
GS_UNUSED int SDL_NumSensors() { return 0; }
GS_UNUSED void SDL_SensorUpdate() {}
GS_UNUSED int SDL_GestureAddTouch(SDL_TouchID /*touch*/) { return 0; }
GS_UNUSED int SDL_GestureDelTouch(SDL_TouchID /*touch*/) { return 0; }
GS_UNUSED void SDL_GestureProcessEvent(SDL_Event* /*event*/) {}
GS_UNUSED void SDL_GestureQuit() {}
