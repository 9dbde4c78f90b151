// SPDX-License-Identifier: MIT
// Replacements for WebGL calls of Dear ImGui's renderer. In each frame it reads the WebGL state, in order to
// restore it later. This blocks until the browser's GPU process has caught up, up to 30 ms per frame with
// software rendering. Nothing else draws on the canvas, so constants suffice. The renderer also creates a
// vertex array per frame, and Emscripten's table grows with every one ever created, so it gets the same one
// each time.
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
      *value = 0;  // no object bound, or GL_ZERO
  }
}

extern "C" void gaitsmith_webgl_vertex_array(GLsizei, GLuint* array) {
  static GLuint shared = 0;
  if (shared == 0) glGenVertexArrays(1, &shared);
  *array = shared;
}

extern "C" void gaitsmith_webgl_keep(GLsizei, const GLuint*) {}
