/* SPDX-License-Identifier: MIT */
/* Replays recorded senses with core/runtime/gaitsmith.h, and counts steps that differ from the simulator's in any bit:

     replay NAME...

   For each, NAME.json is the controller and NAME.csv what gaitsmith senses wrote. If there is NAME.motion.csv, what
   gaitsmith simulate wrote, joints are moved too, from rest in the drawn pose. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/gaitsmith.h"

/* The content of NAME + ending with a 0 behind it, or NULL. */
static char *content(const char *name, const char *ending, size_t *size) {
  char path[1024], *text = NULL;
  FILE *file;
  long length;
  snprintf(path, sizeof path, "%s%s", name, ending);
  file = fopen(path, "rb");
  if (!file) return NULL;
  fseek(file, 0, SEEK_END);
  length = ftell(file);
  rewind(file);
  text = malloc((size_t)length + 1);
  *size = text ? fread(text, 1, (size_t)length, file) : 0;
  if (text) text[*size] = 0;
  fclose(file);
  return text;
}

/* Reads the numbers of a line. Returns where the next line begins, or NULL. */
static char *row(char *at, float *cells, int most, int *count) {
  for (*count = 0; *at && *at != '\n'; ++*count) {
    char *end;
    const float value = strtof(at, &end);
    if (end == at || *count == most) return NULL;
    cells[*count] = value;
    at = *end == ',' ? end + 1 : end;
  }
  return *at ? at + 1 : at;
}

static int differ(const float *a, const float *b, int count) {
  return memcmp(a, b, (size_t)count * sizeof *a) != 0;
}

static struct {
  long steps, rules, targets, times, angles;
} all;

/* Returns 0, or 1 if the files cannot be used. */
static int replay(const char *name) {
  static gaitsmith_controller controller;
  gaitsmith_state state;
  size_t size = 0, where = 0;
  float cells[256], motion[256], inverse_tau[GAITSMITH_JOINTS], angle[GAITSMITH_JOINTS] = {0}, rate[GAITSMITH_JOINTS] = {0};
  char *json = content(name, ".json", &size), *csv, *moved, *line, *moved_line;
  int error, count, first, j, step, senses;
  if (!json) return 1;
  error = gaitsmith_load(&controller, json, size, &where);
  free(json);
  if (error) {
    fprintf(stderr, "%s.json: error %d at byte %zu\n", name, error, where);
    return 1;
  }
  csv = content(name, ".csv", &size);
  moved = content(name, ".motion.csv", &size);
  line = csv ? strchr(csv, '\n') + 1 : NULL;
  moved_line = moved ? strchr(moved, '\n') + 1 : NULL;
  senses = controller.kind == GAITSMITH_TRAJECTORY ? 0 : controller.senses;
  first = controller.kind == GAITSMITH_NETWORK ? 0 : 1;
  for (step = 0; line && *line; ++step) {
    const float *targets = cells + 3 + senses;
    line = row(line, cells, 256, &count);
    if (!line || count != 3 + senses + 3 * controller.joints) break;
    for (j = 0; step > 0 && j < controller.joints; ++j) gaitsmith_move(&controller, &state, j, &angle[j], &rate[j]);
    if (step == 0) gaitsmith_begin(&controller, &state);
    else gaitsmith_step(&controller, &state, cells + 3);
    for (j = 0; j < controller.joints; ++j) inverse_tau[j] = 1.0f / state.tau[j];
    ++all.steps;
    all.rules += state.rule + first != (int)cells[2];
    all.targets += differ(state.target, targets, controller.joints);
    all.times += differ(inverse_tau, targets + controller.joints, controller.joints) ||
                 differ(state.decay, targets + 2 * controller.joints, controller.joints);
    if (!moved_line || !*moved_line) continue;
    moved_line = row(moved_line, motion, 256, &count);
    all.angles += differ(angle, motion + 8, controller.joints);
  }
  if (!line) fprintf(stderr, "%s.csv: row %d is not as expected\n", name, step);
  error = !line || *line || step == 0;
  free(csv);
  free(moved);
  return error;
}

int main(int count, char **names) {
  int i, failed = 0;
  for (i = 1; i < count; ++i) failed |= replay(names[i]);
  printf("%d controllers, %ld steps; rules differ in %ld, targets in %ld, time constants in %ld, joint angles in %ld\n", count - 1,
         all.steps, all.rules, all.targets, all.times, all.angles);
  return failed || all.steps == 0 || all.rules || all.targets || all.times || all.angles;
}
