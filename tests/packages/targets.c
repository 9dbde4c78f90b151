/* SPDX-License-Identifier: MIT */
/* Reads a controller from the first file, and from the second a line for each step: what it senses. Prints
   the bits of every target. packages.test.mjs has the same in JavaScript. */
#include <stdio.h>
#include <string.h>

#include "gaitsmith.h"

int main(int count, char** names) {
  static char text[1000000];
  static gaitsmith_controller controller;
  gaitsmith_state state;
  float senses[GAITSMITH_SENSES] = {0};
  FILE* file = count == 3 ? fopen(names[1], "rb") : NULL;
  if (!file || gaitsmith_load(&controller, text, fread(text, 1, sizeof text, file), NULL) != GAITSMITH_OK)
    return 1;
  file = freopen(names[2], "r", file);
  gaitsmith_begin(&controller, &state);
  while (file) {
    for (int joint = 0; joint < controller.joints; ++joint) {
      unsigned bits;
      memcpy(&bits, &state.target[joint], sizeof bits);
      printf("%u ", bits);
    }
    printf("%d\n", state.rule);
    for (int i = 0; i < controller.senses; ++i)
      if (fscanf(file, "%f", &senses[i]) != 1) return 0;
    gaitsmith_step(&controller, &state, senses);
  }
  return 1;
}
