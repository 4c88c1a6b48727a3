#include "report/html/contact_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number/format.hpp"
#include "report/html/sections.hpp"
#include "report/html/sections/all_motions_figure.hpp"
#include "report/html/verdict_bar.hpp"
#include "report/planes/cone_signs.hpp"
#include "report/planes/cone_svg.hpp"
#include "report/scenes/contact_words.hpp"

namespace slipproof {

namespace {

constexpr std::size_t listed_contacts = 200, tabled_contacts = 200;
// The number of contacts drawn on the page, and the least number for each answer.
constexpr std::size_t drawn_contacts = 5000, drawn_at_least = 500;

/// The appearance of a verdict: the class of the claim verdict that is equally good, and a sign.
struct VerdictLook {
  std::string_view css_class, sign;
};
VerdictLook look(ContactVerdict verdict) {
  switch (verdict) {
    case ContactVerdict::unique:
      return {"proved", "✓✓ "};
    case ContactVerdict::solution_within_rho:
    case ContactVerdict::velocities_within_rho:
    case ContactVerdict::velocities_of_a_solution:
      return {"proved", "✓ "};
    case ContactVerdict::inaccurate:
    case ContactVerdict::eps_solution:
      return {"holds", "≈ "};
    case ContactVerdict::ambiguous:
      return {"undecided", "✓ "};
    case ContactVerdict::undecided:
      return {"undecided", "? "};
    default:
      return {"refuted", "✗ "};
  }
}

std::string id_of(std::size_t answer) {
  return "answer-" + std::to_string(answer + 1);
}

/// The name of a table of one answer, so that readers can tell the tables of different answers apart.
std::string label_of(const std::string& name, std::size_t answer) {
  return name + ", answer " + std::to_string(answer + 1);
}

/// A list of the numbers of one answer, each with its meaning.
class NumberList {
 public:
  explicit NumberList(const Element& parent) : list_(parent.add("dl", "bounds")) {}

  void add(std::string_view term, const std::string& value, const std::string& meaning) {
    list_.add("dt").text(term);
    const Element dd = list_.add("dd");
    dd.add("b", "number").text(value);
    dd.add("span", "because").text(" " + meaning);
  }

 private:
  Element list_;
};

std::string uniqueness(const ContactJudgement& j) {
  if (j.verdict == ContactVerdict::unique) return "; there is no other";
  const std::string near = j.enclosure && j.enclosure->locally_unique ? "; near it there is no other" : "";
  return is_certified(j.verdict) ? near + "; others are not excluded" : near;
}

/// The text of an upper bound; a bound of 0 is the number itself.
std::string bound_text(double bound) {
  return bound == 0 ? "0" : "≤ " + at_most(bound);
}

void add_bounds(const Element& parent, const ContactJudgement& j) {
  if (!j.residual) return;
  NumberList list(parent);
  if (j.enclosure)
    list.add("ρ", bound_text(j.rho), "from the answer to an exact solution, in each component" + uniqueness(j));
  if (j.every && std::isfinite(j.every->eta))
    list.add("velocities", bound_text(j.every->eta), "from those of the answer to those of every solution");
  if (j.excluded() > 0) {
    const bool fails = j.exclusion && j.exclusion->radius > 0;
    list.add("no solution within", at_least(j.excluded()),
             fails ? "in each component: the law of " + place_words(j.exclusion->contact, j.exclusion->row) +
                         " fails in all of that box"
                   : "in each component: every solution is farther away");
  }
  list.add("backward error", bound_text(j.residual->backward_error()), "of the largest of its kind in the problem");
  list.add("residual", bound_text(j.residual->change),
           "is what the constants change by in the problem that is solved exactly");
  list.add("moved", bound_text(j.residual->moved), "is how far forces go back to obey their law exactly");
  if (j.velocity_error > 0)
    list.add("velocity error", bound_text(j.velocity_error), "between those of the answer and those of its forces");
  if (j.enclosure) list.add("undetermined forces", std::to_string(j.undetermined), "of the components");
  if (j.law != FrictionLaw::cone) list.add("law", std::string(name(j.law)), "in place of the cone");
}

/// Names the contacts at which the other solution has another mode.
void add_other(const Element& parent, const ContactJudgement& j) {
  if (!j.other || !j.enclosure) return;
  const ConeMode &here = j.enclosure->system.mode(), &there = j.other->system.mode();
  std::vector<std::size_t> changed;
  for (std::size_t k = 0; k < here.size(); ++k) {
    if (here[k] != there[k]) changed.push_back(k);
  }
  if (changed.empty()) return;
  const std::size_t k = changed.front(), more = changed.size() - 1;
  const std::string others =
      more == 0 ? "" : "; " + counted(more, "more contact") + (more == 1 ? " differs" : " differ");
  parent.add("p", "evidence")
      .text(fmt::format("In the other solution the mode of contact {} is {}, here it is {}{}.", k + 1, name(there[k]),
                        name(here[k]), others));
}

void add_reasons(const Element& parent, const ContactJudgement& j) {
  for (const std::string& sentence : further_words(j)) parent.add("p", "evidence").text(sentence);
  add_other(parent, j);
  if (j.contacts.size() < 2) return;
  const Element details = parent.add("details", "data");
  details.add("summary").text("The " + counted(j.contacts.size(), "contact") + " that this is about");
  details.add("p").text(numbers_words(j.contacts, listed_contacts) + ".");
}

void add_worst(const Element& parent, const Residual& residual, std::size_t answer) {
  if (residual.worst.empty()) return;
  parent.add("h3").text("What is violated most");
  ReportTable table{{"where", "what is violated", {"by", true}, {"effect on velocities", true}}};
  table.label = label_of("What is violated most", answer);
  table.caption = "The largest effect first, ten at most. Contacts count from 1. All bounds are upper bounds.";
  table.css_class = "worst";
  for (const Violation& violation : residual.worst) {
    table.row({place_words(violation.contact, violation.row), code(violation.condition), at_most(violation.amount),
               at_most(violation.effect)});
  }
  add_table(parent, table);
}

constexpr std::array<ConeSign, 4> fit_signs{ConeSign::stick, ConeSign::slide, ConeSign::smooth, ConeSign::open};

/// How many contacts do what, as numbers and as a bar.
void add_fit_bar(const Element& parent, const ConeDisc& disc) {
  if (disc.contacts == 0) return;
  const FitCounts& c = disc.counts;
  const std::array<std::size_t, 4> counts{c.stick, c.slide, c.smooth, c.open};
  const bool plain = disc.dimension == 1;
  const std::array<const char*, 4> words{"sticking", "sliding", plain ? "closed" : "closed, without friction", "open"};
  const Element row = parent.add("div", "bar-row");
  row.add("span", "bar-label").text("What the contacts do, as near as the answer comes to it");
  std::vector<BarPart> parts;
  for (std::size_t i = 0; i < counts.size(); ++i) parts.push_back({std::string(fill_class(fit_signs[i])), counts[i]});
  add_bar(row, parts, 600, 22);
  const Element list = row.add("ul", "legend");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0 && !(plain && i >= 2)) continue;
    const Element item = list.add("li");
    add_swatch(item, fit_signs[i]);
    item.add("b").text(std::to_string(counts[i]));
    item.text(words[i]);
  }
}

void add_disc_legend(const Element& parent, const ConeDisc& disc) {
  const Element list = parent.add("ul", "legend");
  const auto entry = [&](ConeSign sign, const std::string& text) { add_sign_entry(list, sign, text); };
  if (disc.counts.stick > 0) entry(ConeSign::stick, "sticks");
  if (disc.counts.slide > 0) entry(ConeSign::slide, "slides");
  const auto marked = [](const ConePoint& point) { return point.marked; };
  if (std::any_of(disc.points.begin(), disc.points.end(), marked))
    entry(ConeSign::marked, "one of the worst, with its number");
  entry(ConeSign::law, disc.law != FrictionLaw::cone ? std::string(name(disc.law)) : "friction cone");
  if (disc.law != FrictionLaw::cone) entry(ConeSign::pyramid, "friction cone");
  if (disc.right_for) entry(ConeSign::pyramid, std::string(name(*disc.right_for)));
}

/// Says what the picture leaves out, so that readers do not expect more in it.
std::string left_out(const ConeDisc& disc) {
  std::string text;
  if (disc.points.size() < disc.placed) {
    text += fmt::format(" Of {} contacts with a place {} are drawn, evenly by their numbers, the worst always.",
                        disc.placed, disc.points.size());
  }
  const auto beyond = static_cast<std::size_t>(
      std::count_if(disc.points.begin(), disc.points.end(), [&](const ConePoint& p) { return is_beyond(disc, p); }));
  if (beyond > 0)
    text += fmt::format(" {} at the edge, because {} farther out.",
                        counted(beyond, "point") + (beyond == 1 ? " stands" : " stand"),
                        beyond == 1 ? "its place is" : "their places are");
  if (disc.counts.open > 0) text += " Not drawn: " + counted(disc.counts.open, "open contact") + ".";
  if (disc.counts.smooth > 0)
    text += " Not drawn, for want of friction: " + counted(disc.counts.smooth, "contact") + ".";
  if (!disc.unplaced.empty()) text += " Not drawn though among the worst: " + numbers_words(disc.unplaced, 10) + ".";
  return text;
}

void add_disc_table(const Element& parent, const ConeDisc& disc, const JudgedProblem& problem, std::size_t answer) {
  const ContactJudgement& j = problem.answers[answer].judgement;
  Document hidden;
  ReportTable& table =
      hidden.details("The same as a table").table({{"contact", "mode", {"r_N", true}, {"r_T / (μ r_N)", true}}});
  if (disc.dimension == 3) {
    table.columns.back().name = "r_T1 / (μ r_N)";
    table.columns.emplace_back("r_T2 / (μ r_N)", true);
  }
  const std::size_t rows = std::min(disc.points.size(), tabled_contacts);
  table.label = label_of("Contacts in their cones", answer);
  table.caption = rows == disc.placed
                      ? "Rounded to four digits."
                      : fmt::format("The first {} contacts that are drawn, rounded to four digits.", rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const ConePoint& point = disc.points[i];
    std::vector<ReportCell> cells{std::to_string(point.contact + 1), point.slides ? "slides" : "sticks",
                                  fmt::format("{:.4g}", j.x[problem.mixed.normal(point.contact)])};
    for (std::size_t t = 0; t + 1 < disc.dimension; ++t) cells.emplace_back(fmt::format("{:.4g}", point.at[t]));
    table.row(std::move(cells));
  }
  add_document(parent, hidden);
}

void add_cone_figure(const Element& parent, const ConeDisc& disc, const JudgedProblem& problem, std::size_t answer) {
  if (disc.points.empty() || is_bounded(problem.mixed.law.kind)) return;  // no bound is mu r_N
  const Element figure = parent.add("figure", "phase small cones");
  figure.add("h3").text("Contacts in their friction cones");
  add_cone_disc(figure.add("div", "plot").set("tabindex", 0), disc, id_of(answer) + "-cones");
  add_disc_legend(figure, disc);
  const std::string shape = disc.law == FrictionLaw::cone  ? "disc"
                            : disc.law == FrictionLaw::box ? "square"
                                                           : "diamond";
  const std::string where =
      disc.dimension == 2 ? "between −1 and 1, and at an end" : "in the " + shape + ", and on its edge";
  figure.add("figcaption")
      .text("Each contact's tangential force over μ times its normal force: the law keeps it " + where +
            " where the contact slides. The larger the normal force, the larger the point." + left_out(disc));
  add_disc_table(figure, disc, problem, answer);
}

}  // namespace

Element add_contact_chip(const Element& parent, ContactVerdict verdict) {
  const VerdictLook how = look(verdict);
  return add_chip(parent, how.css_class, how.sign, name(verdict));
}

void add_contact_card(const Element& main, const JudgedProblem& problem, std::size_t answer) {
  const JudgedAnswer& judged = problem.answers[answer];
  const ContactJudgement& j = judged.judgement;
  const std::string id = id_of(answer);
  const Element section =
      add_section(main, id.c_str(),
                  (problem.answers.size() == 1 ? "Answer: " : fmt::format("Answer {}: ", answer + 1)) + judged.origin);
  const VerdictLook how = look(j.verdict);
  const Element ruling = section.add("p", "ruling " + std::string(how.css_class));
  ruling.add("span").set("aria-hidden", "true").text(how.sign);
  ruling.text(name(j.verdict));
  section.add("p", "lead").text(verdict_words(j, units_of(problem)));
  if (const std::string words = coulomb_words(problem, answer); !words.empty()) section.add("p").text(words);
  if (!j.residual) return add_reasons(section, j);
  const ConeDisc disc = cone_disc(problem.mixed, j, std::max(drawn_at_least, drawn_contacts / problem.answers.size()));
  const Element halves = section.add("div", "halves");
  const Element numbers = halves.add("div");
  add_reasons(numbers, j);
  add_bounds(numbers, j);
  add_fit_bar(numbers.add("div", "bars"), disc);
  add_cone_figure(halves, disc, problem, answer);
  add_all_motions_figure(section, problem, answer, id);
  add_worst(section, *j.residual, answer);
}

}  // namespace slipproof
