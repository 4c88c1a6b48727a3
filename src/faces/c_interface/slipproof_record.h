/* slipproof_record.h: writes what a solver of contact was given and answered, step by step, to a file that
 * `slipproof certify FILE.jsonl` judges. One header, C99 or C++, nothing to link with.
 *
 *   slipproof_recorder recorder;
 *   if (slipproof_record_open(&recorder, "steps.jsonl", 0) != SLIPPROOF_RECORD_OK) ...   // 0: every step
 *   ...
 *   slipproof_record_step step = {0};                 // in each step of the engine: what is not set is not there
 *   step.dimension = 3;  step.contacts = n;  step.mu = mu;
 *   step.W = W;  step.q = q;  step.r = impulses;      // u = W r + q, rows of contact k from 3 k on, the normal first
 *   slipproof_record(&recorder, &step);
 *   ...
 *   if (slipproof_record_close(&recorder) != SLIPPROOF_RECORD_OK) ...
 *
 * If contacts approach, `impact` names the law of impact, with `restitution` and the velocities before the step.
 *
 * A step holds W r + q by one of three: `W`, dense; `entries` of it; or `bodies`, M v = J^T r + f with u = J v + w. Any
 * consistent units will do; impulses with velocities, or forces with accelerations. NaN and infinities are written as
 * they are: they are answers, and wrong ones.
 *
 * A recorder is used by one thread at a time. Memory: the text of one step, and with `worst` the texts of so many. */
#ifndef SLIPPROOF_RECORD_H
#define SLIPPROOF_RECORD_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum slipproof_record_status {
  SLIPPROOF_RECORD_OK = 0,
  SLIPPROOF_RECORD_BAD_STEP = 1,    /* something is missing, negative, or given twice: see slipproof_record_mistake() */
  SLIPPROOF_RECORD_NOT_WRITTEN = 2, /* the file cannot be opened, written or closed: see errno */
  SLIPPROOF_RECORD_NO_MEMORY = 3
} slipproof_record_status;

/* The law that the solver solves: src/contact/formats/LAWS.md. */
typedef enum slipproof_record_law {
  SLIPPROOF_LAW_COULOMB,
  SLIPPROOF_LAW_BOX,
  SLIPPROOF_LAW_DIAMOND,
  SLIPPROOF_LAW_FIXED, /* needs `bounds` */
  SLIPPROOF_LAW_ASSOCIATED,
  SLIPPROOF_LAW_REGULARISED /* needs `slip_speed` */
} slipproof_record_law;

/* The law of impact, if contacts approach. Newton's restores e times the velocity of approach where a contact
 * approaches, Moreau's e times the velocity at all contacts; both a tangential velocity, too. */
typedef enum slipproof_record_impact {
  SLIPPROOF_IMPACT_NONE,
  SLIPPROOF_IMPACT_NEWTON,
  SLIPPROOF_IMPACT_MOREAU
} slipproof_record_impact;

/* An entry of W, row and column from 0, none twice. */
typedef struct slipproof_record_entry {
  size_t row, column;
  double value;
} slipproof_record_entry;

/* n = dimension * contacts components. Zero what is not used. Arrays belong to the caller and are not kept. */
typedef struct slipproof_record_step {
  int dimension; /* 1: normal parts only, without mu; 2 or 3 */
  size_t contacts;
  const double* mu;                      /* of each contact; none in dimension 1 */
  const double* W;                       /* n x n, row by row */
  const slipproof_record_entry* entries; /* or the entries of W that are not 0 */
  size_t entry_count;
  size_t bodies;   /* or bodies: so many velocities, 6 for each body in space */
  const double* M; /* their masses, bodies x bodies, row by row */
  const double* J; /* n x bodies, row by row: u = J v + w */
  const double* f; /* M v = J^T r + f: M times the old velocities, and the step times what pushes */
  const double* w; /* n, or none for 0 */
  const double* v; /* the new velocities */
  const double* q; /* n, with W or entries */
  const double* r; /* the answer, n impulses or forces */
  const double* u; /* n velocities W r + q, if the solver gives them */
  slipproof_record_law law;
  const double* compliance;             /* n, or none: the solver's u has R r added; see LAWS.md */
  const double* bias;                   /* n, or none: and this */
  const double* bounds;                 /* contacts * (dimension - 1) */
  slipproof_record_impact impact;       /* with the next ones, or none of them */
  const double* restitution;            /* of each contact, from 0 to 1 */
  const double* tangential_restitution; /* the same, or none for 0 */
  const double* u_before;               /* n velocities of contacts before the step, with W or entries */
  const double* v_before;               /* velocities of bodies before the step, with bodies */
  double slip_speed;
  int soft;               /* regularised by s / sqrt(1 + s^2), not by min(s, 1) */
  const char* title;      /* "step 17"; none: the number of the step. Printable ASCII without quotes and backslashes */
  const char* force_unit; /* both or none */
  const char* velocity_unit;
} slipproof_record_step;

typedef struct slipproof_record_text {
  char* data;
  size_t size, room;
  int failed; /* memory */
} slipproof_record_text;

typedef struct slipproof_record_kept {
  double residual;
  size_t number;
  slipproof_record_text line;
} slipproof_record_kept;

/* Its members are its own. */
typedef struct slipproof_recorder {
  FILE* file;
  slipproof_record_kept* kept; /* the worst so far, in no order */
  size_t worst, kept_count, steps;
  const char* mistake;
} slipproof_recorder;

/* What was wrong with the last step; an empty text where nothing was. */
static inline const char* slipproof_record_mistake(const slipproof_recorder* recorder) {
  return recorder->mistake ? recorder->mistake : "";
}

/* Opens the file; one that is there is replaced. `worst`: how many of the steps are kept, those of the largest
 * residual, which are written at the end, by number; 0: all, each as it comes. */
static inline slipproof_record_status slipproof_record_open(slipproof_recorder* recorder, const char* path,
                                                            size_t worst) {
  memset(recorder, 0, sizeof *recorder);
  recorder->worst = worst;
  if (worst > 0) {
    recorder->kept = (slipproof_record_kept*)calloc(worst, sizeof *recorder->kept);
    if (!recorder->kept) return SLIPPROOF_RECORD_NO_MEMORY;
  }
  recorder->file = fopen(path, "w");
  if (recorder->file) return SLIPPROOF_RECORD_OK;
  free(recorder->kept);
  recorder->kept = NULL;
  return SLIPPROOF_RECORD_NOT_WRITTEN;
}

static inline void slipproof_record_add(slipproof_record_text* text, const char* data, size_t size) {
  if (text->failed) return;
  if (text->size + size + 1 > text->room) {
    size_t room = 2 * (text->size + size) + 64;
    char* larger = (char*)realloc(text->data, room);
    if (!larger) {
      text->failed = 1;
      return;
    }
    text->data = larger;
    text->room = room;
  }
  memcpy(text->data + text->size, data, size);
  text->size += size;
  text->data[text->size] = 0;
}

static inline void slipproof_record_word(slipproof_record_text* text, const char* word) {
  slipproof_record_add(text, word, strlen(word));
}

static inline void slipproof_record_count(slipproof_record_text* text, size_t value) {
  char digits[32];
  size_t first = sizeof digits;
  do digits[--first] = (char)('0' + value % 10);
  while ((value /= 10) > 0);
  slipproof_record_add(text, digits + first, sizeof digits - first);
}

/* What is no small integer becomes a hexadecimal text, "0x1.8p-3": the same binary64 again, in every locale, and many
 * times as fast as 17 decimal digits. */
static inline void slipproof_record_number(slipproof_record_text* text, double value) {
  static const char digits[] = "0123456789abcdef";
  uint64_t bits, fraction;
  int exponent;
  if (value != value) {
    slipproof_record_word(text, "NaN");
    return;
  }
  if (value > 1.7976931348623157e308 || value < -1.7976931348623157e308) {
    slipproof_record_word(text, value > 0 ? "Infinity" : "-Infinity");
    return;
  }
  if (value > -1e6 && value < 1e6 && value == (double)(long)value) {
    if (signbit(value)) slipproof_record_add(text, "-", 1);
    slipproof_record_count(text, (size_t)(value < 0 ? -value : value));
    return;
  }
  memcpy(&bits, &value, sizeof bits);
  fraction = bits << 12;
  exponent = (int)(bits >> 52 & 0x7ff);
  slipproof_record_word(text, value < 0 ? "\"-0x" : "\"0x");
  slipproof_record_word(text, exponent > 0 ? "1" : "0");
  if (fraction > 0) slipproof_record_add(text, ".", 1);
  for (; fraction > 0; fraction <<= 4) slipproof_record_add(text, &digits[fraction >> 60], 1);
  exponent = (exponent > 0 ? exponent : 1) - 1023;
  slipproof_record_word(text, exponent < 0 ? "p-" : "p");
  slipproof_record_count(text, (size_t)(exponent < 0 ? -exponent : exponent));
  slipproof_record_add(text, "\"", 1);
}

static inline void slipproof_record_list(slipproof_record_text* text, const double* values, size_t count) {
  size_t i;
  slipproof_record_word(text, "[");
  for (i = 0; i < count; ++i) {
    if (i > 0) slipproof_record_word(text, ",");
    slipproof_record_number(text, values[i]);
  }
  slipproof_record_word(text, "]");
}

static inline void slipproof_record_key(slipproof_record_text* text, const char* key) {
  slipproof_record_word(text, text->size > 1 ? ",\"" : "\"");
  slipproof_record_word(text, key);
  slipproof_record_word(text, "\":");
}

static inline void slipproof_record_vector(slipproof_record_text* text, const char* key, const double* values,
                                           size_t count) {
  if (!values && count > 0) return;
  slipproof_record_key(text, key);
  slipproof_record_list(text, values, count);
}

/* By its entries that are not 0; `across`: its rows are the columns of what is written. */
static inline void slipproof_record_matrix(slipproof_record_text* text, const char* key, const double* values,
                                           size_t rows, size_t columns, int across) {
  size_t i, j, written = 0;
  slipproof_record_key(text, key);
  slipproof_record_word(text, "{\"rows\":");
  slipproof_record_count(text, across ? columns : rows);
  slipproof_record_word(text, ",\"columns\":");
  slipproof_record_count(text, across ? rows : columns);
  slipproof_record_word(text, ",\"entries\":[");
  for (i = 0; i < rows; ++i) {
    for (j = 0; j < columns; ++j) {
      double value = values[i * columns + j];
      if (value == 0) continue;
      slipproof_record_word(text, written++ ? ",[" : "[");
      slipproof_record_count(text, across ? j : i);
      slipproof_record_word(text, ",");
      slipproof_record_count(text, across ? i : j);
      slipproof_record_word(text, ",");
      slipproof_record_number(text, value);
      slipproof_record_word(text, "]");
    }
  }
  slipproof_record_word(text, "]}");
}

static inline void slipproof_record_entries(slipproof_record_text* text, const slipproof_record_step* step, size_t n) {
  size_t k;
  slipproof_record_key(text, "W");
  slipproof_record_word(text, "{\"rows\":");
  slipproof_record_count(text, n);
  slipproof_record_word(text, ",\"columns\":");
  slipproof_record_count(text, n);
  slipproof_record_word(text, ",\"entries\":[");
  for (k = 0; k < step->entry_count; ++k) {
    slipproof_record_word(text, k > 0 ? ",[" : "[");
    slipproof_record_count(text, step->entries[k].row);
    slipproof_record_word(text, ",");
    slipproof_record_count(text, step->entries[k].column);
    slipproof_record_word(text, ",");
    slipproof_record_number(text, step->entries[k].value);
    slipproof_record_word(text, "]");
  }
  slipproof_record_word(text, "]}");
}

static inline int slipproof_record_plain(const char* text) {
  for (; text && *text; ++text) {
    if (*text < ' ' || *text > '~' || *text == '"' || *text == '\\') return 0;
  }
  return 1;
}

static inline int slipproof_record_are_shares(const double* values, size_t count) {
  size_t k;
  for (k = 0; k < count && values; ++k) {
    if (!(values[k] >= 0 && values[k] <= 1)) return 0;
  }
  return 1;
}

/* What is wrong with the impact of a step; none if nothing is. */
static inline const char* slipproof_record_check_impact(const slipproof_record_step* step) {
  if ((int)step->impact < SLIPPROOF_IMPACT_NONE || (int)step->impact > SLIPPROOF_IMPACT_MOREAU)
    return "impact: expected a law of impact";
  if (step->impact == SLIPPROOF_IMPACT_NONE) {
    const int given = step->restitution || step->tangential_restitution || step->u_before || step->v_before;
    return given ? "impact: expected a law with restitution, u_before or v_before" : NULL;
  }
  if (step->contacts > 0 && !step->restitution)
    return "restitution: expected one for each contact with a law of impact";
  if (!slipproof_record_are_shares(step->restitution, step->contacts) ||
      !slipproof_record_are_shares(step->tangential_restitution, step->contacts))
    return "restitution: expected numbers from 0 to 1";
  if (step->contacts > 0 && step->bodies == 0 && (!step->u_before || step->v_before))
    return "u_before: expected with W or entries, without v_before";
  if (step->bodies > 0 && (!step->v_before || step->u_before))
    return "v_before: expected with bodies, without u_before";
  return NULL;
}

/* What is wrong with a step; none if nothing is. */
static inline const char* slipproof_record_check(const slipproof_record_step* step) {
  const int forms = (step->W != NULL) + (step->entries != NULL) + (step->bodies > 0);
  size_t k, n = step->contacts * (size_t)(step->dimension > 0 ? step->dimension : 0);
  if (step->dimension < 1 || step->dimension > 3) return "dimension: expected 1, 2 or 3";
  if (forms != 1 && step->contacts > 0) return "expected one of W, entries and bodies";
  if (step->bodies > 0 && (!step->M || !step->J || !step->f || !step->v)) return "bodies: expected M, J, f and v";
  if (step->bodies > 0 && step->dimension == 1)
    return "bodies: expected dimension 2 or 3, with mu 0 where there is none";
  if (step->bodies == 0 && !step->q && step->contacts > 0) return "q: expected with W or entries";
  if (!step->r && step->contacts > 0) return "r: expected the answer";
  if ((int)step->law < SLIPPROOF_LAW_COULOMB || (int)step->law > SLIPPROOF_LAW_REGULARISED) return "law: expected one";
  if (step->dimension > 1 && !step->mu && step->contacts > 0)
    return "mu: expected a coefficient of friction for each contact";
  if (step->dimension == 1 && step->mu) return "mu: expected none in dimension 1";
  if ((step->law == SLIPPROOF_LAW_FIXED) != (step->bounds != NULL))
    return "bounds: expected with the law of fixed bounds";
  if (step->law == SLIPPROOF_LAW_REGULARISED && !(step->slip_speed > 0)) return "slip_speed: expected more than 0";
  if (!step->force_unit != !step->velocity_unit) return "units: expected both or none";
  if (!slipproof_record_plain(step->title) || !slipproof_record_plain(step->force_unit) ||
      !slipproof_record_plain(step->velocity_unit)) {
    return "title and units: expected printable ASCII without quotes and backslashes";
  }
  for (k = 0; k < step->entry_count && step->entries; ++k) {
    if (step->entries[k].row >= n || step->entries[k].column >= n) return "entries: expected rows and columns below n";
  }
  for (k = 0; k < step->contacts && step->mu; ++k) {
    if (!(step->mu[k] >= 0 && step->mu[k] < HUGE_VAL)) return "mu: expected no negative number, and no infinity";
  }
  for (k = 0; k < n && step->compliance; ++k) {
    if (!(step->compliance[k] >= 0)) return "compliance: expected no negative number";
  }
  for (k = 0; k + step->contacts < n && step->bounds; ++k) {
    if (!(step->bounds[k] >= 0)) return "bounds: expected no negative number";
  }
  return slipproof_record_check_impact(step);
}

static inline void slipproof_record_add_impact(slipproof_record_text* text, const slipproof_record_step* step) {
  if (step->impact == SLIPPROOF_IMPACT_NONE) return;
  slipproof_record_key(text, "impact");
  slipproof_record_word(text, step->impact == SLIPPROOF_IMPACT_NEWTON ? "\"newton\"" : "\"moreau\"");
  slipproof_record_vector(text, "restitution", step->restitution, step->contacts);
  if (step->tangential_restitution)
    slipproof_record_vector(text, "tangential_restitution", step->tangential_restitution, step->contacts);
  if (step->bodies > 0)
    slipproof_record_vector(text, "v_before", step->v_before, step->bodies);
  else
    slipproof_record_vector(text, "u_before", step->u_before, (size_t)step->dimension * step->contacts);
}

static inline void slipproof_record_line(slipproof_record_text* text, const slipproof_record_step* step,
                                         size_t number) {
  static const char* const laws[] = {"coulomb", "box", "diamond", "fixed", "associated", "regularised"};
  const size_t d = (size_t)step->dimension, n = d * step->contacts;
  slipproof_record_word(text, "{");
  slipproof_record_key(text, "title");
  slipproof_record_word(text, "\"");
  if (step->title) {
    slipproof_record_word(text, step->title);
  } else {
    slipproof_record_word(text, "step ");
    slipproof_record_count(text, number);
  }
  slipproof_record_word(text, "\"");
  if (d > 1) {
    slipproof_record_key(text, "dimension");
    slipproof_record_count(text, d);
  }
  if (step->bodies > 0) {
    slipproof_record_matrix(text, "M", step->M, step->bodies, step->bodies, 0);
    slipproof_record_matrix(text, "H", step->J, n, step->bodies, 1);
    slipproof_record_vector(text, "f", step->f, step->bodies);
    slipproof_record_key(text, "w");
    if (step->w) {
      slipproof_record_list(text, step->w, n);
    } else {
      size_t i;
      for (i = 0; i < n; ++i) slipproof_record_word(text, i > 0 ? ",0" : "[0");
      slipproof_record_word(text, n > 0 ? "]" : "[]");
    }
    slipproof_record_vector(text, "v", step->v, step->bodies);
  } else {
    if (step->W) {
      slipproof_record_matrix(text, "W", step->W, n, n, 0);
    } else {
      slipproof_record_entries(text, step, n);
    }
    slipproof_record_vector(text, "q", step->q, n);
  }
  if (d > 1) slipproof_record_vector(text, "mu", step->mu, step->contacts);
  slipproof_record_key(text, "law");
  slipproof_record_word(text, "\"");
  slipproof_record_word(text, laws[step->law]);
  slipproof_record_word(text, "\"");
  if (step->compliance) slipproof_record_vector(text, "compliance", step->compliance, n);
  if (step->bias) slipproof_record_vector(text, "bias", step->bias, n);
  if (step->bounds) slipproof_record_vector(text, "bounds", step->bounds, step->contacts * (d - 1));
  if (step->law == SLIPPROOF_LAW_REGULARISED) {
    slipproof_record_key(text, "slip_speed");
    slipproof_record_number(text, step->slip_speed);
    slipproof_record_key(text, "function");
    slipproof_record_word(text, step->soft ? "\"soft\"" : "\"linear\"");
  }
  slipproof_record_add_impact(text, step);
  slipproof_record_vector(text, "r", step->r, n);
  if (step->u) slipproof_record_vector(text, "u", step->u, n);
  if (step->force_unit) {
    slipproof_record_key(text, "units");
    slipproof_record_word(text, "{\"force\":\"");
    slipproof_record_word(text, step->force_unit);
    slipproof_record_word(text, "\",\"velocity\":\"");
    slipproof_record_word(text, step->velocity_unit);
    slipproof_record_word(text, "\"}");
  }
  slipproof_record_word(text, "}\n");
}

/* What the law of impact adds to component `row` of u, in floating point. */
static inline double slipproof_record_restored(const slipproof_record_step* step, size_t row) {
  const size_t d = (size_t)step->dimension, contact = row / d;
  const double* e = row % d == 0 ? step->restitution : step->tangential_restitution;
  double before;
  size_t j;
  if (step->impact == SLIPPROOF_IMPACT_NONE || !e) return 0;
  before = step->bodies == 0 ? step->u_before[row] : step->w ? step->w[row] : 0;
  for (j = 0; j < step->bodies; ++j) before += step->J[row * step->bodies + j] * step->v_before[j];
  if (row % d == 0 && step->impact == SLIPPROOF_IMPACT_NEWTON && before > 0) return 0;
  return e[contact] * before;
}

/* Component `row` of the law's u, in floating point, and how much it changes with its own force. */
static inline double slipproof_record_velocity(const slipproof_record_step* step, size_t row, double* change) {
  const size_t n = (size_t)step->dimension * step->contacts;
  double u = 0;
  size_t j;
  *change = 0;
  if (step->bodies > 0) {
    u = step->w ? step->w[row] : 0;
    for (j = 0; j < step->bodies; ++j) {
      const double a = step->J[row * step->bodies + j], m = step->M[j * step->bodies + j];
      u += a * step->v[j];
      if (m > 0) *change += a * a / m;
    }
  } else {
    u = step->q[row];
    for (j = 0; j < n && step->W; ++j) u += step->W[row * n + j] * step->r[j];
    if (step->W) *change = step->W[row * n + row];
    for (j = 0; j < step->entry_count && !step->W; ++j) {
      const slipproof_record_entry* e = &step->entries[j];
      if (e->row != row) continue;
      u += e->value * step->r[e->column];
      if (e->column == row) *change = e->value;
    }
  }
  if (step->compliance) {
    u += step->compliance[row] * step->r[row];
    *change += step->compliance[row];
  }
  if (step->bias) u += step->bias[row];
  return u + slipproof_record_restored(step, row);
}

static inline double slipproof_record_clamped(double x, double bound) {
  return x < -bound ? -bound : x > bound ? bound : x;
}

/* How far the forces of a contact are from where a step of projection takes them, as a velocity: 0 where they obey the
 * law. A guess of what certify finds, to choose steps by; NaN is worse than everything. */
static inline double slipproof_record_residual_of(const slipproof_record_step* step, size_t contact) {
  const size_t d = (size_t)step->dimension, first = d * contact;
  const double mu = step->mu ? step->mu[contact] : 0;
  double to[3] = {0, 0, 0}, u[3] = {0, 0, 0}, scale = 0, length = 0, speed = 0, worst = 0, bound;
  size_t i;
  for (i = 0; i < d; ++i) {
    double change;
    u[i] = slipproof_record_velocity(step, first + i, &change);
    if (change > scale) scale = change;
  }
  if (!(scale > 0)) scale = 1;
  for (i = 0; i < d; ++i) to[i] = step->r[first + i] - u[i] / scale;
  for (i = 1; i < d; ++i) {
    length += to[i] * to[i];
    speed += u[i] * u[i];
  }
  length = sqrt(length);
  speed = sqrt(speed);
  if (step->law == SLIPPROOF_LAW_ASSOCIATED && length > mu * to[0]) to[0] = (to[0] + mu * length) / (1 + mu * mu);
  if (!(to[0] > 0) && to[0] == to[0]) to[0] = 0;
  bound = mu * to[0];
  for (i = 1; i < d; ++i) {
    if (step->law == SLIPPROOF_LAW_FIXED) {
      to[i] = slipproof_record_clamped(to[i], step->bounds[(d - 1) * contact + i - 1]);
    } else if (step->law == SLIPPROOF_LAW_BOX) {
      to[i] = slipproof_record_clamped(to[i], bound);
    } else if (step->law == SLIPPROOF_LAW_REGULARISED) {
      const double slip = step->soft ? sqrt(speed * speed + step->slip_speed * step->slip_speed)
                                     : (speed > step->slip_speed ? speed : step->slip_speed);
      to[i] = -bound * u[i] / slip;
    } else if (length > bound) {
      to[i] *= bound / length;
    }
  }
  for (i = 0; i < d; ++i) {
    const double off = fabs(to[i] - step->r[first + i]) * scale;
    if (!(off <= worst)) worst = off;
    if (worst != worst) return worst;
  }
  return worst;
}

static inline double slipproof_record_residual(const slipproof_record_step* step) {
  double worst = 0;
  size_t k, i, j;
  for (k = 0; k < step->contacts; ++k) {
    const double own = slipproof_record_residual_of(step, k);
    if (!(own <= worst)) worst = own;
    if (worst != worst) return HUGE_VAL;
  }
  for (i = 0; i < step->bodies; ++i) { /* the balance of bodies, as a velocity */
    double sum = -step->f[i], mass = step->M[i * step->bodies + i];
    for (j = 0; j < step->bodies; ++j) sum += step->M[i * step->bodies + j] * step->v[j];
    for (j = 0; j < (size_t)step->dimension * step->contacts; ++j) sum -= step->J[j * step->bodies + i] * step->r[j];
    sum = fabs(mass > 0 ? sum / mass : sum);
    if (!(sum <= worst)) worst = sum;
    if (worst != worst) return HUGE_VAL;
  }
  return worst;
}

/* Writes a step, or keeps it for the end. A step that is refused leaves everything as it was. */
static inline slipproof_record_status slipproof_record(slipproof_recorder* recorder,
                                                       const slipproof_record_step* step) {
  slipproof_record_text line = {NULL, 0, 0, 0};
  recorder->mistake = slipproof_record_check(step);
  if (recorder->mistake) return SLIPPROOF_RECORD_BAD_STEP;
  if (recorder->worst == 0) {
    int written;
    slipproof_record_line(&line, step, recorder->steps + 1);
    written = !line.failed && fwrite(line.data, 1, line.size, recorder->file) == line.size;
    free(line.data);
    if (line.failed) return SLIPPROOF_RECORD_NO_MEMORY;
    ++recorder->steps;
    return written ? SLIPPROOF_RECORD_OK : SLIPPROOF_RECORD_NOT_WRITTEN;
  }
  {
    const double residual = slipproof_record_residual(step);
    size_t place = recorder->kept_count, i;
    ++recorder->steps;
    if (recorder->kept_count == recorder->worst) {
      place = 0;
      for (i = 1; i < recorder->worst; ++i) {
        if (recorder->kept[i].residual < recorder->kept[place].residual) place = i;
      }
      if (residual <= recorder->kept[place].residual) return SLIPPROOF_RECORD_OK;
    }
    slipproof_record_line(&line, step, recorder->steps);
    if (line.failed) {
      free(line.data);
      return SLIPPROOF_RECORD_NO_MEMORY;
    }
    free(recorder->kept[place].line.data);
    recorder->kept[place].residual = residual;
    recorder->kept[place].number = recorder->steps;
    recorder->kept[place].line = line;
    if (place == recorder->kept_count) ++recorder->kept_count;
  }
  return SLIPPROOF_RECORD_OK;
}

static inline int slipproof_record_earlier(const void* a, const void* b) {
  const size_t x = ((const slipproof_record_kept*)a)->number, y = ((const slipproof_record_kept*)b)->number;
  return x < y ? -1 : x > y;
}

/* Writes what was kept, and closes. Without it the steps that were kept are lost. */
static inline slipproof_record_status slipproof_record_close(slipproof_recorder* recorder) {
  int written = recorder->file != NULL;
  size_t i;
  if (recorder->kept_count > 0) {
    qsort(recorder->kept, recorder->kept_count, sizeof *recorder->kept, slipproof_record_earlier);
  }
  for (i = 0; i < recorder->kept_count; ++i) {
    const slipproof_record_text* line = &recorder->kept[i].line;
    written = written && fwrite(line->data, 1, line->size, recorder->file) == line->size;
    free(line->data);
  }
  free(recorder->kept);
  if (recorder->file && fclose(recorder->file) != 0) written = 0;
  memset(recorder, 0, sizeof *recorder);
  return written ? SLIPPROOF_RECORD_OK : SLIPPROOF_RECORD_NOT_WRITTEN;
}

#ifdef __cplusplus
}
#endif

#endif
