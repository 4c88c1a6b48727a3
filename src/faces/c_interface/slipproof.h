/* slipproof from C: exact answers about dry friction.
 *
 * - A call returns a status. Unless that is SLIPPROOF_OK it has written no result, and the error, where a place for one
 * was given, says what is wrong. Every `error` may be NULL.
 * - Numbers come in as doubles, each taken exactly as it is, or as text. They go out as texts that are exact, "3/4",
 * beside the nearest doubles.
 * - Texts are UTF-8. What an object gives out lives as long as it does; whoever received an object frees it. NULL may
 * be freed.
 * - There is no state besides the objects: calls may be made from several threads, and an object be read by several.
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

/* One mistake. No text of it is NULL; what is not known is empty. */
typedef struct slipproof_mistake {
  const char* place; /* the file, or the argument: "W[2][1]", counted from 1 */
  size_t line;       /* of a file, from 1; 0: no place */
  size_t column;     /* in characters, from 1; 0: no place */
  const char* found;
  const char* expected;
  const char* message; /* all of it, "scene.toml:3:5: found ..., expected ..." */
} slipproof_mistake;

/* At least one. An input is read to its end, and all of its mistakes are told, in the order of their places. */
SLIPPROOF_API size_t slipproof_error_count(const slipproof_error* error);
/* From 0; beyond the last one, a mistake with empty texts. */
SLIPPROOF_API slipproof_mistake slipproof_error_mistake(const slipproof_error* error, size_t index);
/* All messages, a line each. */
SLIPPROOF_API const char* slipproof_error_message(const slipproof_error* error);
SLIPPROOF_API void slipproof_error_free(slipproof_error* error);

/* ---- Every motion of a scene ---- */

typedef struct slipproof_solution slipproof_solution;

/* A scene file, of a bicycle or a mechanism: what `slipproof solve` takes. */
SLIPPROOF_API slipproof_status slipproof_solve_file(const char* path, slipproof_solution** solution,
                                                    slipproof_error** error);
/* The same from a text. `name` is how errors call it, and where a relative path of a mechanism counts from. */
SLIPPROOF_API slipproof_status slipproof_solve_text(const char* toml, const char* name, slipproof_solution** solution,
                                                    slipproof_error** error);
SLIPPROOF_API void slipproof_solution_free(slipproof_solution* solution);

/* The document that `slipproof solve --json` prints. Written at the first call; NULL if memory does not suffice. */
SLIPPROOF_API const char* slipproof_solution_json(const slipproof_solution* solution);

/* Numbers from `lower` to `upper`, as exact texts, NULL where infinite, and the nearest doubles. Of one number both are
 * the same, and closed. */
typedef struct slipproof_interval {
  const char* lower;
  const char* upper;
  double nearest_lower;
  double nearest_upper;
  int lower_closed;
  int upper_closed;
} slipproof_interval;

typedef struct slipproof_value {
  const char* name; /* "a", "N2", as the scene's JSON calls it; SI units */
  slipproof_interval range;
} slipproof_value;

/* A motion, with all contact modes that give it; of a continuum, which are infinitely many, its mode. */
typedef struct slipproof_motion {
  const char* const* modes; /* "stick/slip+" */
  size_t mode_count;
  int strict; /* every condition of one of its modes holds strictly */
  int continuum;
  /* At one load: accelerations and forces; a force that is not determined is an interval.
   * In a cell of the partition none: they depend on the load, and the JSON has them. */
  const slipproof_value* values;
  size_t value_count;
} slipproof_motion;

/* A mode, and the loads for which it has a motion. */
typedef struct slipproof_range {
  const char* mode;
  slipproof_interval loads;
} slipproof_range;

/* Loads, one or an open interval, with the same motions throughout. */
typedef struct slipproof_cell {
  slipproof_interval loads;
  const slipproof_motion* motions;
  size_t motion_count;
} slipproof_cell;

/* A mode without a motion at the load. */
typedef struct slipproof_rejection {
  const char* mode;
  const char* violated; /* "N3 >= 0", "gap2 >= 0 against N2 >= 0", or in words why there is none */
  const char* margin;   /* of one condition its left-hand side, negative; NULL where there is none */
} slipproof_rejection;

/* The name of the scene, and its load; NULL where the scene gives none: then there are ranges and cells for all loads.
 */
SLIPPROOF_API const char* slipproof_solution_name(const slipproof_solution* solution);
SLIPPROOF_API const char* slipproof_solution_load(const slipproof_solution* solution);
/* Arrays of `count` elements. Motions, continua behind the others, and rejections are those at the scene's load; cells
 * are there where it has none. */
SLIPPROOF_API const slipproof_motion* slipproof_solution_motions(const slipproof_solution* solution, size_t* count);
SLIPPROOF_API const slipproof_rejection* slipproof_solution_rejections(const slipproof_solution* solution,
                                                                       size_t* count);
SLIPPROOF_API const slipproof_range* slipproof_solution_ranges(const slipproof_solution* solution, size_t* count);
SLIPPROOF_API const slipproof_cell* slipproof_solution_cells(const slipproof_solution* solution, size_t* count);

/* ---- Is an answer to a contact problem right? ---- */

/* w = W z + q. With dimension 1 a linear complementarity problem: z >= 0, w >= 0, z_i w_i = 0. With dimension 2 or 3
 * contacts with friction: z holds the normal part of each contact, then its tangential ones, and w its accelerations or
 * velocities likewise. */
typedef struct slipproof_problem {
  size_t size;      /* of q, a multiple of the dimension */
  size_t dimension; /* 1, 2 or 3; never guessed */
  const double* W;  /* size * size numbers, one row after the other */
  const double* q;
  const double* mu; /* size / dimension coefficients of friction; NULL in dimension 1 */
  const double* z;  /* the answer; NaN and infinities are invalid answers, and no errors */
  const double* w;  /* what the solver says of w; NULL if nothing */
} slipproof_problem;

typedef struct slipproof_certify_options {
  double tolerance;          /* on the relative error of bicycles, 1e-9, and of contact problems, 1e-6; NaN: these */
  double backward_tolerance; /* of problems in space or beyond 64 components instead; NaN: the same as `tolerance` */
  uint64_t effort;           /* operations on words that the judgement may take, about; 0: the usual, a second or two */
  int refine;                /* look for a solution near an answer even if that is wrong */
} slipproof_certify_options;

typedef struct slipproof_verdict slipproof_verdict;

/* What was found. */
typedef struct slipproof_judgement {
  const char* verdict; /* "certified", "wrong", "solution within rho", ...: the words of `slipproof certify` */
  int certified;       /* nothing better could be said: "certified", "solution within rho", "unique" */
  double error; /* upper bound on the largest relative error, of "solution within rho" and "unique" rho; NaN where
                 * no solution near the answer is known */
  double backward_error; /* upper bound; NaN where solutions themselves were compared */
  const char* json;      /* the line that `slipproof certify` prints */
} slipproof_judgement;

/* Up to 64 components in dimension 1 or 2 the answer is compared with all exact solutions ("certified", "ambiguous",
 * "inaccurate", "wrong", ...); larger or spatial problems are judged by enclosures ("solution within rho", "unique",
 * "inaccurate", "eps-solution", "wrong", ...), by the same rule. `options` may be NULL. */
SLIPPROOF_API slipproof_status slipproof_certify(const slipproof_problem* problem,
                                                 const slipproof_certify_options* options, slipproof_verdict** verdict,
                                                 slipproof_error** error);
SLIPPROOF_API slipproof_judgement slipproof_verdict_judgement(const slipproof_verdict* verdict);
SLIPPROOF_API void slipproof_verdict_free(slipproof_verdict* verdict);

/* ---- Many bicycles at once ---- */

/* One number of each bicycle, or with `size` 1 the same for all; with `size` 0 it is not given. */
typedef struct slipproof_column {
  const double* values;
  size_t size;
} slipproof_column;

/* Bicycles on their roads, SI units. All must be given but J, without which no wheel leaves the road. */
typedef struct slipproof_bicycles {
  slipproof_column M, R, h, b2, b3, I1, I2, I3, r1, r2, L, J; /* masses, lengths, moments of inertia */
  slipproof_column f, g, F;                                   /* friction, gravity, force on the pedal */
  int external; /* somebody beside the bicycle pushes the pedal, and not its rider */
} slipproof_bicycles;

/* What a solver says of each bicycle: the acceleration of the frame and all forces, and what else it has. NaN and
 * infinities are invalid answers, and no errors. */
typedef struct slipproof_answers {
  slipproof_column a, S2, S3, N2, N3;
  slipproof_column a_y, phi, eps2, eps3; /* with `size` 0 where the solver has none */
  const uint8_t* modes; /* of each bicycle the mode that is claimed, 4 i + j as below; 255, or NULL: none */
} slipproof_answers;

typedef enum slipproof_record_verdict {
  SLIPPROOF_CERTIFIED = 0,  /* the answer is the one motion, within the tolerance */
  SLIPPROOF_AMBIGUOUS = 1,  /* it is one of several motions */
  SLIPPROOF_INACCURATE = 2, /* the right motion, with an error above the tolerance */
  SLIPPROOF_WRONG = 3,      /* no motion is near */
  SLIPPROOF_INVALID = 4,    /* NaN, infinity, a bicycle outside the domain */
  SLIPPROOF_UNDECIDED = 5   /* it would take more work than the effort allows */
} slipproof_record_verdict;

/* Arrays of `count` elements that receive what was found; those that are NULL are not wanted. */
typedef struct slipproof_judgements {
  uint8_t* verdicts; /* of slipproof_record_verdict */
  uint16_t* modes;   /* of the motion that the answer is, bits as below */
  double* errors;    /* upper bound on the largest relative error, of certified, ambiguous and inaccurate ones */
  uint8_t* tiers;    /* 0 to 2: what decided, as below */
} slipproof_judgements;

/* Is each answer the one motion of its bicycle? As `slipproof certify` judges the same numbers in a table. Of the
 * options `tolerance` and `effort` count; they may be NULL. `threads`: 0 for all there are. */
SLIPPROOF_API slipproof_status slipproof_certify_bicycles(const slipproof_bicycles* bicycles,
                                                          const slipproof_answers* answers, size_t count,
                                                          const slipproof_certify_options* options,
                                                          const slipproof_judgements* judgements, unsigned threads,
                                                          slipproof_error** error);

/* Which contact modes each of `count` bicycles has a motion in: bit 4 i + j for the rear wheel in state i and the front
 * wheel in state j, of stick, slip+, slip-, lift. `strict` may be NULL: of these the modes in which a motion holds all
 * conditions strictly. Adds to `tiers` unless NULL how many were decided by binary64, by double-double, and by exact
 * arithmetic: the answer is the exact one always. `threads`: 0 for all there are. */
SLIPPROOF_API slipproof_status slipproof_consistent_modes(const slipproof_bicycles* bicycles, size_t count,
                                                          uint16_t* consistent, uint16_t* strict, uint64_t tiers[3],
                                                          unsigned threads, slipproof_error** error);

#ifdef __cplusplus
}
#endif

#endif
