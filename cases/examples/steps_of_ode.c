/* Records what ODE solves: a cube on the floor that is pushed, by quick steps with few and with many iterations. Its
 * law is the box pyramid, with a compliance (CFM) and a bias (ERP) of each contact.
 *
 *   steps_of_ode FILE.jsonl [ITERATIONS]     then: slipproof certify FILE.jsonl */
#include <ode/ode.h>
#include <slipproof_record.h>

enum { most = 8, velocities = 6 };
static const double step = 1.0 / 64, mu = 0.5, mass = 1, side = 0.2, cfm = 1e-5, erp = 0.2;

/* u = J v of a contact at `place` of the body: rows along its normal and the two directions of friction. */
static void rows_of(const dContact* c, const double* center, double (*rows)[velocities]) {
  double axes[3][3], arm[3];
  for (int i = 0; i < 3; ++i)
    arm[i] = c->geom.pos[i] - center[i], axes[0][i] = c->geom.normal[i], axes[1][i] = c->fdir1[i];
  dCalcVectorCross3(axes[2], axes[0], axes[1]);
  for (int i = 0; i < 3; ++i) {
    memcpy(rows[i], axes[i], sizeof axes[i]);
    dCalcVectorCross3(rows[i] + 3, arm, axes[i]);
  }
}

int main(int argc, char** argv) {
  if (argc < 2) return fputs("usage: steps_of_ode FILE.jsonl [ITERATIONS]\n", stderr), 2;
  slipproof_recorder recorder;
  if (slipproof_record_open(&recorder, argv[1], 0)) return perror(argv[1]), 1;
  dInitODE();
  const dWorldID world = dWorldCreate();
  dWorldSetGravity(world, 0, 0, -10);
  dWorldSetCFM(world, cfm), dWorldSetERP(world, erp);
  dWorldSetQuickStepNumIterations(world, argc > 2 ? atoi(argv[2]) : 20);
  const dBodyID body = dBodyCreate(world);
  dMass m;
  dMassSetBoxTotal(&m, mass, side, side, side);
  dBodySetMass(body, &m);
  dBodySetPosition(body, 0, 0, side / 2);
  const dGeomID box = dCreateBox(0, side, side, side), floor = dCreatePlane(0, 0, 0, 1, 0);
  dGeomSetBody(box, body);
  const dJointGroupID group = dJointGroupCreate(0);
  for (int i = 0; i < 16; ++i) {
    dContact contacts[most];
    dJointFeedback forces[most];
    const int count = dCollide(box, floor, most, &contacts[0].geom, sizeof *contacts);
    double J[3 * most][velocities], M[velocities][velocities] = {{0}}, f[velocities], v[velocities], coefficients[most];
    double r[3 * most], R[3 * most], bias[3 * most] = {0}, center[3];
    for (int j = 0; j < 3; ++j) {
      M[j][j] = mass, M[3 + j][3 + j] = m.I[0]; /* of a cube: the same about every axis */
      center[j] = dBodyGetPosition(body)[j];
      v[j] = dBodyGetLinearVel(body)[j], v[3 + j] = dBodyGetAngularVel(body)[j];
    }
    for (int k = 0; k < count; ++k) {
      dContact* c = &contacts[k];
      memset(&c->surface, 0, sizeof c->surface);
      c->surface.mode = dContactApprox1 | dContactFDir1;
      c->surface.mu = coefficients[k] = mu;
      c->fdir1[0] = 1, c->fdir1[1] = 0, c->fdir1[2] = 0;
      const dJointID joint = dJointCreateContact(world, group, c);
      dJointAttach(joint, body, NULL);
      dJointSetFeedback(joint, &forces[k]);
      rows_of(c, center, J + 3 * k);
    }
    const double push[velocities] = {i < 8 ? 4 : 6, 0, -10 * mass, 0, 0, 0}; /* friction holds 5 */
    for (int j = 0; j < velocities; ++j) f[j] = M[j][j] * v[j] + step * push[j];
    dBodyAddForce(body, push[0], 0, 0);
    dWorldQuickStep(world, step);
    for (int j = 0; j < 3; ++j) v[j] = dBodyGetLinearVel(body)[j], v[3 + j] = dBodyGetAngularVel(body)[j];
    for (int k = 0; k < count; ++k) {
      for (int d = 0; d < 3; ++d) {
        const double* axis = J[3 * k + d];
        r[3 * k + d] = step * (axis[0] * forces[k].f1[0] + axis[1] * forces[k].f1[1] + axis[2] * forces[k].f1[2]);
        R[3 * k + d] = cfm / step;
      }
      bias[3 * k] = -erp * contacts[k].geom.depth / step;
    }
    slipproof_record_step record = {0};
    record.dimension = 3, record.contacts = (size_t)count, record.mu = coefficients;
    record.bodies = velocities, record.M = &M[0][0], record.J = &J[0][0], record.f = f, record.v = v, record.r = r;
    record.law = SLIPPROOF_LAW_BOX, record.compliance = R, record.bias = bias;
    record.force_unit = "N s", record.velocity_unit = "m/s";
    if (slipproof_record(&recorder, &record)) return fputs(slipproof_record_mistake(&recorder), stderr), 1;
    dJointGroupEmpty(group);
  }
  dWorldDestroy(world), dGeomDestroy(box), dGeomDestroy(floor);
  dCloseODE();
  return slipproof_record_close(&recorder) ? (perror(argv[1]), 1) : 0;
}
