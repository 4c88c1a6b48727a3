/* What the programs that let cubes fall share: the scene, their arguments, and what an engine does to the cubes in a
 * step as slipproof_record.h takes it. C99 and C++. */
#ifndef BOXES_H
#define BOXES_H

#include <slipproof_record.h>
#include <time.h>

enum { boxes = 4, most_contacts = 64, velocities = 6 * boxes, floor_plane = -1 };
static const double side = 0.2, box_mass = 1, inertia = 0.2 * 0.2 / 6, gravity = 9.81;

/* Where a box begins: its centre, and a turn about the diagonal (1, 1, 0) by an angle. */
static inline double start(int box, double at[3]) {
  const int falls = box == boxes - 1;
  at[0] = falls ? 0.5 : 0, at[1] = 0;
  at[2] = falls ? 0.5 : side / 2 + (side + 0.005) * box;
  return falls ? 0.5 : 0;
}

/* A step: M v = J^T r + f. */
typedef struct boxes_step {
  size_t contacts;
  double M[velocities][velocities], f[velocities], v[velocities];
  double J[3 * most_contacts][velocities], mu[most_contacts];
  double r[3 * most_contacts], compliance[3 * most_contacts], bias[3 * most_contacts];
} boxes_step;

/* Before the step: the velocities of a box, and what gravity makes of them. */
static inline void set_before(boxes_step* step, int box, const double linear[3], const double angular[3], double h) {
  for (int i = 0; i < 3; ++i) {
    const int along = 6 * box + i, about = along + 3;
    step->M[along][along] = box_mass, step->M[about][about] = inertia; /* of a cube: the same about every axis */
    step->f[along] = box_mass * (linear[i] - (i == 2 ? h * gravity : 0)), step->f[about] = inertia * angular[i];
  }
}

static inline void set_after(boxes_step* step, int box, const double linear[3], const double angular[3]) {
  for (int i = 0; i < 3; ++i) step->v[6 * box + i] = linear[i], step->v[6 * box + 3 + i] = angular[i];
}

/* One side of a contact: rows along the axes at an arm from the centre of a box, which the other side has with -1. */
static inline void add_side(boxes_step* step, int box, double sign, const double arm[3], double axes[3][3]) {
  for (int k = 0; k < 3 && box != floor_plane; ++k) {
    double* row = step->J[3 * step->contacts + (size_t)k] + 6 * box;
    const double* a = axes[k];
    for (int i = 0; i < 3; ++i) {
      row[i] = sign * a[i];
      row[3 + i] = sign * (arm[(i + 1) % 3] * a[(i + 2) % 3] - arm[(i + 2) % 3] * a[(i + 1) % 3]);
    }
  }
}

/* Ends a contact whose sides are there; impulses along its three axes, of which the first is the normal. */
static inline void add_contact(boxes_step* step, double mu, const double r[3], double compliance, double bias) {
  const size_t k = step->contacts++;
  step->mu[k] = mu, step->bias[3 * k] = bias;
  for (size_t i = 3 * k; i < 3 * k + 3; ++i) step->r[i] = r[i - 3 * k], step->compliance[i] = compliance;
}

/* A law with a compliance or a bias of 0 is written with them all the same. */
static inline int record_boxes(slipproof_recorder* recorder, const boxes_step* made, slipproof_record_law law) {
  slipproof_record_step step;
  memset(&step, 0, sizeof step);
  step.dimension = 3, step.contacts = made->contacts, step.mu = made->mu;
  step.bodies = velocities, step.M = &made->M[0][0], step.J = &made->J[0][0], step.f = made->f, step.v = made->v;
  step.r = made->r, step.law = law, step.compliance = made->compliance, step.bias = made->bias;
  step.force_unit = "N s", step.velocity_unit = "m/s";
  if (slipproof_record(recorder, &step) == SLIPPROOF_RECORD_OK) return 0;
  fprintf(stderr, "%s\n", slipproof_record_mistake(recorder));
  return 1;
}

/* FILE.jsonl [STEPS [ITERATIONS [WORST]]]: ITERATIONS of the engine, 0: as many as it makes by default; WORST: how many
 * steps are kept, 0: all. */
typedef struct arguments {
  const char* file;
  int steps, iterations, worst;
} arguments;

static inline int read_arguments(int argc, char** argv, arguments* read) {
  int* const numbers[] = {&read->steps, &read->iterations, &read->worst};
  read->file = argv[1], read->steps = 100, read->iterations = 0, read->worst = 0;
  for (int i = 2; i < argc && i < 5; ++i) {
    char* end;
    const long value = strtol(argv[i], &end, 10);
    if (end == argv[i] || *end || value < 0 || value > 1000000000)
      return fprintf(stderr, "found %s, expected a whole number\n", argv[i]), 2;
    *numbers[i - 2] = (int)value;
  }
  if (argc < 2 || argc > 5) return fprintf(stderr, "usage: %s FILE.jsonl [STEPS [ITERATIONS [WORST]]]\n", argv[0]), 2;
  return 0;
}

/* Seconds of the processor. */
static inline double now(void) {
  return (double)clock() / CLOCKS_PER_SEC;
}

/* Closes the file, and tells how long both took. */
static inline int finish(slipproof_recorder* recorder, const arguments* given, double engine, double recording) {
  const double begin = now();
  if (slipproof_record_close(recorder)) return perror(given->file), 1;
  fprintf(stderr, "%d steps: engine %.3f s, recording %.3f s\n", given->steps, engine, recording + now() - begin);
  return 0;
}

#endif
