// SPDX-License-Identifier: MIT
// What Dear ImGui's renderer is told when it asks for WebGL's state. It does so at every frame, to put back
// what it changes; but nobody else draws here, and a browser that is asked for state waits until its graphics
// process has caught up: up to 30 ms a frame where graphics are software. So the questions never reach it. It
// also makes a vertex array for every frame, and Emscripten's tables keep a place for each that there ever
// was. So it gets the same one again.
#include <GLES3/gl3.h>

// The backend's functions, renamed in .dev/libraries.cmake.
extern "C" void gaitsmith_webgl_state(GLenum what, GLint* value) {
  switch (what) {
    case GL_MAJOR_VERSION:
      *value = 3;
      return;
    case GL_VIEWPORT:
    case GL_SCISSOR_BOX:
      for (int i = 0; i < 4; ++i) value[i] = 0;
      return;
    case GL_ACTIVE_TEXTURE:
      *value = GL_TEXTURE0;
      return;
    case GL_BLEND_SRC_RGB:
    case GL_BLEND_SRC_ALPHA:
      *value = GL_ONE;
      return;
    case GL_BLEND_EQUATION_RGB:
    case GL_BLEND_EQUATION_ALPHA:
      *value = GL_FUNC_ADD;
      return;
    default:
      *value = 0;  // nothing is bound, and GL_ZERO
  }
}

extern "C" void gaitsmith_webgl_vertex_array(GLsizei, GLuint* array) {
  static GLuint kept = 0;
  if (kept == 0) glGenVertexArrays(1, &kept);
  *array = kept;
}

extern "C" void gaitsmith_webgl_keep(GLsizei, const GLuint*) {}
