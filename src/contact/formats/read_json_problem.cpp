// A contact problem in JSON with numbers as the nearest binary64.
#include <array>
#include <cmath>

#include "base/files/words.hpp"
#include "base/number/binary64.hpp"
#include "contact/formats/entries.hpp"
#include "contact/formats/json_problem.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

namespace {

/// `coulomb, cone, box, ... or regularised`.
std::string any_of(const std::vector<std::string>& words) {
  std::string text = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) text += (i + 1 < words.size() ? ", " : " or ") + words[i];
  return text;
}

class RoundedProblem {
 public:
  explicit RoundedProblem(const JsonProblem& json) : json_(json) {}

  ReadProblem read() {
    ProblemFile& p = read_.problem;
    p.form = json_.form();
    p.dimension = 1;
    const bool global = p.form == ProblemForm::global;
    if (const auto title = json_.find("title")) p.title = title->text;
    if (json_.find("mode") != nullptr)
      json_.refuse("mode", "found it, expected it of small problems only, which are judged in exact numbers");
    global ? read_global() : read_local();
    read_coefficients();
    read_law();
    read_impact();
    read_units();
    SolverAnswer answer;
    answer.origin = "r, u";
    answer.r = part({"r", "z"});
    answer.u = global ? part({"u"}) : part({"u", "w"});
    answer.v = part({"v"});
    answer.lambda = part({"lambda"});
    const bool empty = p.components() == 0 && (json_.find("r") != nullptr || json_.find("z") != nullptr);
    if (!answer.r.empty() || !answer.u.empty() || empty) read_.answers.push_back(std::move(answer));
    json_.refuse_unknown();
    if (rounded_ > 0) {
      p.remarks.push_back(std::to_string(rounded_) + (rounded_ == 1 ? " fraction is" : " fractions are") +
                          " no binary64: the nearest is judged");
    }
    return std::move(read_);
  }

 private:
  void read_local() {
    ProblemFile& p = read_.problem;
    p.q = vector("q");
    p.W = matrix(json_.matrix_name(), p.q.size(), p.q.size());
    if (json_.find("V") == nullptr && json_.find("R") == nullptr) return;
    p.s = vector("s");
    p.V = matrix("V", p.q.size(), p.s.size());
    p.R = matrix("R", p.s.size(), p.s.size());
  }

  void read_global() {
    ProblemFile& p = read_.problem;
    p.f = vector("f");
    p.w = vector("w");
    p.M = matrix("M", p.f.size(), p.f.size());
    p.H = matrix("H", p.f.size(), p.w.size());
    if (json_.find("G") == nullptr) return;
    p.b = vector("b");
    p.G = matrix("G", p.f.size(), p.b.size());
  }

  void read_coefficients() {
    ProblemFile& p = read_.problem;
    if (p.form == ProblemForm::complementarity) return;
    const std::size_t components = p.form == ProblemForm::global ? p.w.size() : p.q.size();
    p.mu = json_.coefficients(components, p.dimension,
                              [&](const JsonNode& x) { return nearest_number(x, false, rounded_); });
  }

  /// What a solver solves in place of Coulomb's law.
  void read_law() {
    ProblemFile& p = read_.problem;
    if (const auto law = text_of("law")) {
      const auto kind = law_called(*law);
      if (!kind) json_.refuse("law", "found '" + *law + "', expected " + any_of(law_words()));
      p.law.kind = *kind;
    }
    if (const auto function = text_of("function")) {
      const auto kind = regularisation_called(*function);
      if (!kind) json_.refuse("function", "found '" + *function + "', expected linear or soft");
      p.law.function = *kind;
    }
    if (const JsonNode* speed = json_.find("slip_speed")) p.law.slip_speed = number(*speed, "slip_speed");
    if (!is_bounded(p.law.kind)) refuse_of_other("bounds", FrictionLaw::fixed);
    refuse_of_other("slip_speed", FrictionLaw::regularised);
    refuse_of_other("function", FrictionLaw::regularised);
    p.law.bounds = each("bounds", p.contacts() * bounds_of_contact(p.law.kind, p.dimension));
    p.compliance = each("compliance", p.components());
    p.bias = each("bias", p.components());
  }

  /// What belongs to another law than the one that is named.
  void refuse_of_other(const std::string& key, FrictionLaw law) const {
    if (json_.find(key) == nullptr || json_.find("law") == nullptr || read_.problem.law.kind == law) return;
    json_.refuse(key, "found it with the law " + std::string(word(read_.problem.law.kind)) + ", expected " +
                          std::string(word(law)));
  }

  /// A law of impact, beside that of friction.
  void read_impact() {
    ProblemFile& p = read_.problem;
    const std::string before = velocities_before_key(p.form == ProblemForm::global);
    const auto word = text_of("impact");
    for (const std::string key : {"restitution", "tangential_restitution", "u_before", "v_before"}) {
      if (json_.find(key) == nullptr) continue;
      if (!word) json_.refuse(key, "found it without impact, expected impact: \"newton\" or \"moreau\"");
      if (key.ends_with("before") && key != before) json_.refuse(key, "found it, expected " + before + " in this form");
    }
    if (!word) return;
    const auto law = parse_impact_law(*word);
    if (!law || *law == ImpactLaw::poisson) {
      json_.refuse("impact", "found '" + *word + "', expected newton or moreau" +
                                 (law ? ": a record does not tell the impulses at the end of compression" : ""));
    }
    json_.need("restitution", "a restitution, or one for each contact");
    json_.need(before, "the velocities before the step");
    p.impact.emplace();
    p.impact->law = *law;
    p.impact->restitution = each("restitution", p.contacts());
    p.impact->tangential_restitution = each("tangential_restitution", p.contacts());
    p.impact->before = vector(before);
  }

  void read_units() {
    const JsonNode* units = json_.find("units");
    if (units == nullptr) return;
    ProblemFile& p = read_.problem;
    const JsonNode *force = units->find("force"), *velocity = units->find("velocity");
    const bool texts = force != nullptr && velocity != nullptr && force->kind == JsonNode::Kind::text &&
                       velocity->kind == JsonNode::Kind::text;
    if (!texts || units->keys.size() != 2) {
      json_.refuse("units", "found something else, expected {\"force\": \"N s\", \"velocity\": \"m/s\"}");
    }
    p.force_unit = force->text;
    p.velocity_unit = velocity->text;
  }

  std::optional<std::string> text_of(const std::string& key) const {
    const JsonNode* node = json_.find(key);
    if (node == nullptr) return std::nullopt;
    if (node->kind != JsonNode::Kind::text) json_.refuse(key, "found no text, expected a word");
    return std::string(node->text);
  }

  double number(const JsonNode& node, const std::string& where) {
    return json_.at(node, where, [&] { return nearest_number(node, false, rounded_); });
  }
  std::vector<double> list(const JsonNode& node, const std::string& where, bool any = false) {
    return json_.numbers(node, where, [&](const JsonNode& x) { return nearest_number(x, any, rounded_); });
  }
  std::vector<double> vector(const std::string& key) { return list(json_.need(key, "a list of numbers"), key); }

  /// A list, or one number for each of `count` components; empty where there is no such key.
  std::vector<double> each(const std::string& key, std::size_t count) {
    const JsonNode* node = json_.find(key);
    if (node == nullptr) return {};
    if (node->kind == JsonNode::Kind::list) {
      if (node->size() == 0 && count > 0) json_.refuse(key, "found 0 numbers, expected " + std::to_string(count));
      return list(*node, key);
    }
    return std::vector<double>(count, number(*node, key));
  }

  std::vector<double> part(std::initializer_list<const char*> names) {
    const auto [node, name] = json_.part(names);
    return node == nullptr ? std::vector<double>() : list(*node, name, true);
  }

  SparseMatrix matrix(const std::string& name, std::size_t rows, std::size_t columns) {
    std::vector<MatrixEntry> entries;
    const bool sparse = json_.need(name, "a matrix").kind == JsonNode::Kind::object;
    json_.each_entry(name, rows, columns, [&](std::size_t i, std::size_t j, const JsonNode& node) {
      const double x = nearest_number(node, false, rounded_);
      if (sparse) {
        entries.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), x});
      } else {
        put_entry(entries, i, j, x);
      }
    });
    return matrix_of(rows, columns, std::move(entries), [&](const std::string& twice) { json_.refuse(name, twice); });
  }

  const JsonProblem& json_;
  ReadProblem read_;
  std::size_t rounded_ = 0;
};

}  // namespace

double nearest_number(const JsonNode& node, bool any, std::size_t& rounded) {
  if (node.kind != JsonNode::Kind::text && node.kind != JsonNode::Kind::number) {
    throw NumberError(0, "no number", "one");
  }
  const std::optional<double> decimal = read_binary64(node.text);
  // Beyond the decimals are fractions and hexadecimal numbers, which claim to be exact.
  const Rational exact = decimal ? Rational(0) : parse_rational(node.text);
  const double value = decimal ? *decimal : nearest_binary64(exact);
  if (!decimal && std::isfinite(value) && to_rational(value) != exact) ++rounded;
  if (any || std::isfinite(value)) return value;
  throw NumberError(0, std::isnan(value) ? "NaN" : "an infinity, or a number that becomes one",
                    "a finite number within binary64's range");
}

ReadProblem read_json_problem(const JsonProblem& json) {
  return RoundedProblem(json).read();
}

ReadProblem read_json_problem(std::string_view text, const std::string& file) {
  return read_json_problem(JsonProblem(text, file));
}

}  // namespace slipproof
