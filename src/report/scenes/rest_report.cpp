#include "report/scenes/rest_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/scenes/rest_words.hpp"
#include "report/scenes/space_report.hpp"
#include "report/values/exact_json.hpp"
#include "report/values/motions_json.hpp"

namespace slipproof {

namespace {

/// A decimal on the given side of a number.
std::string outward(const Rational& x, bool up, int digits) {
  const Rational slack = abs(x) * pow(Rational(10), -digits + 1);
  return decimal_text(up ? x + slack : x - slack, digits);
}

std::string end_text(const ProvedEnd& end, int digits) {
  constexpr int precise = 12;
  if (end.lower == end.upper) return brief(end.lower, std::max(digits, precise));
  return "between " + outward(end.lower, false, precise) + " and " + outward(end.upper, true, precise);
}

std::string range_text(const std::optional<ProvedEnd>& from, const std::optional<ProvedEnd>& to, int digits) {
  if (!from && !to) return "at every value";
  if (from && to && from->lower == to->upper) return "only at " + end_text(*from, digits);
  std::string text;
  if (from) text += "from " + end_text(*from, digits);
  if (to) text += std::string(from ? " " : "") + "up to " + end_text(*to, digits);
  return text + (from && to ? "" : from ? ", without end above" : ", without end below");
}

bool is_still(const std::vector<Rational>& accelerations) {
  return std::ranges::all_of(accelerations, &Rational::is_zero);
}

bool is_still(const SpaceMotion& motion) {
  return std::ranges::all_of(motion.accelerations, [](const Range& r) { return r.is_point() && r.lower->is_zero(); });
}

class RestText {
 public:
  RestText(const RestAnswer& answer, int digits)
      : answer_(answer), decision_(answer.decision), m_(answer.scene.mechanism), digits_(digits) {}

  Document whole() {
    document_ =
        scene_document(answer_.scene, m_.name + ", " + counted(answer_.problem.contacts.size(), "closed contact"));
    write_decision();
    write_must();
    write_range();
    if (answer_.map)
      write_rest_map(document_.section("Map of " + answer_.map->x + " and " + answer_.map->y), answer_, digits_);
    document_.status("s " + rest_verdict(answer_));
    return std::move(document_);
  }

 private:
  std::string at_load() const {
    if (!m_.load) return "";
    if (!answer_.push) return " at some " + m_.load->symbol;
    return " at " + m_.load->symbol + " = " + exact_text(*answer_.scene.load);
  }

  void write_decision() {
    if (!decision_.can) {
      document_.section("Whether it can rest" + at_load() + " is undecided")
          .paragraph(
              "No forces that hold it and no motion that proves its fall were found with the effort that is made.");
    } else if (*decision_.can) {
      Document& section = document_.section("It can rest" + at_load());
      if (decision_.touching) {
        section.paragraph(
            "Only just: no forces that hold it are inside of all cones of friction, since the motion below "
            "gains no power and costs none.");
      }
      if (!decision_.forces.empty()) write_forces(section);
      if (decision_.border) write_motion(section, "The motion at the border", *decision_.border);
    } else {
      Document& section = document_.section("It cannot rest" + at_load());
      if (!decision_.fall) return;
      section.paragraph(
          "This virtual motion proves it. No contact resists it: where one slips, it opens at least mu "
          "times as fast. And what pushes gains the power " +
          brief(decision_.fall->power, digits_) + ".");
      write_motion(section, "Virtual motion", *decision_.fall);
    }
  }

  void write_forces(Document& section) {
    ReportTable& table = section.section("Forces that hold it").table({{"", ""}});
    for (std::size_t j = 0; j < answer_.problem.forces.size(); ++j) {
      table.row({answer_.problem.forces[j], brief(decision_.forces[j], digits_)});
    }
  }

  void write_motion(Document& section, const std::string& heading, const VirtualMotion& motion) {
    ReportTable& table = section.section(heading).table({{"", ""}});
    if (!m_.bodies) {
      for (std::size_t i = 0; i < motion.rates.size(); ++i) {
        table.row({answer_.problem.rows[i], brief(motion.rates[i], digits_)});
      }
      return;
    }
    for (const Body& body : m_.bodies->bodies) {
      const std::string text = rates_of(body, motion);
      if (!text.empty()) table.row({body.name, text});
    }
  }

  /// `x 1, turns 1/2`.
  std::string rates_of(const Body& body, const VirtualMotion& motion) const {
    constexpr std::array<std::string_view, 6> names{"x", "y", "z", "turns about x", "turns about y", "turns about z"};
    std::vector<std::string> parts;
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto row = std::ranges::find(answer_.problem.rows, body.unknowns[k].symbol);
      if (row == answer_.problem.rows.end()) continue;
      Rational rate = motion.rates[static_cast<std::size_t>(row - answer_.problem.rows.begin())];
      if (rate.is_zero()) continue;
      if (body.unknowns[k].negated) rate = -rate;
      const bool plane = m_.dimension == 2 && k == 5;
      parts.push_back(std::string(plane ? "turns" : names[k]) + " " + brief(rate, digits_));
    }
    return listed(parts, ", ");
  }

  void write_must() {
    const MustRest& must = answer_.must;
    if (decision_.can == false) return;
    const std::string heading = must.must == true    ? "It must rest"
                                : must.must == false ? "It need not rest"
                                                     : "Whether it must rest is open";
    Document& section = document_.section(heading);
    section.paragraph("Because " + must.because + ".");
    if (must.must != false) return;
    if (must.plane) {
      for (const MotionAtLoad& motion : must.plane->at_load->motions) {
        if (is_still(motion.accelerations)) continue;
        section.line("it can move: " + equal_modes(motion.all_modes()));
      }
    } else if (must.space) {
      for (const SpaceMotion& motion : must.space->motions) {
        if (is_still(motion)) continue;
        std::string modes;
        for (const std::string& mode : motion.modes) modes += (modes.empty() ? "" : "/") + mode;
        section.line("it can move: " + modes);
      }
    }
    section.line("`slipproof solve` tells its motions");
  }

  void write_range() {
    if (!answer_.loads && !answer_.tilt && !answer_.parameter) return;
    Document& section = document_.section("Up to where");
    const auto fact = [&](const std::string& name, const std::string& text) { section.paragraph(name + ": " + text); };
    if (const auto& loads = answer_.loads) {
      fact(m_.load->symbol, loads->none       ? "it rests at no value"
                            : !loads->decided ? "no end was found"
                                              : "it can rest " + range_text(loads->from, loads->to, digits_) + uncut());
    }
    if (const auto& tilt = answer_.tilt) {
      fact("tilt", tilt->none       ? "it does not rest at any, since it does not at 0"
                   : !tilt->decided ? "no end was found"
                   : tilt->tangent  ? "it can rest up to the tangent " + end_text(*tilt->tangent, digits_) + ", or " +
                                         end_text(tilt->degrees, digits_) + " degrees"
                                   : "it can rest up to 90 degrees, and perhaps beyond");
    }
    if (const auto& p = answer_.parameter) {
      std::string text =
          p->none ? "no value was found at which it can rest" : "it can rest " + range_text(p->from, p->to, digits_);
      if (!p->none && !p->monotone) text += "; of values further out nothing is said";
      fact(p->name, text);
    }
  }

  /// `; the domain W >= 0 does not cut this`.
  std::string uncut() const {
    std::vector<std::string> conditions;
    for (const PlacedExpression& one : m_.load->domain) {
      if (one && one.expression->operation != Operation::truth) conditions.push_back(to_string(one.expression));
    }
    return conditions.empty() ? "" : "; the domain " + listed(conditions, " and ") + " does not cut this";
  }

  const RestAnswer& answer_;
  const RestDecision& decision_;
  const Mechanism& m_;
  int digits_;
  Document document_;
};

Json end_json(const std::optional<ProvedEnd>& end) {
  return end ? Json::array({to_json(end->lower), to_json(end->upper)}) : Json(nullptr);
}

/// The proof that the load has no end there: forces at a load, and those that each further unit needs.
Json endless_json(const RestProblem& problem, const std::optional<EndlessLoad>& endless) {
  if (!endless) return nullptr;
  return {{"load", to_json(endless->load)},
          {"forces", named_json(problem.forces, endless->forces)},
          {"more", named_json(problem.forces, endless->more)}};
}

Json other_motions(const RestAnswer& answer) {
  Json result = Json::array();
  const Mechanism& m = answer.scene.mechanism;
  if (answer.must.plane) {
    Json all;
    put_motions(all, m, *answer.must.plane->at_load);
    const auto& motions = answer.must.plane->at_load->motions;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (!is_still(motions[i].accelerations)) result.push_back(all["motions"][i]);
    }
    for (const Json& continuum : all["continua"]) result.push_back(continuum);
  } else if (answer.must.space) {
    for (const SpaceMotion& motion : answer.must.space->motions) {
      if (!is_still(motion)) result.push_back(motion_json(m, motion));
    }
  }
  return result;
}

}  // namespace

std::string rest_verdict(const RestAnswer& answer) {
  if (!answer.decision.can) return "UNDECIDED";
  if (!*answer.decision.can) return "CANNOT REST";
  return answer.must.must == true ? "RESTS" : "CAN REST";
}

Document rest_document(const RestAnswer& answer, int digits) {
  return RestText(answer, digits).whole();
}

std::string rest_json(const RestAnswer& answer) {
  const RestDecision& decision = answer.decision;
  const auto truth = [](const std::optional<bool>& x) { return x ? Json(*x) : Json(nullptr); };
  Json document{
      {"schema", "slipproof/rest/1"}, {"scene", answer.scene.name}, {"mechanism", answer.scene.mechanism.name}};
  document["can_rest"] = truth(decision.can);
  document["touching"] = decision.touching;
  document["must_rest"] = truth(answer.must.must);
  document["must_rest_because"] = answer.must.because;
  document["forces"] = decision.forces.empty() ? Json(nullptr) : named_json(answer.problem.forces, decision.forces);
  document["why_not"] = virtual_motion_json(answer.problem, decision.fall);
  document["border"] = virtual_motion_json(answer.problem, decision.border);
  document["other_motions"] = other_motions(answer);
  document["load"] = document["tilt"] = document["parameter"] = nullptr;
  if (const auto& loads = answer.loads) {
    document["load"] = {{"name", *answer.problem.load},  {"value", to_json(answer.scene.load)},
                        {"from", end_json(loads->from)}, {"to", end_json(loads->to)},
                        {"none", loads->none},           {"decided", loads->decided}};
    document["load"]["endless"] = {{"below", endless_json(answer.problem, loads->below)},
                                   {"above", endless_json(answer.problem, loads->above)}};
  }
  if (const auto& tilt = answer.tilt) {
    document["tilt"] = {{"tangent", end_json(tilt->tangent)},
                        {"degrees", end_json(tilt->degrees)},
                        {"none", tilt->none},
                        {"decided", tilt->decided}};
    if (tilt->none || !tilt->decided) document["tilt"]["degrees"] = nullptr;
  }
  if (const auto& p = answer.parameter) {
    document["parameter"] = {{"name", p->name},       {"value", to_json(p->value)}, {"from", end_json(p->from)},
                             {"to", end_json(p->to)}, {"monotone", p->monotone},    {"none", p->none}};
  }
  document["map"] = answer.map ? rest_map_json(answer) : Json(nullptr);
  document["programs"] = answer.programs;
  return json_text(document);
}

}  // namespace slipproof
