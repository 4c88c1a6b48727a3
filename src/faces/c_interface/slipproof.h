/* slipproof from C: exact answers about dry friction.
 *
 * - A call returns a status. If it is not SLIPPROOF_OK, the call has written no result, and `*error` says what is
 *   wrong. Every `error` may be NULL.
 * - Numbers are passed as doubles, each taken exactly as it is, or as texts. They are returned as exact texts, "3/4",
 *   together with the nearest doubles.
 * - Texts are UTF-8. The arrays and texts of an object live as long as the object. The caller frees each object that it
 *   receives; NULL may be freed.
 * - There is no state outside the objects: several threads may make calls, and may read the same object.
 */
#ifndef SLIPPROOF_H
#define SLIPPROOF_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define SLIPPROOF_API __attribute__((visibility("default")))
#else
#define SLIPPROOF_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum slipproof_status {
  SLIPPROOF_OK = 0,
  SLIPPROOF_BAD_ARGUMENT = 2, /* a null pointer, a size that does not fit, a number outside its domain */
  SLIPPROOF_BAD_INPUT = 3,    /* a file or a text */
  SLIPPROOF_NO_MEMORY = 7,
  SLIPPROOF_FAILED = 8 /* anything else: please report it */
} slipproof_status;

/* "0.2.0". */
SLIPPROOF_API const char* slipproof_version(void);

/* ---- Errors ---- */

typedef struct slipproof_error slipproof_error;

/* One mistake. Its texts are never NULL; a text that is not known is empty. */
typedef struct slipproof_mistake {
  const char* place; /* the file, or the argument: "W[2][1]", counted from 1 */
  size_t line;       /* in the file, from 1; 0: no place */
  size_t column;     /* in characters, from 1; 0: no place */
  const char* found;
  const char* expected;
  const char* message; /* the complete message, "scene.toml:3:5: found ..., expected ..." */
} slipproof_mistake;

/* The number of mistakes, at least 1. An input is read to its end, and all its mistakes are reported, by place. */
SLIPPROOF_API size_t slipproof_error_count(const slipproof_error* error);
/* `index` counts from 0; for an index beyond the last, returns a mistake with empty texts. */
SLIPPROOF_API slipproof_mistake slipproof_error_mistake(const slipproof_error* error, size_t index);
/* All messages, one on each line. */
SLIPPROOF_API const char* slipproof_error_message(const slipproof_error* error);
SLIPPROOF_API void slipproof_error_free(slipproof_error* error);

/* ---- Every motion of a scene ---- */

typedef struct slipproof_solution slipproof_solution;

/* Solves a scene file of a bicycle or a mechanism, as `slipproof solve` does. */
SLIPPROOF_API slipproof_status slipproof_solve_file(const char* path, slipproof_solution** solution,
                                                    slipproof_error** error);
/* The same from a text. `name` is its name in errors; a relative path of a mechanism starts from there. */
SLIPPROOF_API slipproof_status slipproof_solve_text(const char* toml, const char* name, slipproof_solution** solution,
                                                    slipproof_error** error);
SLIPPROOF_API void slipproof_solution_free(slipproof_solution* solution);

/* The document that `slipproof solve --json` prints. Written at the first call; NULL if memory does not suffice. */
SLIPPROOF_API const char* slipproof_solution_json(const slipproof_solution* solution);

/* The numbers from `lower` to `upper`: exact texts, NULL if infinite, and the nearest doubles. For a single number both
 * ends are the same, and closed. */
typedef struct slipproof_interval {
  const char* lower;
  const char* upper;
  double nearest_lower;
  double nearest_upper;
  int lower_closed;
  int upper_closed;
} slipproof_interval;

typedef struct slipproof_value {
  const char* name; /* "a", "N2", as in the scene's JSON; SI units */
  slipproof_interval range;
} slipproof_value;

/* A motion, with all contact modes that give it; or a continuum of infinitely many motions, with its mode. */
typedef struct slipproof_motion {
  const char* const* modes; /* "stick/slip+" */
  size_t mode_count;
  int strict; /* every condition of one of its modes holds strictly */
  int continuum;
  /* Accelerations and forces at one load; a force that is not determined is an interval.
   * Empty in a cell of the partition: there they depend on the load, and the JSON has them. */
  const slipproof_value* values;
  size_t value_count;
} slipproof_motion;

/* A mode, and the loads for which it has a motion. */
typedef struct slipproof_range {
  const char* mode;
  slipproof_interval loads;
} slipproof_range;

/* One load, or an open interval of loads, with the same motions throughout. */
typedef struct slipproof_cell {
  slipproof_interval loads;
  const slipproof_motion* motions;
  size_t motion_count;
} slipproof_cell;

/* A mode without a motion at the load. */
typedef struct slipproof_rejection {
  const char* mode;
  const char* violated; /* "N3 >= 0", "gap2 >= 0 against N2 >= 0", or in words why there is no motion */
  const char* margin;   /* for a single condition its left-hand side, which is negative; otherwise NULL */
} slipproof_rejection;

/* The name of the scene, and its load; the load is NULL if the scene gives none. Then there are ranges and cells for
 * all loads. */
SLIPPROOF_API const char* slipproof_solution_name(const slipproof_solution* solution);
SLIPPROOF_API const char* slipproof_solution_load(const slipproof_solution* solution);
/* Arrays of `count` elements. Motions (continua come last) and rejections are those at the scene's load; cells exist if
 * the scene has no load. */
SLIPPROOF_API const slipproof_motion* slipproof_solution_motions(const slipproof_solution* solution, size_t* count);
SLIPPROOF_API const slipproof_rejection* slipproof_solution_rejections(const slipproof_solution* solution,
                                                                       size_t* count);
SLIPPROOF_API const slipproof_range* slipproof_solution_ranges(const slipproof_solution* solution, size_t* count);
SLIPPROOF_API const slipproof_cell* slipproof_solution_cells(const slipproof_solution* solution, size_t* count);

/* ---- Is an answer to a contact problem right? ---- */

/* w = W z + q. Dimension 1 is a linear complementarity problem: z >= 0, w >= 0, z_i w_i = 0. In dimension 2 or 3 there
 * are contacts with friction: for each contact z has its normal force, then its tangential forces, and w has its
 * accelerations or velocities in the same order. */
typedef struct slipproof_problem {
  size_t size;      /* number of components, a multiple of the dimension */
  size_t dimension; /* 1, 2 or 3; never guessed */
  const double* W;  /* size * size numbers, one row after the other */
  const double* q;
  const double* mu; /* size / dimension coefficients of friction; NULL in dimension 1 */
  const double* z;  /* the answer; NaN and infinities make it invalid, but are not errors */
  const double* w;  /* the w of the solver; NULL if it gives none */
} slipproof_problem;

typedef struct slipproof_certify_options {
  double tolerance;          /* on the relative error; NaN: 1e-9 for bicycles, 1e-6 for contact problems */
  double backward_tolerance; /* for problems in space or beyond 64 components; NaN: same as `tolerance` */
  uint64_t effort;           /* about how many operations on words are allowed; 0: the usual, a second or two */
  int refine;                /* look for a solution near an answer even if the answer is wrong */
  int all;                   /* find all solutions in space, with a proof that there are no others: `all` of `json` */
} slipproof_certify_options;

typedef struct slipproof_verdict slipproof_verdict;

/* The result of a judgement. */
typedef struct slipproof_judgement {
  const char* verdict; /* "certified", "wrong", "solution within rho", ...: the words of `slipproof certify` */
  int certified;       /* the verdict is one of the best: "certified", "solution within rho", "unique",
                        * "velocities within rho", "velocities of a solution within rho" */
  double error; /* upper bound on the largest relative error; rho for "solution within rho" and "unique"; NaN if no
                 * solution near the answer is known */
  double backward_error; /* upper bound; NaN if the answer was compared with solutions */
  const char* json;      /* the line that `slipproof certify` prints */
} slipproof_judgement;

/* Judges the answer to a problem. With up to 64 components in dimension 1 or 2, the answer is compared with all exact
 * solutions ("certified", "ambiguous", "inaccurate", "wrong", ...). Larger or spatial problems are judged by enclosures
 * ("solution within rho", "unique", "inaccurate", "not converged", "eps-solution", "wrong", ...), by the same rule.
 * `options` may be NULL. */
SLIPPROOF_API slipproof_status slipproof_certify(const slipproof_problem* problem,
                                                 const slipproof_certify_options* options, slipproof_verdict** verdict,
                                                 slipproof_error** error);
SLIPPROOF_API slipproof_judgement slipproof_verdict_judgement(const slipproof_verdict* verdict);
SLIPPROOF_API void slipproof_verdict_free(slipproof_verdict* verdict);

/* The same without the texts. `verdict` is a text that is never freed. */
typedef struct slipproof_result {
  const char* verdict;
  int certified;
  double error;
  double backward_error;
} slipproof_result;

/* Judges the answers to `count` problems, which may differ in size and share their arrays: results[i] is of
 * problems[i]. A problem that cannot be judged makes the call fail; the error's argument is its number, from 1,
 * "problems[3].mu". `threads`: 0 for all cores. */
SLIPPROOF_API slipproof_status slipproof_certify_many(const slipproof_problem* problems, size_t count,
                                                      const slipproof_certify_options* options,
                                                      slipproof_result* results, unsigned threads,
                                                      slipproof_error** error);

/* ---- Many bicycles at once ---- */

/* One number for each bicycle; if `size` is 1, the same for all; if it is 0, the number is not given. */
typedef struct slipproof_column {
  const double* values;
  size_t size;
} slipproof_column;

/* Bicycles on their roads, in SI units. All columns must be given except J; without J no wheel leaves the road. */
typedef struct slipproof_bicycles {
  slipproof_column M, R, h, b2, b3, I1, I2, I3, r1, r2, L, J; /* masses, lengths, moments of inertia */
  slipproof_column f, g, F;                                   /* friction, gravity, force on the pedal */
  int external; /* somebody next to the bicycle pushes the pedal, not its rider */
} slipproof_bicycles;

/* A solver's answers about the bicycles: the acceleration of the frame, all forces, and optional numbers. NaN and
 * infinities make an answer invalid, but are not errors. */
typedef struct slipproof_answers {
  slipproof_column a, S2, S3, N2, N3;
  slipproof_column a_y, phi, eps2, eps3; /* `size` is 0 if the solver has none */
  const uint8_t* modes; /* for each bicycle the mode that is claimed, 4 i + j as below; 255 or NULL: none */
} slipproof_answers;

typedef enum slipproof_record_verdict {
  SLIPPROOF_CERTIFIED = 0,  /* the answer is the one motion, within the tolerance */
  SLIPPROOF_AMBIGUOUS = 1,  /* it is one of several motions */
  SLIPPROOF_INACCURATE = 2, /* the right motion, with an error above the tolerance */
  SLIPPROOF_WRONG = 3,      /* no motion is near */
  SLIPPROOF_INVALID = 4,    /* NaN, infinity, a bicycle outside the domain */
  SLIPPROOF_UNDECIDED = 5   /* it would take more work than the effort allows */
} slipproof_record_verdict;

/* Arrays of `count` elements that receive the results; those that are NULL are not filled. */
typedef struct slipproof_judgements {
  uint8_t* verdicts; /* values of slipproof_record_verdict */
  uint16_t* modes;   /* modes of the motion that the answer is, as bits as below */
  double* errors;    /* upper bound on the largest relative error, if certified, ambiguous or inaccurate */
  uint8_t* tiers;    /* what decided: 0 binary64, 1 exact arithmetic */
} slipproof_judgements;

/* Is each answer the one motion of its bicycle? Gives the verdicts of `slipproof certify` on the same numbers in a
 * table. `options` may be NULL; only `tolerance` and `effort` are used. `threads`: 0 for all cores. */
SLIPPROOF_API slipproof_status slipproof_certify_bicycles(const slipproof_bicycles* bicycles,
                                                          const slipproof_answers* answers, size_t count,
                                                          const slipproof_certify_options* options,
                                                          const slipproof_judgements* judgements, unsigned threads,
                                                          slipproof_error** error);

/* The contact modes in which each of `count` bicycles has a motion: bit 4 i + j for the rear wheel in state i and the
 * front wheel in state j, of stick, slip+, slip-, lift. `strict` receives those in which a motion meets all conditions
 * strictly; it may be NULL. Adds to `tiers`, unless it is NULL, how many bicycles were decided by binary64 and by exact
 * arithmetic; the answer is always the exact one. `threads`: 0 for all cores. */
SLIPPROOF_API slipproof_status slipproof_consistent_modes(const slipproof_bicycles* bicycles, size_t count,
                                                          uint16_t* consistent, uint16_t* strict, uint64_t tiers[2],
                                                          unsigned threads, slipproof_error** error);

#ifdef __cplusplus
}
#endif

#endif
