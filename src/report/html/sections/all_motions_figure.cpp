#include "report/html/sections/all_motions_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/document/document.hpp"
#include "report/planes/cone_signs.hpp"
#include "report/planes/motion_cones.hpp"

namespace slipproof {

namespace {

template <class Condition>
bool any_contact(const MotionCones& cones, const Condition& condition) {
  return std::ranges::any_of(cones.rows,
                             [&](const MotionRow& row) { return std::ranges::any_of(row.contacts, condition); });
}

void add_motions_legend(const Element& parent, const MotionCones& cones) {
  using M = ContactMotion;
  const Element list = parent.add("ul", "legend");
  const auto entry = [&](ConeSign sign, const char* meaning, auto condition) {
    if (any_contact(cones, condition)) add_sign_entry(list, sign, meaning);
  };
  entry(ConeSign::stick, "force where the contact sticks", [](const M& m) { return m.force && !m.slip; });
  entry(ConeSign::slide, "force where it slips", [](const M& m) { return m.force && m.slip; });
  entry(ConeSign::motion, "direction in which it slips", [](const M& m) { return m.slip.has_value(); });
  entry(ConeSign::disc, "friction cone; without a point it touches without a force, or has no friction",
        [](const M& m) { return !m.lifts; });
  entry(ConeSign::lifts, "lifts", [](const M& m) { return m.lifts; });
}

/// What the picture leaves out, so that readers do not expect more in it.
std::string left_out_of(const MotionCones& cones) {
  std::string text = " Speeds and the sizes of forces are not drawn.";
  const auto any = [&](auto condition) { return std::ranges::any_of(cones.rows, condition); };
  if (any([](const MotionRow& row) { return row.kind == "continuum"; }))
    text += " A continuum moves in different ways; one of its motions is drawn.";
  if (any([](const MotionRow& row) { return row.kind == "forces open"; }))
    text += " Where forces are open, one choice of them is drawn.";
  if (any([](const MotionRow& row) { return row.nearest; }))
    text += " Nearest: the one whose forces are nearest to those of the answer.";
  if (any_contact(cones, [](const ContactMotion& m) { return !m.lifts && m.normal == 0; }))
    text += " The mode may call a contact lift that touches without a force.";
  if (cones.motions > cones.rows.size())
    text += fmt::format(" Of {} motions the first {} are drawn.", cones.motions, cones.rows.size());
  if (cones.contacts > cones.columns())
    text += fmt::format(" Of {} contacts the first {} are drawn.", cones.contacts, cones.columns());
  return text;
}

void add_motions_table(const Element& parent, const MotionCones& cones, std::size_t answer) {
  Document hidden;
  ReportTable& table = hidden.details("The same as a table")
                           .table({{{"solution", true},
                                    {"contact", true},
                                    "state",
                                    {"r_N", true},
                                    {"r_T1 / (μ r_N)", true},
                                    {"r_T2 / (μ r_N)", true},
                                    {"slips at, in degrees", true}}});
  table.label = fmt::format("All motions, contact by contact, answer {}", answer + 1);
  table.caption = "Rounded to four digits. Degrees count from r_T1 towards r_T2.";
  const auto number = [](double value) { return ReportCell(fmt::format("{:.4g}", value)); };
  for (std::size_t i = 0; i < cones.rows.size(); ++i) {
    for (std::size_t k = 0; k < cones.columns(); ++k) {
      const ContactMotion& motion = cones.rows[i].contacts[k];
      const ReportCell none("–");
      table.row({std::to_string(i + 1), std::to_string(k + 1), std::string(state_of(motion)), number(motion.normal),
                 motion.force ? number((*motion.force)[0]) : none, motion.force ? number((*motion.force)[1]) : none,
                 motion.slip ? number(degrees_of(*motion.slip)) : none});
    }
  }
  add_document(parent, hidden);
}

}  // namespace

void add_all_motions_figure(const Element& parent, const JudgedProblem& problem, std::size_t answer,
                            const std::string& id) {
  const auto cones = motion_cones(problem.mixed, problem.answers[answer].judgement);
  if (!cones) return;
  const char* const heading = "All motions, contact by contact";
  const Element figure = parent.add("figure", "phase small motions-figure");
  figure.add("h3").text(heading);
  const Element plot = figure.add("div", "plot").set("tabindex", 0).set("role", "region").set("aria-label", heading);
  add_motion_cones(plot, *cones, id + "-motions");
  add_motions_legend(figure, *cones);
  figure.add("figcaption")
      .text(
          "Each row is a motion, each disc the friction cone of a contact seen from above, r_T1 to the right and r_T2 "
          "upwards: a point shows its tangential force over μ times its normal force, an arrow the direction in which "
          "it slips, opposite to friction." +
          left_out_of(*cones));
  add_motions_table(figure, *cones, answer);
}

}  // namespace slipproof
