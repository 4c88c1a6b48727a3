#include "records/problems/problem_reader.hpp"

#include <cmath>

#include "base/files/words.hpp"
#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

class ExactProblem {
 public:
  ExactProblem(const JsonProblem& json, std::string_view line, bool decimal_exact)
      : json_(json), line_(line), decimal_exact_(decimal_exact) {}

  ProblemRecord read(bool ignore_unknown) {
    ContactProblem& problem = record_.problem;
    problem.q = json_.numbers(json_.need("q", "a list of numbers"), "q", [&](const JsonNode& x) { return number(x); });
    const std::size_t n = problem.q.size();
    if (n == 0 || n > max_problem_size) refuse(json_.file(), mistake_in(problem));
    problem.W.assign(n, std::vector<Rational>(n));
    json_.each_entry(json_.matrix_name(), n, n,
                     [&](std::size_t i, std::size_t j, const JsonNode& node) { problem.W[i][j] = number(node); });
    if (json_.form() == ProblemForm::local) read_coefficients();
    if (const std::string reason = mistake_in(problem); !reason.empty()) refuse(json_.file(), reason);
    record_.answer.z = *part({"z", "r"}, "an answer");
    record_.answer.w = part({"w", "u"});
    read_mode();
    if (!ignore_unknown) json_.refuse_unknown();
    return std::move(record_);
  }

 private:
  void read_coefficients() {
    ContactProblem& problem = record_.problem;
    std::size_t dimension = 0;
    problem.mu = json_.coefficients(problem.size(), dimension, [&](const JsonNode& x) { return number(x); });
    if (dimension == 2) return;
    json_.refuse("dimension", "found nothing, and contacts of 3 components, expected \"dimension\": 3 for those");
  }

  void read_mode() {
    const JsonNode* mode = json_.find("mode");
    if (mode == nullptr) return;
    const ContactProblem& problem = record_.problem;
    if (mode->kind == JsonNode::Kind::text) record_.answer.mode = parse_mode(problem, mode->text);
    if (record_.answer.mode) return;
    json_.refuse("mode", "found " + in_quotes(mode->text) + ", expected " +
                             (problem.frictional() ? "states like stick/slip+/lift, one for each contact"
                                                   : "letters z and w, one for each component"));
  }

  /// A part of the answer, in which NaN and infinities become 0 and are told.
  std::optional<std::vector<Rational>> part(std::initializer_list<const char*> names, const char* needed = nullptr) {
    const auto [node, name] = json_.part(names);
    if (node == nullptr && needed != nullptr) json_.need(name, needed);
    if (node == nullptr) return std::nullopt;
    std::vector<Rational> result;
    json_.each_number(*node, name, [&, &key = name](const JsonNode& x) {
      std::size_t rounded = 0;
      const bool finite = (has_digits(x) && is_exact(x)) || std::isfinite(nearest_number(x, true, rounded));
      result.push_back(finite ? number(x) : Rational(0));
      if (!finite && !record_.not_finite) {
        record_.not_finite = not_finite_at(x, key + "[" + std::to_string(result.size()) + "]");
      }
    });
    if (result.size() == record_.problem.size()) return result;
    json_.refuse(name, "found " + std::to_string(result.size()) + " components, expected " +
                           std::to_string(record_.problem.size()) + " as in q");
  }

  NotFinite not_finite_at(const JsonNode& node, const std::string& where) const {
    const bool quoted = node.kind == JsonNode::Kind::text;
    return {quoted ? 0 : static_cast<std::size_t>(node.text.data() - line_.data()) + 1,
            where + ": found " + std::string(node.text) +
                (has_digits(node) ? ", expected a number that binary64 can hold" : ", expected a finite number")};
  }

  static bool has_digits(const JsonNode& node) {
    return node.text.find_first_of("0123456789") != std::string_view::npos;
  }
  /// Whether it is not rounded: a fraction or a hexadecimal number, or all where decimals are exact.
  bool is_exact(const JsonNode& node) const { return decimal_exact_ || !is_decimal(node.text); }

  Rational number(const JsonNode& node) const {
    std::size_t rounded = 0;
    const bool is_number = node.kind == JsonNode::Kind::number || node.kind == JsonNode::Kind::text;
    if (is_number && is_exact(node)) return parse_rational(node.text);
    return to_rational(nearest_number(node, false, rounded));
  }

  const JsonProblem& json_;
  std::string_view line_;
  bool decimal_exact_;
  ProblemRecord record_;
};

}  // namespace

ProblemRecord read_problem(const JsonProblem& json, std::string_view line, bool decimal_exact, bool ignore_unknown) {
  return ExactProblem(json, line, decimal_exact).read(ignore_unknown);
}

}  // namespace slipproof
