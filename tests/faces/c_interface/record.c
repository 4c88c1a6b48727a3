/* slipproof_record.h: what it writes, keeps and refuses. */
#include <assert.h>
#include <locale.h>
#include <slipproof_record.h>

static char path[] = "recorded.jsonl";

static char* content(void) {
  static char text[4000];
  FILE* file = fopen(path, "r");
  assert(file);
  text[fread(text, 1, sizeof text - 1, file)] = 0;
  fclose(file);
  return text;
}

/* A point on the floor. */
static slipproof_record_step point(const double* r) {
  static const double W[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, q[] = {-10, 3, 0.1}, mu[] = {0.5};
  slipproof_record_step step = {0};
  step.dimension = 3, step.contacts = 1, step.W = W, step.q = q, step.mu = mu, step.r = r;
  return step;
}

static void writes_each_step(void) {
  const double r[] = {10, -3, -0.1}, bad[] = {NAN, -INFINITY, 1e300 * 1e10};
  slipproof_recorder recorder;
  slipproof_record_step step = point(r);
  assert(slipproof_record_open(&recorder, path, 0) == SLIPPROOF_RECORD_OK);
  assert(slipproof_record(&recorder, &step) == SLIPPROOF_RECORD_OK);
  step = point(bad);
  step.title = "not a number";
  assert(slipproof_record(&recorder, &step) == SLIPPROOF_RECORD_OK);
  assert(slipproof_record_close(&recorder) == SLIPPROOF_RECORD_OK);
  assert(strcmp(content(),
                "{\"title\":\"step "
                "1\",\"dimension\":3,\"W\":{\"rows\":3,\"columns\":3,\"entries\":[[0,0,1],[1,1,1],[2,2,1]]},"
                "\"q\":[-10,3,\"0x1.999999999999ap-4\"],\"mu\":[\"0x1p-1\"],\"law\":\"coulomb\",\"r\":[10,-3,\"-0x1."
                "999999999999ap-4\"]}\n"
                "{\"title\":\"not a "
                "number\",\"dimension\":3,\"W\":{\"rows\":3,\"columns\":3,\"entries\":[[0,0,1],[1,1,1],[2,2,1]]},"
                "\"q\":[-10,3,\"0x1.999999999999ap-4\"],\"mu\":[\"0x1p-1\"],\"law\":\"coulomb\",\"r\":[NaN,-Infinity,"
                "Infinity]"
                "}\n") == 0);
}

/* The binary64 itself: small integers as they are, others by their bits. */
static void writes_numbers(void) {
  static const double values[] = {
      0, -0.0, 999999, -7, 1e6, 0.75, -2.5, 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308};
  static const char* const texts[] = {"0",
                                      "-0",
                                      "999999",
                                      "-7",
                                      "\"0x1.e848p19\"",
                                      "\"0x1.8p-1\"",
                                      "\"-0x1.4p1\"",
                                      "\"0x0.0000000000001p-1022\"",
                                      "\"0x1p-1022\"",
                                      "\"0x1.fffffffffffffp1023\""};
  size_t i;
  for (i = 0; i < sizeof values / sizeof *values; ++i) {
    slipproof_record_text text = {NULL, 0, 0, 0};
    slipproof_record_number(&text, values[i]);
    assert(strcmp(text.data, texts[i]) == 0);
    if (text.data[0] == '"') assert(strtod(text.data + 1, NULL) == values[i]);
    free(text.data);
  }
}

/* A step without contacts, as most are. */
static void writes_nothing_that_touches(void) {
  slipproof_recorder recorder;
  slipproof_record_step step = {0};
  step.dimension = 3;
  assert(slipproof_record_open(&recorder, path, 0) == SLIPPROOF_RECORD_OK);
  assert(slipproof_record(&recorder, &step) == SLIPPROOF_RECORD_OK);
  assert(slipproof_record_close(&recorder) == SLIPPROOF_RECORD_OK);
  assert(strcmp(content(),
                "{\"title\":\"step 1\",\"dimension\":3,\"W\":{\"rows\":0,\"columns\":0,\"entries\":[]},\"q\":[],"
                "\"mu\":[],\"law\":\"coulomb\",\"r\":[]}\n") == 0);
}

/* Of ten steps the three that are farthest from their law, in the order in which they came. */
static void keeps_the_worst(void) {
  static const double off[] = {0, 5e-3, 1e-9, 2, 1e-6, 1e-7, 1, 1e-3, 0, NAN};
  slipproof_recorder recorder;
  char* found;
  int i;
  assert(slipproof_record_open(&recorder, path, 3) == SLIPPROOF_RECORD_OK);
  for (i = 0; i < 10; ++i) {
    const double r[] = {10 + off[i], -3, -0.1};
    const slipproof_record_step step = point(r);
    assert(slipproof_record(&recorder, &step) == SLIPPROOF_RECORD_OK);
  }
  assert(slipproof_record_close(&recorder) == SLIPPROOF_RECORD_OK);
  found = content();
  assert(strstr(found, "step 4") && strstr(found, "step 7") && strstr(found, "step 10"));
  assert(strstr(found, "step 4") < strstr(found, "step 7") && strstr(found, "step 7") < strstr(found, "step 10"));
  assert(!strstr(found, "step 2"));
}

/* By each law what obeys it has no residual, and what does not has one. */
static void measures_by_each_law(void) {
  static const double slides[] = {10, -5, 0}, rises[] = {10.4, -5.2, 0}, less[] = {10, -2, 0}, creeps[] = {10, -3, 0};
  static const double q[] = {-10, 6, 0}, bounds[] = {2, 2};
  slipproof_record_step step = point(slides);
  step.q = q;
  assert(slipproof_record_residual(&step) < 1e-12);
  step.law = SLIPPROOF_LAW_ASSOCIATED;
  assert(slipproof_record_residual(&step) > 0.1);
  step.r = rises;
  assert(slipproof_record_residual(&step) < 1e-12);
  step.law = SLIPPROOF_LAW_FIXED, step.bounds = bounds, step.r = less;
  assert(slipproof_record_residual(&step) < 1e-12);
  step.law = SLIPPROOF_LAW_REGULARISED, step.bounds = NULL, step.slip_speed = 4, step.soft = 1, step.r = creeps;
  assert(slipproof_record_residual(&step) < 1e-12);
  step.soft = 0;
  assert(slipproof_record_residual(&step) > 0.1);
}

/* A ball that comes down with 2 and slides with 3, e = 1/2, mu = 1/2; on a step that pushes it down by 1 more. */
static void writes_an_impact(void) {
  static const double r[] = {4, -2}, W[] = {1, 0, 0, 1}, q[] = {-3, 3}, mu[] = {0.5}, e[] = {0.5}, before[] = {-2, 3};
  static const double M[] = {1, 0, 0, 1}, J[] = {0, 1, 1, 0}, f[] = {3, -3}, v[] = {1, 1}, v_before[] = {3, -2};
  static const double back[] = {-3, -2};
  slipproof_recorder recorder;
  slipproof_record_step step = {0};
  step.dimension = 2, step.contacts = 1, step.W = W, step.q = q, step.mu = mu, step.r = r;
  assert(slipproof_record_residual(&step) > 0.5);
  step.impact = SLIPPROOF_IMPACT_NEWTON, step.restitution = e, step.u_before = before;
  assert(slipproof_record_residual(&step) < 1e-12);
  assert(slipproof_record_open(&recorder, path, 0) == SLIPPROOF_RECORD_OK);
  assert(slipproof_record(&recorder, &step) == SLIPPROOF_RECORD_OK);
  step.W = NULL, step.q = NULL, step.u_before = NULL, step.bodies = 2, step.impact = SLIPPROOF_IMPACT_MOREAU;
  step.M = M, step.J = J, step.f = f, step.v = v, step.v_before = v_before, step.tangential_restitution = e;
  assert(slipproof_record_residual(&step) < 1e-12);
  step.v_before = back; /* with friction along the way it came */
  assert(slipproof_record_residual(&step) > 0.4);
  step.v_before = v_before;
  assert(slipproof_record(&recorder, &step) == SLIPPROOF_RECORD_OK);
  assert(slipproof_record_close(&recorder) == SLIPPROOF_RECORD_OK);
  assert(strstr(content(), "\"impact\":\"newton\",\"restitution\":[\"0x1p-1\"],\"u_before\":[-2,3],\"r\":[4,-2]}"));
  assert(strstr(content(),
                "\"impact\":\"moreau\",\"restitution\":[\"0x1p-1\"],\"tangential_restitution\":[\"0x1p-1\"],"
                "\"v_before\":[3,-2],\"r\":[4,-2]}"));
}

static void refuses(slipproof_record_step step, const char* expected) {
  slipproof_recorder recorder;
  assert(slipproof_record_open(&recorder, path, 0) == SLIPPROOF_RECORD_OK);
  assert(slipproof_record(&recorder, &step) == SLIPPROOF_RECORD_BAD_STEP);
  assert(strstr(slipproof_record_mistake(&recorder), expected) == slipproof_record_mistake(&recorder));
  assert(slipproof_record_close(&recorder) == SLIPPROOF_RECORD_OK);
  assert(*content() == 0);
}

static void refuses_what_is_no_step(void) {
  static const double r[] = {10, -3, 0}, negative[] = {-1}, M[] = {1}, negative3[] = {0, -1, 0};
  static const slipproof_record_entry beyond = {3, 0, 1};
  slipproof_record_step step = point(r);
  slipproof_recorder recorder;
  step.dimension = 4;
  refuses(step, "dimension");
  step = point(r), step.entries = &beyond, step.entry_count = 1;
  refuses(step, "expected one of");
  step.W = NULL;
  refuses(step, "entries");
  step = point(r), step.r = NULL;
  refuses(step, "r: ");
  step = point(r), step.mu = negative;
  refuses(step, "mu: ");
  step = point(r), step.law = SLIPPROOF_LAW_FIXED;
  refuses(step, "bounds");
  step = point(r), step.law = SLIPPROOF_LAW_REGULARISED;
  refuses(step, "slip_speed");
  step = point(r), step.compliance = negative3;
  refuses(step, "compliance");
  step = point(r), step.law = (slipproof_record_law)17;
  refuses(step, "law");
  step = point(r), step.title = "a \"quote\"";
  refuses(step, "title");
  step = point(r), step.restitution = r + 2;
  refuses(step, "impact: ");
  step = point(r), step.impact = SLIPPROOF_IMPACT_NEWTON;
  refuses(step, "restitution: ");
  step.restitution = r;
  refuses(step, "restitution: ");
  step.restitution = r + 2;
  refuses(step, "u_before: ");
  step = point(r), step.force_unit = "N";
  refuses(step, "units");
  step = point(r), step.W = NULL, step.q = NULL, step.bodies = 1, step.M = M;
  refuses(step, "bodies");
  assert(slipproof_record_open(&recorder, "no/such/folder/file.jsonl", 2) == SLIPPROOF_RECORD_NOT_WRITTEN);
}

int main(void) {
  const char* const locales[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}; /* where one is: decimals with commas */
  size_t i;
  for (i = 0; i < 3 && !setlocale(LC_ALL, locales[i]); ++i) {
  }
  writes_each_step();
  writes_numbers();
  writes_nothing_that_touches();
  keeps_the_worst();
  measures_by_each_law();
  writes_an_impact();
  refuses_what_is_no_step();
  return remove(path);
}
