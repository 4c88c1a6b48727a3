#include "report/scenes/solve_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/number/format.hpp"
#include "mechanics/bicycle/chain.hpp"
#include "report/values/every_load.hpp"
#include "report/values/number_text.hpp"

namespace slipproof {

SolvedScene::SolvedScene(Scene given) : scene(std::move(given)), table(scene.bicycle, scene.road, scene.force_kind) {
  if (scene.F) {
    at_force = motions_at(table, *scene.F);
  } else {
    cells = partition(table);
  }
  if (!table.detachment()) return;
  const auto contacts = contact_problem(scene.bicycle, scene.road, scene.force_kind, 0);
  if (contacts) for_every_q = for_every_load(*contacts);
}

namespace {

using Out = std::back_insert_iterator<std::string>;

std::string joined(const std::vector<ContactMode>& modes) {
  std::string text;
  for (const ContactMode mode : modes) text += (text.empty() ? "" : " = ") + name(mode);
  return text;
}

template <class Names>
std::string list(const Names& names) {
  std::string text;
  for (const auto& q : names) text += (text.empty() ? "" : ", ") + std::string(name(q));
  return text;
}

void write_motion(Out out, const SolvedScene& solved, const FoundMotion<Rational>& found,
                  const SolveReportOptions& options) {
  fmt::format_to(out, "\n  {}  ({})\n", joined(found.modes), found.strict ? "strict" : "boundary");
  for (const Quantity q : all_quantities()) {
    fmt::format_to(out, "    {:<6} {}\n", name(q), number_text(found.values[q], options.digits));
  }
  if (!options.chain) return;
  const auto chain = chain_of(solved.scene.bicycle, found.values, *solved.scene.F);
  fmt::format_to(out, "    {:<6} {}\n    {:<6} {}\n", "eps1", number_text(chain.eps1, options.digits), "T",
                 number_text(chain.T, options.digits));
}

void write_continuum(Out out, const Continuum& c, int digits) {
  fmt::format_to(
      out, "\n  {}  a continuum of motions for {}: {} free, not determined: {}\n", name(c.mode),
      c.closed.is_point() ? interval_text("F", c.closed, digits) : "F in " + interval_text("F", c.closed, digits),
      list(c.parameters), list(c.undetermined()));
}

void write_every_q(Out out, const SolvedScene& solved) {
  const std::string line = every_load_line(solved.for_every_q);
  if (!line.empty()) fmt::format_to(out, "\n{}", line);
}

void write_at_force(Out out, const SolvedScene& solved, const SolveReportOptions& options) {
  const MotionsAtForce& found = *solved.at_force;
  fmt::format_to(out, "\nF = {} N: {} motion{}\n", exact_text(*solved.scene.F), found.motions.size(),
                 found.motions.size() == 1 ? "" : "s");
  for (const auto& motion : found.motions) write_motion(out, solved, motion, options);
  for (const auto& c : found.continua) {
    write_continuum(out, *c.continuum, options.digits);
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
      fmt::format_to(out, "    {} in {}\n", name(c.continuum->parameters[k]), to_string(c.parameters[k]));
    }
  }
  fmt::format_to(out, "\nRejected, with the violated condition and its margin\n");
  for (const Rejection& r : found.rejected) {
    if (r.violated) {
      fmt::format_to(out, "    {:<12} {:<14} {}\n", name(r.mode), name(*r.violated),
                     number_text(r.margin, options.digits));
    } else {
      fmt::format_to(out, "    {:<12} {}\n", name(r.mode), reason(r));
    }
  }
}

void write_ranges(Out out, const SolvedScene& solved, const SolveReportOptions& options) {
  fmt::format_to(out, "\nForces F for which each mode is consistent\n");
  for (const ModeSolution& s : solved.table.solutions()) {
    if (s.closed().empty()) continue;
    fmt::format_to(out, "    {:<12} {:<28} {}\n", name(s.mode()), interval_text("F", s.closed(), options.digits),
                   to_string(s.closed()));
  }
}

void write_cells(Out out, const SolvedScene& solved, const SolveReportOptions& options) {
  fmt::format_to(out, "\nThe line of forces, cut where the motions change\n");
  for (const Cell& cell : solved.cells) {
    std::vector<std::string> motions;
    for (const auto& motion : cell.motions) {
      motions.push_back(joined(motion.modes) + (motion.strict ? "" : " (boundary)"));
    }
    for (const ContactMode mode : cell.continua) motions.push_back(name(mode) + " (continuum)");
    if (motions.empty()) motions.emplace_back("no motion");
    fmt::format_to(out, "    {:<28} {}\n", interval_text("F", cell.forces, options.digits), fmt::join(motions, "; "));
  }
}

}  // namespace

std::string solve_text(const SolvedScene& solved, const SolveReportOptions& options) {
  std::string text;
  Out out(text);
  fmt::format_to(
      out, "{}: {} force, {}\n", solved.scene.name,
      solved.scene.force_kind == ForceKind::internal ? "internal" : "external",
      solved.table.detachment() ? "all 16 contact modes" : "no J: motions with a wheel off the road are not modelled");
  for (const std::string& note : solved.scene.notes) fmt::format_to(out, "note: {}\n", note);
  if (solved.at_force) {
    write_at_force(out, solved, options);
    write_every_q(out, solved);
    const auto strict = std::count_if(solved.at_force->motions.begin(), solved.at_force->motions.end(),
                                      [](const auto& m) { return m.strict; });
    fmt::format_to(out, "\ns SOLVED motions {} strict {} continua {} rejected {}\n", solved.at_force->motions.size(),
                   strict, solved.at_force->continua.size(), solved.at_force->rejected.size());
    return text;
  }
  write_ranges(out, solved, options);
  write_cells(out, solved, options);
  std::size_t continua = 0, modes = 0;
  for (const ModeSolution& s : solved.table.solutions()) {
    if (s.closed().empty()) continue;
    ++modes;
    if (s.kind() != ModeSolution::Kind::continuum) continue;
    ++continua;
    write_continuum(out, s.continuum(), options.digits);
  }
  write_every_q(out, solved);
  fmt::format_to(out, "\ns SOLVED modes {} cells {} continua {}\n", modes, solved.cells.size(), continua);
  return text;
}

}  // namespace slipproof
