/* Records what MuJoCo solves: cubes that fall on a plane, with elliptic cones, by MuJoCo's own law, which is the
 * associated one with a compliance R and a bias, minus the reference acceleration.
 *
 *   steps_of_mujoco FILE.jsonl [STEPS [ITERATIONS [WORST]]]     then: slipproof certify FILE.jsonl */
#include <mujoco/mujoco.h>

#include "boxes.h"

/* The scene as MuJoCo reads it. */
static size_t describe(char* text, size_t room) {
  size_t size = (size_t)snprintf(
      text, room,
      "<mujoco><option timestep='0.002' cone='elliptic' solver='Newton' jacobian='dense'/>"
      "<size nconmax='%d' njmax='%d'/><worldbody><geom type='plane' size='5 5 1' condim='3' friction='0.5'/>",
      most_contacts, 3 * most_contacts);
  for (int i = 0; i < boxes; ++i) {
    double at[3];
    const double angle = start(i, at);
    size += (size_t)snprintf(
        text + size, room - size,
        "<body pos='%.17g %.17g %.17g' axisangle='1 1 0 %.17g'><freejoint/><geom type='box' size='%.17g "
        "%.17g %.17g' mass='%.17g' condim='3' friction='0.5'/></body>",
        at[0], at[1], at[2], angle * 180 / mjPI, side / 2, side / 2, side / 2, box_mass);
  }
  return size + (size_t)snprintf(text + size, room - size, "</worldbody></mujoco>");
}

/* The constraints of one step, all of them contacts in three directions: accelerations and forces. */
static int record(slipproof_recorder* recorder, const mjModel* m, const mjData* d) {
  static double M[velocities * velocities], mu[most_contacts], bias[3 * most_contacts];
  slipproof_record_step step = {0};
  mj_fullM(m, M, d->qM);
  for (int k = 0; k < d->ncon; ++k) {
    if (d->contact[k].efc_address >= 0) mu[step.contacts++] = d->contact[k].friction[0]; /* others do not touch yet */
  }
  for (int row = 0; row < d->nefc; ++row) bias[row] = -d->efc_aref[row];
  step.dimension = 3, step.mu = mu;
  step.bodies = velocities, step.M = M, step.J = d->efc_J, step.f = d->qfrc_smooth, step.v = d->qacc;
  step.r = d->efc_force, step.law = SLIPPROOF_LAW_ASSOCIATED, step.compliance = d->efc_R, step.bias = bias;
  step.force_unit = "N", step.velocity_unit = "m/s^2";
  if (slipproof_record(recorder, &step) == SLIPPROOF_RECORD_OK) return 0;
  fprintf(stderr, "%s\n", slipproof_record_mistake(recorder));
  return 1;
}

static mjModel* load(void) {
  static mjVFS files;
  static char text[8000];
  char error[500] = "", path[] = "steps_of_mujoco.xml";
  const size_t size = describe(text, sizeof text);
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, path, (int)size);
  memcpy(files.filedata[0], text, size);
  mjModel* m = mj_loadXML(path, &files, error, sizeof error);
  if (!m) fprintf(stderr, "%s\n", error);
  return m;
}

int main(int argc, char** argv) {
  arguments given;
  slipproof_recorder recorder;
  double engine = 0, recording = 0;
  if (read_arguments(argc, argv, &given)) return 2;
  mjModel* m = load();
  if (!m) return 1;
  if (given.iterations > 0) m->opt.iterations = given.iterations, m->opt.tolerance = 0;
  mjData* d = mj_makeData(m);
  if (slipproof_record_open(&recorder, given.file, (size_t)given.worst)) return perror(given.file), 1;
  for (int i = 0; i < given.steps; ++i) {
    const double begin = now();
    mj_step1(m, d);
    mj_step2(m, d);
    const double stepped = now();
    if (record(&recorder, m, d)) return 1;
    engine += stepped - begin, recording += now() - stepped;
  }
  mj_deleteData(d);
  mj_deleteModel(m);
  return finish(&recorder, &given, engine, recording);
}
