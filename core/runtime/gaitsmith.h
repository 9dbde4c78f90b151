/* SPDX-License-Identifier: MIT */
/* Gaitsmith's controllers for games, in C99 and C++: the game moves the figure with its own physics, and
   every 0.01 s the controller says where the joints should go. docs/runtime.md has an example. The bits are
   the same with every compiler, but for -ffast-math. */
#ifndef GAITSMITH_RUNTIME
#define GAITSMITH_RUNTIME

#include <stddef.h>

/* NOLINTBEGIN: C */

enum { GAITSMITH_RULES, GAITSMITH_NETWORK, GAITSMITH_TRAJECTORY };
enum {
  GAITSMITH_OK,
  GAITSMITH_SYNTAX, /* not JSON, or a value of another type */
  GAITSMITH_RANGE,  /* of a number, a word or a list */
  GAITSMITH_SHAPE   /* parts are missing or do not fit together */
};
enum { GAITSMITH_JOINTS = 15, GAITSMITH_SENSES = 43 }; /* at most */

/* Columns of numbers, ordered as members below. */
enum {
  GAITSMITH_MIN,
  GAITSMITH_MAX,
  GAITSMITH_TAU,
  GAITSMITH_DECAY,
  GAITSMITH_THRESHOLD,
  GAITSMITH_EMPTY,
  GAITSMITH_SPAN,
  GAITSMITH_CHARGING,
  GAITSMITH_AT_ZERO,
  GAITSMITH_AT_ONE,
  GAITSMITH_STEP,
  GAITSMITH_PERIOD,
  GAITSMITH_VERSION,
  GAITSMITH_CLIP,
  GAITSMITH_AT_END,
  GAITSMITH_KIND
};

/* Only gaitsmith_load changes it. */
typedef struct {
  int kind, joints, senses, units; /* units: rules, hidden nodes or knots */
  int period, rests;               /* in steps, 0: no timer; whether a trajectory rests then */
  float number[47][16];            /* of the joint, sense, rule and node of this index */
  float target[32][GAITSMITH_JOINTS];
  int intervals[32]; /* of a rule */
  union {
    float when[32][GAITSMITH_SENSES][3]; /* sense, middle, 1 / half-width */
    float weight[47][64];
  } of;
} gaitsmith_controller;

/* What the controller of one figure asks for, and what it remembers. */
typedef struct {
  int rule;                       /* the active one, from 0; number of nodes that fire; nearest knot */
  float target[GAITSMITH_JOINTS]; /* from the drawn pose [rad], or length */
  float tau[GAITSMITH_JOINTS];    /* time constant [s] */
  float decay[GAITSMITH_JOINTS];  /* e^(-step / tau) */
  int steps;                      /* within the period */
  float input[64], charge[47];
} gaitsmith_state;

typedef struct {
  const char *at, *end;
  int error, joints, inputs, count[6];
  long each; /* what every joint has */
} gaitsmith_reader;

static inline int gaitsmith_fail(gaitsmith_reader* r, int error) {
  if (!r->error) r->error = error;
  r->end = r->at;
  return 0;
}

/* Passes over a character. */
static inline int gaitsmith_is(gaitsmith_reader* r, char wanted) {
  return r->at != r->end && *r->at == wanted ? ++r->at, 1 : 0;
}

static inline int gaitsmith_next(gaitsmith_reader* r, char wanted) {
  while (gaitsmith_is(r, ' ') || gaitsmith_is(r, '\n') || gaitsmith_is(r, '\r') || gaitsmith_is(r, '\t')) {
  }
  return gaitsmith_is(r, wanted);
}

static inline int gaitsmith_take(gaitsmith_reader* r, char wanted) {
  return gaitsmith_next(r, wanted) || gaitsmith_fail(r, GAITSMITH_SYNTAX);
}

/* Whether a list or an object goes on. */
static inline int gaitsmith_more(gaitsmith_reader* r, char close, int* count) {
  return !gaitsmith_next(r, close) && (!(*count)++ || gaitsmith_take(r, ',')) && !r->error;
}

/* Reads a string. Returns its place in a list of words, or -1. */
static inline int gaitsmith_word(gaitsmith_reader* r, const char* words) {
  gaitsmith_take(r, '"');
  const char* word = r->at;
  for (; !gaitsmith_is(r, '"'); ++r->at) {
    gaitsmith_is(r, '\\');
    if (r->at == r->end) return gaitsmith_fail(r, GAITSMITH_SYNTAX) - 1;
  }
  const ptrdiff_t size = r->at - 1 - word;
  for (int place = 0; *words; ++place) {
    ptrdiff_t same = 0;
    while (same < size && words[same] > ' ' && words[same] == word[same]) ++same;
    words += same;
    if (same == size && *words <= ' ') return place;
    while (*words && *words++ != ' ') {
    }
  }
  return -1;
}

static inline int gaitsmith_digits(gaitsmith_reader* r, double* value) {
  int count = 0;
  for (; r->at != r->end && *r->at >= '0' && *r->at <= '9'; ++count)
    *value = *value * 10.0 + (*r->at++ - '0');
  return count;
}

/* Reads a number. Up to 15 digits are exact. */
static inline float gaitsmith_number(gaitsmith_reader* r, double low, double high) {
  double value = 0.0, power = 0.0;
  const int negative = gaitsmith_next(r, '-');
  int digits = gaitsmith_digits(r, &value), shift = 0;
  if (digits && gaitsmith_is(r, '.')) shift = -(digits = gaitsmith_digits(r, &value));
  if (digits && (gaitsmith_is(r, 'e') || gaitsmith_is(r, 'E'))) {
    const int down = !gaitsmith_is(r, '+') && gaitsmith_is(r, '-');
    digits = gaitsmith_digits(r, &power);
    if (power > 999.0) power = 999.0;
    shift += down ? -(int)power : (int)power;
  }
  if (!digits) return (float)gaitsmith_fail(r, GAITSMITH_SYNTAX);
  for (; shift > 0; --shift) value *= 10.0;
  for (; shift < 0; ++shift) value /= 10.0;
  if (negative) value = -value;
  if (value >= low && value <= high) return (float)value;
  return (float)gaitsmith_fail(r, GAITSMITH_RANGE);
}

/* Reads as many numbers as are known; -1: not known yet. */
static inline void gaitsmith_numbers(gaitsmith_reader* r, float* out, int* known, int most, double largest) {
  int count = 0;
  gaitsmith_take(r, '[');
  while (gaitsmith_more(r, ']', &count)) {
    if (count > most)
      gaitsmith_fail(r, GAITSMITH_RANGE);
    else
      out[count - 1] = gaitsmith_number(r, -largest, largest);
  }
  if (*known < 0) *known = count;
  if (*known != count) gaitsmith_fail(r, GAITSMITH_SHAPE);
}

/* Passes over a value. */
static inline void gaitsmith_skip(gaitsmith_reader* r) {
  int depth = 0;
  do {
    if (gaitsmith_next(r, '[') || gaitsmith_is(r, '{'))
      ++depth;
    else if (gaitsmith_is(r, ']') || gaitsmith_is(r, '}'))
      --depth;
    else if (r->at == r->end)
      gaitsmith_fail(r, GAITSMITH_SYNTAX);
    else if (*r->at == '"')
      gaitsmith_word(r, "");
    else
      ++r->at;
  } while (depth > 0 && !r->error);
  while (r->at != r->end && *r->at > ' ' && *r->at != ',' && *r->at != '}') ++r->at;
}

/* Reads the whole, or a joint, sense, rule or node. Returns its members, as bits. */
static inline long gaitsmith_object(gaitsmith_reader* r, gaitsmith_controller* c, int slot, long allowed) {
  static const char* const words[] = {"none above both", "repeat rest", "rules network trajectory"};
  static const double low[] = {-3.15, -3.15, 0.01, 0, -3.15, -3.15, -6.3, 0, -1e30, -1e30, 0.001, 2, 1},
                      high[] = {3.15, 3.15, 100, 1, 3.15, 3.15, 6.3, 1, 1e30, 1e30, 1, 1e6, 1};
  static const int most[] = {GAITSMITH_SENSES, 32, GAITSMITH_JOINTS, GAITSMITH_SENSES, 32, 47};
  static const long parts[] = {0x7f, 0x2300, 0x5000c, 0x20080}; /* of a joint, sense, rule, node */
  long seen = 0;
  int count = 0, n, three = 3;
  gaitsmith_take(r, '{');
  while (gaitsmith_more(r, '}', &count)) {
    const int member = gaitsmith_word(
        r,
        "min_rad max_rad tau_s decay threshold_rad empty_rad span_rad charging at_zero at_one step_s "
        "period_steps "
        "version clip at_end kind targets_rad weights when knots_rad joints senses rules nodes");
    const int list = member - 18;
    gaitsmith_take(r, ':');
    if (member < 0) {
      gaitsmith_skip(r);
      continue;
    }
    seen |= 1L << member;
    if (!(allowed >> member & 1)) gaitsmith_fail(r, GAITSMITH_SHAPE);
    if (r->error) break;
    if (member < GAITSMITH_CLIP) {
      c->number[slot][member] = gaitsmith_number(r, low[member], high[member]);
    } else if (member <= GAITSMITH_KIND) {
      n = gaitsmith_word(r, words[member - GAITSMITH_CLIP]);
      if (n < 0) n = gaitsmith_fail(r, GAITSMITH_RANGE);
      c->number[slot][member] = (float)n;
    } else if (list == -2) {
      gaitsmith_numbers(r, c->target[slot], &r->joints, GAITSMITH_JOINTS, 3.15);
    } else if (list == -1) {
      gaitsmith_numbers(r, c->of.weight[slot], &r->inputs, 64, 2);
    } else {
      gaitsmith_take(r, '[');
      for (n = 0; gaitsmith_more(r, ']', &n);) {
        if (n > most[list])
          gaitsmith_fail(r, GAITSMITH_RANGE);
        else if (list == 0)
          gaitsmith_numbers(r, c->of.when[slot][n - 1], &three, 3, 1e6);
        else if (list == 1)
          gaitsmith_numbers(r, c->target[n - 1], &r->joints, GAITSMITH_JOINTS, 3.15);
        else {
          const long has = gaitsmith_object(r, c, n - 1, parts[list - 2]);
          if (list == 2)
            r->each &= has;
          else if (has != parts[list - 2])
            gaitsmith_fail(r, GAITSMITH_SHAPE);
        }
      }
      *(list ? &r->count[list] : &c->intervals[slot]) = n;
    }
  }
  return seen;
}

/* Reads size bytes of JSON. Returns GAITSMITH_OK, or why it cannot be used.
   where: out, or NULL: the byte of the error */
static inline int gaitsmith_load(gaitsmith_controller* c, const char* text, size_t size, size_t* where) {
  static const long members[] = {0x709400, 0xb09400, 0x38dc0c}; /* of each kind */
  gaitsmith_reader reader = {text, text + (size < 1000000 ? size : 1000000), GAITSMITH_OK, -1, -1, {0}, 0x7f},
                   *r = &reader;
  for (size_t i = 0; i < sizeof *c; ++i) ((char*)c)[i] = 0;
  const long seen = gaitsmith_object(r, c, 0, 0xf8dc0c);
  if (!gaitsmith_next(r, 0) && r->at != r->end) gaitsmith_fail(r, GAITSMITH_SYNTAX);
  c->kind = (int)c->number[0][GAITSMITH_KIND];
  c->rests = (int)c->number[0][GAITSMITH_AT_END];
  c->period = (int)c->number[0][GAITSMITH_PERIOD];
  c->joints = r->count[2];
  c->senses = r->count[3];
  c->units = c->kind == GAITSMITH_RULES     ? r->count[4]
             : c->kind == GAITSMITH_NETWORK ? r->count[5] - c->joints
                                            : r->count[1];
  int fits = (seen & (c->kind ? -1 : ~0x800)) == members[c->kind] && c->units > 0 &&
             (r->joints < 0 || r->joints == c->joints) && (r->each & 3) == 3 &&
             (float)c->period == c->number[0][GAITSMITH_PERIOD];
  if (c->kind == GAITSMITH_NETWORK)
    fits = fits && r->each == 0x7f && r->inputs == c->senses + c->units && c->joints <= c->senses;
  if (c->kind == GAITSMITH_RULES && c->period) fits = fits && c->senses == 1;
  for (int rule = 0; fits && !c->kind && rule < c->units; ++rule)
    for (int k = 0; k < c->intervals[rule]; ++k) {
      const float sense = c->of.when[rule][k][0];
      fits = fits && sense >= 0.0f && sense < (float)c->senses && (float)(int)sense == sense;
    }
  if (!fits) gaitsmith_fail(r, GAITSMITH_SHAPE);
  size_t at = 0; /* counted: gcc 12 warns of a difference if the text is freed next */
  while (text + at != r->at) ++at;
  if (where) *where = at;
  return r->error;
}

/* A reading, in the unit that the JSON says, as the controller senses it. */
static inline float gaitsmith_normalise(const gaitsmith_controller* c, int sense, float reading) {
  const float *of = c->number[sense], width = of[GAITSMITH_AT_ONE] - of[GAITSMITH_AT_ZERO];
  const float value = width > 0.0f ? (reading - of[GAITSMITH_AT_ZERO]) * (1.0f / width) : 0.0f;
  if (of[GAITSMITH_CLIP] > 0.0f && !(value < 1.0f)) return 1.0f;
  return of[GAITSMITH_CLIP] > 1.0f && !(value > 0.0f) ? 0.0f : value;
}

/* The first rule whose intervals hold the senses most deeply; if none does, the active one. */
static inline void gaitsmith_choose(const gaitsmith_controller* c, gaitsmith_state* s, const float* senses) {
  float least = 1.00000011920928955078125f; /* just outside */
  for (int rule = 0; rule < c->units; ++rule) {
    float off = 0.0f;
    for (int i = 0; i < c->intervals[rule]; ++i) {
      const float* when = c->of.when[rule][i];
      float from = senses[(int)when[0]] - when[1];
      from = (from < 0.0f ? -from : from) * when[2];
      if (from > off) off = from;
    }
    if (off < least) {
      least = off;
      s->rule = rule;
    }
  }
}

/* Advances the nodes of a network, each from the outputs of the step before. */
static inline void gaitsmith_think(const gaitsmith_controller* c, gaitsmith_state* s, const float* senses) {
  const int touches = c->senses - c->joints;
  for (int i = 0; i < c->senses; ++i)
    s->input[i] = senses[i] > (i < touches ? 0.0f : c->number[i - touches][GAITSMITH_THRESHOLD]);
  for (int i = 0; i < c->units + c->joints; ++i) {
    const float step = c->number[i][GAITSMITH_CHARGING];
    float sum = 0.0f;
    for (int k = 0; k < c->senses + c->units; ++k)
      if (s->input[k] > 0.0f) sum += c->of.weight[i][k];
    const float charge = s->charge[i] + (sum > 0.0f ? step : -step);
    s->charge[i] = charge < 1.0f ? charge > 0.0f ? charge : 0.0f : 1.0f;
  }
  s->rule = 0;
  for (int i = 0; i < c->units; ++i) {
    float* output = &s->input[c->senses + i];
    if (s->charge[i] >= 1.0f) *output = 1.0f;
    if (s->charge[i] <= 0.0f) *output = 0.0f;
    s->rule += *output > 0.0f;
  }
}

/* The weight of a cubic B-spline's knot. Volatile: no fused multiply-add. */
static inline double gaitsmith_near(double x) {
  volatile double square = 6.0 * x * x, cube = 3.0 * x * x * x;
  return (4.0 - square + cube) / 6.0;
}

/* Sets targets and time constants. A trajectory's are of the middle of the next step. */
static inline void gaitsmith_ask(const gaitsmith_controller* c, gaitsmith_state* s) {
  const int n = c->units;
  const double rate = (double)(c->rests ? n - 1 : n) / (c->period ? c->period : 1), now = s->steps + 0.5;
  volatile double place = s->steps * rate;
  volatile float product;
  int first = (int)(place + 0.5);
  if (c->kind == GAITSMITH_TRAJECTORY) s->rule = first % n;
  place = (c->rests && now > c->period ? c->period : now) * rate;
  first = (int)place;
  const double x = place - first, y = 1.0 - x;
  const double weight[] = {y * y * y / 6.0, gaitsmith_near(x), gaitsmith_near(y), x * x * x / 6.0};
  for (int j = 0; j < c->joints; ++j) {
    const float* of = c->number[c->kind == GAITSMITH_RULES ? s->rule : c->kind == GAITSMITH_NETWORK ? j : 0];
    float target = c->kind == GAITSMITH_RULES ? c->target[s->rule][j] : 0.0f;
    if (c->kind == GAITSMITH_NETWORK) {
      product = of[GAITSMITH_SPAN] * s->charge[n + j];
      target = of[GAITSMITH_EMPTY] + product;
    }
    for (int i = 0; c->kind == GAITSMITH_TRAJECTORY && i < 4; ++i) {
      int k = first - 1 + i;
      k = !c->rests ? (k + n) % n : k < 0 ? -k : k < n ? k : 2 * (n - 1) - k; /* mirrored */
      product = c->target[k < 0 ? 0 : k < n ? k : n - 1][j] * (float)weight[i];
      target += product;
    }
    s->target[j] = target;
    s->tau[j] = of[GAITSMITH_TAU];
    s->decay[j] = of[GAITSMITH_DECAY];
  }
}

/* Takes over, with the first rule, at time 0. */
static inline void gaitsmith_begin(const gaitsmith_controller* c, gaitsmith_state* s) {
  for (size_t i = 0; i < sizeof *s; ++i) ((char*)s)[i] = 0;
  gaitsmith_ask(c, s);
}

/* Decides, after each step of the physics. senses: in the order of the JSON; unused with a timer */
static inline void gaitsmith_step(const gaitsmith_controller* c, gaitsmith_state* s, const float* senses) {
  if (c->period && ++s->steps >= c->period) s->steps = c->rests ? c->period : 0;
  const float timer = (float)s->steps / (float)(c->period ? c->period : 1);
  if (c->kind == GAITSMITH_RULES) gaitsmith_choose(c, s, c->period ? &timer : senses);
  if (c->kind == GAITSMITH_NETWORK) gaitsmith_think(c, s, senses);
  gaitsmith_ask(c, s);
}

/* Moves a joint as Gaitsmith's strong joints move in a step. angle [rad], rate [rad/s]: in and out */
static inline void gaitsmith_move(const gaitsmith_controller* c, const gaitsmith_state* s, int joint,
                                  float* angle, float* rate) {
  const float *limit = c->number[joint], hurry = 1.0f / s->tau[joint], off = *angle - s->target[joint];
  volatile float pull = off * hurry, product;
  pull = (*rate + pull) * c->number[0][GAITSMITH_STEP];
  product = (off + pull) * s->decay[joint];
  const float now = s->target[joint] + product;
  product = pull * hurry;
  *rate = (*rate - product) * s->decay[joint];
  *angle = now < limit[0] ? limit[0] : now > limit[1] ? limit[1] : now;
  if (*angle != now || (*rate < 1e-9f && *rate > -1e-9f)) *rate = 0.0f;
}

/* NOLINTEND */

#endif
