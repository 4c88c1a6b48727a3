#include <memory>

#include "faces/c_interface/call.hpp"
#include "faces/c_interface/solution.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/scenes/mechanism_report.hpp"

namespace slipproof::c {

namespace {

/// Returns an array of a solution, and stores its length unless `count` is null.
template <class Element>
const Element* array_of(const slipproof_solution* solution, std::vector<Element> Tables::*member, size_t* count) {
  const bool there = solution != nullptr;
  if (count != nullptr) *count = there ? (solution->tables.*member).size() : 0;
  return there ? (solution->tables.*member).data() : nullptr;
}

}  // namespace

}  // namespace slipproof::c

using slipproof::c::Tables;

slipproof_status slipproof_solve_file(const char* path, slipproof_solution** solution, slipproof_error** error) {
  return slipproof::c::call(error, [&] {
    slipproof::c::need(path, "path");
    slipproof::c::need(solution, "solution");
    *solution = std::make_unique<slipproof_solution>(slipproof::read_scene(path)).release();
  });
}

slipproof_status slipproof_solve_text(const char* toml, const char* name, slipproof_solution** solution,
                                      slipproof_error** error) {
  return slipproof::c::call(error, [&] {
    slipproof::c::need(toml, "toml");
    slipproof::c::need(name, "name");
    slipproof::c::need(solution, "solution");
    *solution = std::make_unique<slipproof_solution>(slipproof::parse_scene(toml, name)).release();
  });
}

void slipproof_solution_free(slipproof_solution* solution) {
  delete solution;
}

const char* slipproof_solution_json(const slipproof_solution* solution) {
  if (solution == nullptr) return nullptr;
  const auto write = [&] { solution->json = slipproof::solve_json(solution->solved, solution->every_q); };
  try {
    std::call_once(solution->json_written, write);
    return solution->json.c_str();
  } catch (...) {  // there is no memory
    return nullptr;
  }
}

const char* slipproof_solution_name(const slipproof_solution* solution) {
  return solution == nullptr ? nullptr : solution->tables.name.c_str();
}

const char* slipproof_solution_load(const slipproof_solution* solution) {
  return solution == nullptr || !solution->tables.load ? nullptr : solution->tables.load->c_str();
}

const slipproof_motion* slipproof_solution_motions(const slipproof_solution* solution, size_t* count) {
  return slipproof::c::array_of(solution, &Tables::motions, count);
}

const slipproof_rejection* slipproof_solution_rejections(const slipproof_solution* solution, size_t* count) {
  return slipproof::c::array_of(solution, &Tables::rejections, count);
}

const slipproof_range* slipproof_solution_ranges(const slipproof_solution* solution, size_t* count) {
  return slipproof::c::array_of(solution, &Tables::ranges, count);
}

const slipproof_cell* slipproof_solution_cells(const slipproof_solution* solution, size_t* count) {
  return slipproof::c::array_of(solution, &Tables::cells, count);
}
