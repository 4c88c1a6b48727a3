/* Records what ODE solves: cubes that fall on a plane, by quick steps. Its law is the box pyramid, with a compliance
 * (CFM) and a bias (ERP) of each contact.
 *
 *   steps_of_ode FILE.jsonl [STEPS [ITERATIONS [WORST]]]     then: slipproof certify FILE.jsonl */
#include <ode/ode.h>

#include "boxes.h"

enum { most_of_pair = 8 };
static const double h = 1.0 / 60, mu = 0.5, cfm = 1e-5, erp = 0.2;

typedef struct simulation {
  dWorldID world;
  dSpaceID space;
  dJointGroupID group;
  dBodyID bodies[boxes];
  dContact contacts[most_contacts];
  dJointFeedback forces[most_contacts];
  int count;
  dGeomID geoms[most_contacts][2];
} simulation;

static int number_of(dGeomID geom) {
  return dGeomGetBody(geom) ? (int)(size_t)dBodyGetData(dGeomGetBody(geom)) : floor_plane;
}

static void touch(void* data, dGeomID first, dGeomID second) {
  simulation* s = (simulation*)data;
  if (number_of(first) == floor_plane) { /* what `f1` pushes is a box */
    touch(data, second, first);
    return;
  }
  dContactGeom found[most_of_pair];
  const int count = dCollide(first, second, most_of_pair, found, sizeof *found);
  for (int k = 0; k < count && s->count < most_contacts; ++k) {
    dContact* c = &s->contacts[s->count];
    memset(c, 0, sizeof *c);
    c->geom = found[k];
    c->surface.mode = dContactApprox1 | dContactFDir1;
    c->surface.mu = mu;
    dVector3 other;
    dPlaneSpace(c->geom.normal, c->fdir1, other);
    const dJointID joint = dJointCreateContact(s->world, s->group, c);
    dJointAttach(joint, dGeomGetBody(first), dGeomGetBody(second));
    dJointSetFeedback(joint, &s->forces[s->count++]);
  }
}

static void set_up(simulation* s, int iterations) {
  s->world = dWorldCreate(), s->space = dSimpleSpaceCreate(0), s->group = dJointGroupCreate(0);
  dWorldSetGravity(s->world, 0, 0, -gravity);
  dWorldSetCFM(s->world, cfm), dWorldSetERP(s->world, erp);
  if (iterations > 0) dWorldSetQuickStepNumIterations(s->world, iterations);
  dCreatePlane(s->space, 0, 0, 1, 0);
  for (size_t i = 0; i < boxes; ++i) {
    double at[3];
    dQuaternion turn;
    dMass mass;
    dQFromAxisAndAngle(turn, 1, 1, 0, start((int)i, at));
    const dBodyID body = s->bodies[i] = dBodyCreate(s->world);
    dMassSetBoxTotal(&mass, box_mass, side, side, side);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, at[0], at[1], at[2]);
    dBodySetQuaternion(body, turn);
    dBodySetData(body, (void*)i);
    dGeomSetBody(dCreateBox(s->space, side, side, side), body);
  }
}

/* The rows of a contact that was found, and the impulses that it got. */
static void add(const simulation* s, boxes_step* made, int k, double (*centers)[3]) {
  const dContact* c = &s->contacts[k];
  double axes[3][3], arm[3], r[3];
  for (int i = 0; i < 3; ++i) axes[0][i] = c->geom.normal[i], axes[1][i] = c->fdir1[i];
  dCalcVectorCross3(axes[2], axes[0], axes[1]);
  for (int side_of = 0; side_of < 2; ++side_of) {
    const int box = number_of(side_of ? c->geom.g2 : c->geom.g1);
    if (box == floor_plane) continue;
    for (int i = 0; i < 3; ++i) arm[i] = c->geom.pos[i] - centers[box][i];
    add_side(made, box, side_of ? -1 : 1, arm, axes);
  }
  for (int i = 0; i < 3; ++i) r[i] = h * dCalcVectorDot3(axes[i], s->forces[k].f1);
  add_contact(made, mu, r, cfm / h, -erp * c->geom.depth / h);
}

/* One step, and the seconds that ODE took. */
static double step(simulation* s, boxes_step* made) {
  double centers[boxes][3];
  for (int i = 0; i < boxes; ++i) {
    memcpy(centers[i], dBodyGetPosition(s->bodies[i]), sizeof centers[i]);
    set_before(made, i, dBodyGetLinearVel(s->bodies[i]), dBodyGetAngularVel(s->bodies[i]), h);
  }
  const double begin = now();
  s->count = 0;
  dSpaceCollide(s->space, s, touch);
  dWorldQuickStep(s->world, h);
  const double end = now();
  for (int i = 0; i < boxes; ++i) set_after(made, i, dBodyGetLinearVel(s->bodies[i]), dBodyGetAngularVel(s->bodies[i]));
  for (int k = 0; k < s->count; ++k) add(s, made, k, centers);
  dJointGroupEmpty(s->group);
  return end - begin;
}

int main(int argc, char** argv) {
  static simulation s;
  static boxes_step made;
  arguments given;
  slipproof_recorder recorder;
  double engine = 0, recording = 0;
  if (read_arguments(argc, argv, &given)) return 2;
  if (slipproof_record_open(&recorder, given.file, (size_t)given.worst)) return perror(given.file), 1;
  dInitODE();
  set_up(&s, given.iterations);
  for (int i = 0; i < given.steps; ++i) {
    memset(&made, 0, sizeof made);
    engine += step(&s, &made);
    const double begin = now();
    if (record_boxes(&recorder, &made, SLIPPROOF_LAW_BOX)) return 1;
    recording += now() - begin;
  }
  dSpaceDestroy(s.space), dWorldDestroy(s.world);
  dCloseODE();
  return finish(&recorder, &given, engine, recording);
}
