/* An engine of 60 lines that records its steps: a block on four corners, pushed, by sweeps over the contacts.
 *
 *   steps_of_sweeps FILE.jsonl [WORST]       then: slipproof certify FILE.jsonl */
#include <slipproof_record.h>

enum { contacts = 4, n = 3 * contacts, velocities = 6 };

static const double corners[contacts][2] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
static const double mass[velocities] = {2, 2, 2, 1, 1, 1}, mu[contacts] = {0.5, 0.5, 0.5, 0.5};

/* Rows of u = J v: up, along x and along y, at each corner, which is 1/2 below the center. */
static void jacobian(double J[n][velocities]) {
  memset(J, 0, sizeof(double[n][velocities]));
  for (int k = 0; k < contacts; ++k) {
    const double x = corners[k][0], y = corners[k][1], z = -0.5;
    double(*row)[velocities] = J + 3 * k;
    row[0][2] = 1, row[0][3] = y, row[0][4] = -x;
    row[1][0] = 1, row[1][4] = z, row[1][5] = -y;
    row[2][1] = 1, row[2][3] = -z, row[2][5] = x;
  }
}

/* Gauss and Seidel's sweeps: each component of r for itself, friction within mu times the last normal impulse. */
static void solve(double J[n][velocities], const double* f, double* v, double* r, int sweeps) {
  memset(r, 0, n * sizeof *r);
  for (int j = 0; j < velocities; ++j) v[j] = f[j] / mass[j];
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < n; ++i) {
      double u = 0, change = 0, before = r[i];
      for (int j = 0; j < velocities; ++j) u += J[i][j] * v[j], change += J[i][j] * J[i][j] / mass[j];
      const double bound = i % 3 == 0 ? 0 : mu[i / 3] * r[i - i % 3];
      r[i] -= u / change;
      if (i % 3 == 0 && r[i] < 0) r[i] = 0;
      if (i % 3 != 0) r[i] = r[i] > bound ? bound : r[i] < -bound ? -bound : r[i];
      for (int j = 0; j < velocities; ++j) v[j] += J[i][j] * (r[i] - before) / mass[j];
    }
  }
}

int main(int argc, char** argv) {
  const double step = 1.0 / 128;
  double J[n][velocities], M[velocities][velocities] = {{0}}, v[velocities] = {0}, f[velocities], r[n];
  slipproof_recorder recorder;
  if (argc < 2) return fputs("usage: steps_of_sweeps FILE.jsonl [WORST]\n", stderr), 2;
  if (slipproof_record_open(&recorder, argv[1], argc > 2 ? strtoul(argv[2], NULL, 10) : 0)) return perror(argv[1]), 1;
  jacobian(J);
  for (int j = 0; j < velocities; ++j) M[j][j] = mass[j];
  for (int i = 0; i < 8; ++i) {
    const double push[velocities] = {i < 4 ? 8 : 12, i < 4 ? 0 : 4, -20, 0, 0, 0}; /* it holds 10 */
    for (int j = 0; j < velocities; ++j) f[j] = mass[j] * v[j] + step * push[j];
    solve(J, f, v, r, i % 2 == 0 ? 10 : 1000); /* every other step is given few sweeps */
    slipproof_record_step record = {0};
    record.dimension = 3, record.contacts = contacts, record.mu = mu;
    record.bodies = velocities, record.M = &M[0][0], record.J = &J[0][0], record.f = f, record.v = v;
    record.r = r, record.law = SLIPPROOF_LAW_BOX;
    record.force_unit = "N s", record.velocity_unit = "m/s";
    if (slipproof_record(&recorder, &record)) return fputs(slipproof_record_mistake(&recorder), stderr), 1;
  }
  return slipproof_record_close(&recorder) ? (perror(argv[1]), 1) : 0;
}
