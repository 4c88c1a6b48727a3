/* The C interface from C99: what the batch filter says of a bicycle is what its exact motions are; answers of a solver;
 * mistakes. Prints what failed, and returns how much. */
#include <math.h>
#include <slipproof.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("failed: %s\n", what);
  ++failures;
}

static const char scene_format[] =
    "[bicycle]\nR = 1\nh = 1\nb = 1\nI1 = 0\nI2 = 1\nI3 = 1\nr1 = 1\nr2 = 1\nL = 1\nM = 1\nJ = 2\n"
    "[road]\nf = 4\ng = 1\n[force]\nkind = \"internal\"\nF = %d\n";

/* The bits of the modes in which the bicycle has a motion at a force. */
static unsigned modes_of_motions(int force) {
  static const char* const states[] = {"stick", "slip+", "slip-", "lift"};
  char scene[400];
  slipproof_solution* solution = NULL;
  unsigned bits = 0;
  snprintf(scene, sizeof scene, scene_format, force);
  expect(slipproof_solve_text(scene, "a text", &solution, NULL) == SLIPPROOF_OK, "a scene in a text is solved");
  size_t motions = 0;
  const slipproof_motion* motion = slipproof_solution_motions(solution, &motions);
  for (size_t k = 0; k < motions; ++k) {
    for (size_t m = 0; m < motion[k].mode_count; ++m) {
      for (unsigned i = 0; i < 16; ++i) {
        char name[20];
        snprintf(name, sizeof name, "%s/%s", states[i / 4], states[i % 4]);
        if (strcmp(name, motion[k].modes[m]) == 0) bits |= 1u << i;
      }
    }
  }
  slipproof_solution_free(solution);
  return bits;
}

static void the_filter_agrees_with_the_motions(void) {
  enum { count = 41 };
  static const double zero = 0, one = 1, two = 2, four = 4;
  const slipproof_column O = {&zero, 1}, I = {&one, 1};
  double forces[count];
  uint16_t modes[count], strict[count];
  uint64_t tiers[2] = {0, 0};
  slipproof_bicycles bicycles = {I, I, I, I, I, O, I, I, I, I, I, {&two, 1}, {&four, 1}, I, {forces, count}, 0};
  unsigned seen = 0;
  for (int i = 0; i < count; ++i) forces[i] = i - 20;
  expect(slipproof_consistent_modes(&bicycles, count, modes, strict, tiers, 1, NULL) == SLIPPROOF_OK, "a batch");
  for (int i = 0; i < count; ++i) {
    const unsigned expected = modes_of_motions(i - 20);
    if (modes[i] != expected) printf("F = %d: 0x%x, and not 0x%x\n", i - 20, modes[i], expected);
    expect(modes[i] == expected, "the filter has the modes of the motions");
    expect((strict[i] & ~modes[i]) == 0, "strict modes are consistent");
    seen |= expected;
  }
  expect((seen & (seen - 1)) != 0, "there are several modes");
  expect(tiers[0] + tiers[1] == count, "the tiers count every bicycle");
}

static double value_of(const slipproof_motion* motion, const char* name) {
  for (size_t i = 0; i < motion->value_count; ++i) {
    if (strcmp(motion->values[i].name, name) == 0) return motion->values[i].range.nearest_lower;
  }
  expect(0, name);
  return NAN;
}

/* The first motion at each force, rounded, is right; with a greater acceleration it is not. */
static void motions_are_certified_as_answers(void) {
  enum { count = 41 };
  static const double zero = 0, one = 1, two = 2, four = 4;
  static const char* const names[5] = {"a", "S2", "S3", "N2", "N3"};
  const slipproof_column O = {&zero, 1}, I = {&one, 1}, none = {NULL, 0};
  double forces[count], numbers[5][count];
  uint8_t expected[count], verdicts[count], tiers[count];
  uint16_t modes[count];
  for (int i = 0; i < count; ++i) {
    char scene[400];
    slipproof_solution* solution = NULL;
    size_t motions = 0;
    forces[i] = i - 20;
    snprintf(scene, sizeof scene, scene_format, i - 20);
    expect(slipproof_solve_text(scene, "a text", &solution, NULL) == SLIPPROOF_OK, "a scene in a text is solved");
    const slipproof_motion* motion = slipproof_solution_motions(solution, &motions);
    for (int k = 0; k < 5; ++k) numbers[k][i] = motions == 0 ? 0 : value_of(motion, names[k]);
    expected[i] = motions == 0 ? SLIPPROOF_WRONG : motions == 1 ? SLIPPROOF_CERTIFIED : SLIPPROOF_AMBIGUOUS;
    slipproof_solution_free(solution);
  }
  const slipproof_bicycles bicycles = {I, I, I, I, I, O, I, I, I, I, I, {&two, 1}, {&four, 1}, I, {forces, count}, 0};
  slipproof_answers answers = {{numbers[0], count},
                               {numbers[1], count},
                               {numbers[2], count},
                               {numbers[3], count},
                               {numbers[4], count},
                               none,
                               none,
                               none,
                               none,
                               NULL};
  const slipproof_judgements judgements = {verdicts, modes, NULL, tiers};
  expect(slipproof_certify_bicycles(&bicycles, &answers, count, NULL, &judgements, 2, NULL) == SLIPPROOF_OK, "records");
  for (int i = 0; i < count; ++i) {
    if (verdicts[i] != expected[i]) printf("F = %d: %d, and not %d\n", i - 20, verdicts[i], expected[i]);
    expect(verdicts[i] == expected[i], "a motion is a right answer");
    expect(tiers[i] < 2, "a tier");
    numbers[0][i] += 2 + fabs(numbers[0][i]);
  }
  expect(slipproof_certify_bicycles(&bicycles, &answers, count, NULL, &judgements, 1, NULL) == SLIPPROOF_OK,
         "wrong ones");
  for (int i = 0; i < count; ++i) expect(verdicts[i] == SLIPPROOF_WRONG, "a wrong acceleration is a wrong answer");
  slipproof_error* error = NULL;
  answers.S3 = none;
  expect(slipproof_certify_bicycles(&bicycles, &answers, count, NULL, &judgements, 1, &error) == SLIPPROOF_BAD_ARGUMENT,
         "an answer without S3");
  expect(strstr(slipproof_error_message(error), "missing S3") != NULL, "what is missing is told");
  slipproof_error_free(error);
}

static void a_bicycle_outside_the_domain_is_refused(void) {
  static const double numbers[] = {1, 1, -1}, one = 1;
  const slipproof_column I = {&one, 1}, none = {NULL, 0};
  slipproof_bicycles bicycles = {I, {numbers, 3}, I, I, I, I, I, I, I, I, I, none, I, I, I, 0};
  uint16_t modes[3] = {7, 7, 7};
  slipproof_error* error = NULL;
  expect(slipproof_consistent_modes(&bicycles, 3, modes, NULL, NULL, 1, &error) == SLIPPROOF_BAD_ARGUMENT, "R < 0");
  expect(strcmp(slipproof_error_message(error), "bicycle 3: R: found -1, expected R > 0") == 0,
         "which bicycle is wrong");
  expect(modes[0] == 7, "nothing is written where something is wrong");
  slipproof_error_free(error);
  bicycles.R.size = 2;
  expect(slipproof_consistent_modes(&bicycles, 3, modes, NULL, NULL, 1, NULL) == SLIPPROOF_BAD_ARGUMENT,
         "two of three");
}

static void answers_are_judged(void) {
  static const double W[] = {2, 1, 1, 2}, q[] = {-5, -6};
  const double right[] = {4.0 / 3, 7.0 / 3}, wrong[] = {2.5, 0}, none[] = {NAN, 0};
  const double* const answers[] = {right, wrong, none};
  const char* const verdicts[] = {"certified", "wrong", "invalid"};
  for (int i = 0; i < 3; ++i) {
    const slipproof_problem problem = {2, 1, W, q, NULL, answers[i], NULL};
    slipproof_verdict* verdict = NULL;
    expect(slipproof_certify(&problem, NULL, &verdict, NULL) == SLIPPROOF_OK, "an answer is judged");
    const slipproof_judgement found = slipproof_verdict_judgement(verdict);
    expect(strcmp(found.verdict, verdicts[i]) == 0, verdicts[i]);
    expect(found.certified == (i == 0), "certified");
    expect(i == 0 ? found.error < 1e-15 : isnan(found.error), "error");
    slipproof_verdict_free(verdict);
  }
}

static void many_answers_are_judged(void) {
  static const double W[] = {2, 1, 1, 2}, q[] = {-5, -6}, right[] = {4.0 / 3, 7.0 / 3}, wrong[] = {2.5, 0};
  static const double one[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, falls[] = {-9.81, 0.5, 0.5}, holds[] = {9.81, -0.5, -0.5};
  static const double mu[] = {0.3}, negative[] = {-1};
  slipproof_problem problems[] = {
      {2, 1, W, q, NULL, right, NULL}, {2, 1, W, q, NULL, wrong, NULL}, {3, 3, one, falls, mu, holds, NULL}};
  slipproof_result results[3] = {{"none", 0, 0, 0}};
  slipproof_error* error = NULL;
  expect(slipproof_certify_many(problems, 3, NULL, results, 2, NULL) == SLIPPROOF_OK, "many answers are judged");
  expect(strcmp(results[0].verdict, "certified") == 0 && results[0].certified, "the first in exact numbers");
  expect(strcmp(results[1].verdict, "wrong") == 0 && !results[1].certified, "the second is wrong");
  expect(strcmp(results[2].verdict, "solution within rho") == 0 && results[2].certified, "the third in space");
  expect(results[2].error < 1e-9 && results[2].backward_error < 1e-9 && isnan(results[0].backward_error), "errors");
  problems[2].mu = negative;
  results[0].verdict = "none";
  expect(slipproof_certify_many(problems, 3, NULL, results, 0, &error) == SLIPPROOF_BAD_ARGUMENT, "mu < 0");
  expect(strncmp(slipproof_error_message(error), "problems[3]", 11) == 0, "which problem is wrong");
  expect(strcmp(results[0].verdict, "none") == 0, "nothing is written where something is wrong");
  slipproof_error_free(error);
  expect(slipproof_certify_many(NULL, 0, NULL, NULL, 0, NULL) == SLIPPROOF_OK, "no problem at all");
}

static void all_solutions_are_found(void) {
  static const double W[] = {1.25, 1, 0, 1, 5, 0, 0, 0, 5.0625}, q[] = {0.09375, 3.375, 2.09375}, mu[] = {1.75};
  static const double lifts[] = {0, 0, 0};
  const slipproof_problem problem = {3, 3, W, q, mu, lifts, NULL};
  const slipproof_certify_options options = {NAN, NAN, 0, 0, 1};
  slipproof_verdict* verdict = NULL;
  expect(slipproof_certify(&problem, &options, &verdict, NULL) == SLIPPROOF_OK, "all solutions are found");
  const slipproof_judgement found = slipproof_verdict_judgement(verdict);
  expect(strcmp(found.verdict, "ambiguous") == 0, "lifting is one of several");
  expect(strstr(found.json, "\"solutions\":3") != NULL, "lift, stick and slip");
  slipproof_verdict_free(verdict);
}

static void mistakes_have_places(void) {
  slipproof_solution* solution = NULL;
  slipproof_error* error = NULL;
  expect(slipproof_solve_text("[bicycle]\nR = 0\n", "s.toml", &solution, &error) == SLIPPROOF_BAD_INPUT, "R = 0");
  expect(solution == NULL, "no solution");
  expect(slipproof_error_count(error) > 3, "all mistakes are told");
  const slipproof_mistake beyond = slipproof_error_mistake(error, slipproof_error_count(error));
  expect(strcmp(beyond.message, "") == 0, "beyond the last mistake there is none");
  int told = 0;
  for (size_t i = 0; i < slipproof_error_count(error); ++i) {
    const slipproof_mistake m = slipproof_error_mistake(error, i);
    told = told || (m.line == 2 && m.column == 5 && strcmp(m.place, "s.toml") == 0 && strcmp(m.found, "'0'") == 0 &&
                    strcmp(m.expected, "R > 0") == 0);
  }
  expect(told, "place, found, expected");
  slipproof_error_free(error);
  expect(slipproof_solve_file(NULL, &solution, NULL) == SLIPPROOF_BAD_ARGUMENT, "no path");
  slipproof_solution_free(NULL);
  slipproof_verdict_free(NULL);
  slipproof_error_free(NULL);
}

int main(void) {
  the_filter_agrees_with_the_motions();
  motions_are_certified_as_answers();
  a_bicycle_outside_the_domain_is_refused();
  answers_are_judged();
  many_answers_are_judged();
  all_solutions_are_found();
  mistakes_have_places();
  return failures;
}
