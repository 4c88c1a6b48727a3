/* Records what MuJoCo solves: a box on the floor that is pushed, with elliptic cones, by MuJoCo's own law, which is the
 * associated one with a compliance R and a bias, minus the reference acceleration.
 *
 *   steps_of_mujoco FILE.jsonl [STEPS]       then: slipproof certify FILE.jsonl */
#include <mujoco/mujoco.h>
#include <slipproof_record.h>

static const char scene[] =
    "<mujoco><option timestep='0.002' cone='elliptic' solver='Newton' jacobian='dense' iterations='200'"
    " tolerance='1e-14'/><worldbody><geom type='plane' size='5 5 1' condim='3' friction='0.5'/>"
    "<body pos='0 0 0.1'><freejoint/><geom type='box' size='0.2 0.2 0.1' mass='1' condim='3' friction='0.5'/></body>"
    "</worldbody></mujoco>";

static void* allocated(size_t count, size_t size) {
  void* memory = calloc(count > 0 ? count : 1, size);
  if (!memory) fputs("out of memory\n", stderr), exit(1);
  return memory;
}

/* The constraints of one step that are contacts in three directions, as bodies with Jacobians: accelerations, forces.
 */
static int record(slipproof_recorder* recorder, const mjModel* m, const mjData* d) {
  const size_t nv = (size_t)m->nv, n = 3 * (size_t)d->ncon;
  double* M = allocated(nv * nv, sizeof(double));
  double *J = allocated(n * nv, sizeof(double)), *mu = allocated(n, sizeof(double));
  double *r = allocated(n, sizeof(double)), *R = allocated(n, sizeof(double)), *bias = allocated(n, sizeof(double));
  slipproof_record_step step = {0};
  mj_fullM(m, M, d->qM);
  for (int k = 0; k < d->ncon; ++k) {
    const int first = d->contact[k].efc_address;
    mu[k] = d->contact[k].friction[0];
    for (int i = 0; i < 3; ++i) {
      const size_t row = (size_t)(3 * k + i);
      memcpy(J + row * nv, d->efc_J + (size_t)(first + i) * nv, nv * sizeof(double));
      r[row] = d->efc_force[first + i];
      R[row] = d->efc_R[first + i];
      bias[row] = -d->efc_aref[first + i];
    }
  }
  step.dimension = 3, step.contacts = (size_t)d->ncon, step.mu = mu;
  step.bodies = nv, step.M = M, step.J = J, step.f = d->qfrc_smooth, step.v = d->qacc;
  step.r = r, step.law = SLIPPROOF_LAW_ASSOCIATED, step.compliance = R, step.bias = bias;
  step.force_unit = "N", step.velocity_unit = "m/s^2";
  const int status = slipproof_record(recorder, &step);
  if (status) fprintf(stderr, "%s\n", slipproof_record_mistake(recorder));
  free(M), free(J), free(mu), free(r), free(R), free(bias);
  return status;
}

int main(int argc, char** argv) {
  char error[500] = "", path[] = "steps_of_mujoco.xml";
  if (argc < 2) return fputs("usage: steps_of_mujoco FILE.jsonl [STEPS]\n", stderr), 2;
  const int steps = argc > 2 ? atoi(argv[2]) : 200;
  static mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, path, (int)sizeof scene - 1);
  memcpy(files.filedata[0], scene, sizeof scene - 1);
  mjModel* m = mj_loadXML(path, &files, error, sizeof error);
  if (!m) return fprintf(stderr, "%s\n", error), 1;
  mjData* d = mj_makeData(m);
  slipproof_recorder recorder;
  if (slipproof_record_open(&recorder, argv[1], 5)) return perror(argv[1]), 1; /* the worst five */
  for (int i = 0; i < steps; ++i) {
    d->xfrc_applied[6] = i < steps / 2 ? 4 : 6; /* friction holds 4.9 */
    mj_step1(m, d);
    mj_step2(m, d);
    if (d->ncon > 0 && record(&recorder, m, d)) return 1;
  }
  mj_deleteData(d);
  mj_deleteModel(m);
  return slipproof_record_close(&recorder) ? (perror(argv[1]), 1) : 0;
}
