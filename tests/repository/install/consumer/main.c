/* The installed slipproof.h and its library: the motions of a scene that names a shipped mechanism. */
#include <slipproof.h>
#include <stdio.h>

int main(int argc, char** argv) {
  slipproof_solution* solution = NULL;
  slipproof_error* error = NULL;
  if (slipproof_solve_file(argc > 1 ? argv[1] : "", &solution, &error) != SLIPPROOF_OK) {
    puts(slipproof_error_message(error));
    slipproof_error_free(error);
    return 3;
  }
  size_t count = 0;
  const slipproof_motion* motions = slipproof_solution_motions(solution, &count);
  for (size_t i = 0; i < count; ++i)
    printf("%s with %s = %s\n", motions[i].modes[0], motions[i].values[0].name, motions[i].values[0].range.lower);
  slipproof_solution_free(solution);
  return 0;
}
