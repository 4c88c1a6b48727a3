#include "contact/formats/json_problem.hpp"

#include <algorithm>
#include <array>

#include "contact/formats/entries.hpp"
#include "contact/formats/json_tree.hpp"
#include "contact/formats/problem_check.hpp"

namespace slipproof {

namespace {

/// `coulomb, cone, box, ... or regularised`.
std::string any_of(const std::vector<std::string>& words) {
  std::string text = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) text += (i + 1 < words.size() ? ", " : " or ") + words[i];
  return text;
}

class JsonProblem {
 public:
  JsonProblem(const JsonNode& root, const std::string& file) : root_(root), numbers_(file) {}

  ReadProblem read() {
    const bool global = root_.find("H") != nullptr;
    ProblemFile& p = read_.problem;
    if (const JsonNode* title = root_.find("title")) p.title = title->text;
    read_dimension(global);
    global ? read_global() : read_local();
    read_coefficients();
    read_law();
    read_units();
    SolverAnswer answer;
    answer.origin = "r, u";
    answer.r = part({"r", "z"});
    answer.u = global ? part({"u"}) : part({"u", "w"});
    answer.v = part({"v"});
    answer.lambda = part({"lambda"});
    const bool empty = p.components() == 0 && (root_.find("r") != nullptr || root_.find("z") != nullptr);
    if (!answer.r.empty() || !answer.u.empty() || empty) read_.answers.push_back(std::move(answer));
    refuse_unknown(global);
    if (const std::size_t rounded = numbers_.rounded(); rounded > 0) {
      p.remarks.push_back(std::to_string(rounded) + (rounded == 1 ? " fraction is" : " fractions are") +
                          " no binary64: the nearest is judged");
    }
    return std::move(read_);
  }

 private:
  void read_dimension(bool global) {
    ProblemFile& p = read_.problem;
    const JsonNode* dimension = root_.find("dimension");
    const bool frictional = dimension != nullptr || root_.find("mu") != nullptr || global;
    p.form = global ? ProblemForm::global : frictional ? ProblemForm::local : ProblemForm::complementarity;
    p.dimension = 1;
    if (!frictional || dimension == nullptr) return;
    p.dimension = numbers_.count(*dimension, "dimension");
    if (p.dimension == 2 || p.dimension == 3) return;
    numbers_.refuse("dimension", "found " + std::to_string(p.dimension) + ", expected 2 or 3");
  }

  /// Where no key says it.
  void tell_dimension(std::optional<std::size_t> coefficients) {
    ProblemFile& p = read_.problem;
    if (root_.find("dimension") != nullptr) return;
    const std::size_t components = p.form == ProblemForm::global ? p.w.size() : p.q.size();
    const DimensionBySizes found = dimension_by_sizes(components, coefficients);
    if (!found.mistake.empty()) numbers_.refuse(found.key, found.mistake);
    p.dimension = found.dimension;
  }

  void read_local() {
    ProblemFile& p = read_.problem;
    const char* name = root_.find("W") == nullptr && root_.find("M") != nullptr ? "M" : "W";
    p.q = vector("q");
    p.W = matrix(name, p.q.size(), p.q.size());
    if (root_.find("V") == nullptr && root_.find("R") == nullptr) return;
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
    if (root_.find("G") == nullptr) return;
    p.b = vector("b");
    p.G = matrix("G", p.f.size(), p.b.size());
  }

  /// One number is the coefficient of all contacts.
  void read_coefficients() {
    ProblemFile& p = read_.problem;
    if (p.form == ProblemForm::complementarity) return;
    const JsonNode& mu = need("mu", "a coefficient of friction, or one for each contact");
    if (mu.kind == JsonNode::Kind::list) {
      p.mu = numbers_.list(mu, "mu");
      tell_dimension(p.mu.size());
    } else {
      const double each = numbers_.number(mu, "mu");
      tell_dimension(std::nullopt);
      p.mu.assign(p.contacts(), each);
    }
  }

  /// What a solver solves in place of Coulomb's law.
  void read_law() {
    ProblemFile& p = read_.problem;
    if (const auto law = text_of("law")) {
      const auto kind = law_called(*law);
      if (!kind) numbers_.refuse("law", "found '" + *law + "', expected " + any_of(law_words()));
      p.law.kind = *kind;
    }
    if (const auto function = text_of("function")) {
      const auto kind = regularisation_called(*function);
      if (!kind) numbers_.refuse("function", "found '" + *function + "', expected linear or soft");
      p.law.function = *kind;
    }
    if (const JsonNode* speed = root_.find("slip_speed")) p.law.slip_speed = numbers_.number(*speed, "slip_speed");
    refuse_of_other("bounds", FrictionLaw::fixed);
    refuse_of_other("slip_speed", FrictionLaw::regularised);
    refuse_of_other("function", FrictionLaw::regularised);
    p.law.bounds = each("bounds", p.components() - p.contacts());
    p.compliance = each("compliance", p.components());
    p.bias = each("bias", p.components());
  }

  /// What belongs to another law than the one that is named.
  void refuse_of_other(const std::string& key, FrictionLaw law) const {
    if (root_.find(key) == nullptr || root_.find("law") == nullptr || read_.problem.law.kind == law) return;
    numbers_.refuse(key, "found it with the law " + std::string(word(read_.problem.law.kind)) + ", expected " +
                             std::string(word(law)));
  }

  void read_units() {
    const JsonNode* units = root_.find("units");
    if (units == nullptr) return;
    ProblemFile& p = read_.problem;
    const JsonNode *force = units->find("force"), *velocity = units->find("velocity");
    const bool texts = force != nullptr && velocity != nullptr && force->kind == JsonNode::Kind::text &&
                       velocity->kind == JsonNode::Kind::text;
    if (!texts || units->keys.size() != 2) {
      numbers_.refuse("units", "found something else, expected {\"force\": \"N s\", \"velocity\": \"m/s\"}");
    }
    p.force_unit = force->text;
    p.velocity_unit = velocity->text;
  }

  std::optional<std::string> text_of(const std::string& key) const {
    const JsonNode* node = root_.find(key);
    if (node == nullptr) return std::nullopt;
    if (node->kind != JsonNode::Kind::text) numbers_.refuse(key, "found no text, expected a word");
    return node->text;
  }

  /// A list, or one number for each of `count` components; empty where there is no such key.
  std::vector<double> each(const std::string& key, std::size_t count) const {
    const JsonNode* node = root_.find(key);
    if (node == nullptr) return {};
    if (node->kind == JsonNode::Kind::list) {
      if (node->size() == 0 && count > 0) numbers_.refuse(key, "found 0 numbers, expected " + std::to_string(count));
      return numbers_.list(*node, key);
    }
    return std::vector<double>(count, numbers_.number(*node, key));
  }

  const JsonNode& need(const std::string& key, const std::string& expected) const {
    const JsonNode* node = root_.find(key);
    if (node == nullptr) numbers_.refuse(key, "found nothing, expected " + expected);
    return *node;
  }

  std::vector<double> vector(const std::string& key) const {
    return numbers_.list(need(key, "a list of numbers"), key);
  }

  std::vector<double> part(std::initializer_list<const char*> names) const {
    std::vector<double> result;
    for (const char* name : names) {
      const JsonNode* node = root_.find(name);
      if (node == nullptr) continue;
      if (!result.empty())
        numbers_.refuse(name, "found it together with " + std::string(*names.begin()) + ", expected one of them");
      result = numbers_.list(*node, name, true);
    }
    return result;
  }

  SparseMatrix matrix(const std::string& name, std::size_t rows, std::size_t columns) const {
    const JsonNode& node = need(name, "a matrix");
    std::vector<MatrixEntry> entries;
    if (node.kind == JsonNode::Kind::object) {
      read_sparse(node, name, rows, columns, entries);
    } else {
      read_rows(node, name, rows, columns, entries);
    }
    return matrix_of(rows, columns, std::move(entries),
                     [&](const std::string& twice) { numbers_.refuse(name, twice); });
  }

  void size(const std::string& where, std::size_t found, std::size_t expected) const {
    if (found == expected) return;
    numbers_.refuse(where, "found " + std::to_string(found) + ", expected " + std::to_string(expected) +
                               ", the length of the vectors");
  }

  void read_rows(const JsonNode& node, const std::string& name, std::size_t rows, std::size_t columns,
                 std::vector<MatrixEntry>& entries) const {
    if (node.kind != JsonNode::Kind::list) {
      numbers_.refuse(name, "found no matrix, expected a list of rows, or an object of rows, columns and entries");
    }
    size("the number of rows of " + name, node.size(), rows);
    for (std::size_t i = 0; i < rows; ++i) {
      const std::string where = name + "[" + std::to_string(i + 1) + "]";
      const std::vector<double> row = numbers_.list(node.item(i), where);
      size("the number of columns of " + where, row.size(), columns);
      for (std::size_t j = 0; j < columns; ++j) put_entry(entries, i, j, row[j]);
    }
  }

  void read_sparse(const JsonNode& node, const std::string& name, std::size_t rows, std::size_t columns,
                   std::vector<MatrixEntry>& entries) const {
    const JsonNode *high = node.find("rows"), *wide = node.find("columns"), *list = node.find("entries");
    if (high == nullptr || wide == nullptr || list == nullptr || node.keys.size() != 3 ||
        list->kind != JsonNode::Kind::list) {
      numbers_.refuse(name, "found other keys, expected rows, columns and a list of entries");
    }
    size(name + ".rows", numbers_.count(*high, name + ".rows"), rows);
    size(name + ".columns", numbers_.count(*wide, name + ".columns"), columns);
    for (std::size_t k = 0; k < list->size(); ++k) {
      const JsonNode entry = list->item(k);
      const std::string where = name + ".entries[" + std::to_string(k + 1) + "]";
      if (entry.kind != JsonNode::Kind::list || entry.size() != 3) {
        numbers_.refuse(where, "found no entry, expected [row, column, number]");
      }
      const auto i = index(entry.item(0), where + "[1]", rows), j = index(entry.item(1), where + "[2]", columns);
      entries.push_back({i, j, numbers_.number(entry.item(2), where + "[3]")});
    }
  }

  std::uint32_t index(const JsonNode& node, const std::string& where, std::size_t bound) const {
    const std::size_t found = numbers_.count(node, where);
    if (found < bound) return static_cast<std::uint32_t>(found);
    numbers_.refuse(where,
                    "found " + std::to_string(found) + ", expected one from 0 to " + std::to_string(bound) + " - 1");
  }

  void refuse_unknown(bool global) const {
    constexpr std::array<std::string_view, 14> local{"dimension", "title", "contacts", "W", "M", "q", "mu",
                                                     "V",         "R",     "s",        "r", "z", "u", "w"};
    constexpr std::array<std::string_view, 13> whole{"dimension", "title", "contacts", "M", "H", "f", "w",
                                                     "mu",        "G",     "b",        "r", "z", "u"};
    constexpr std::array<std::string_view, 8> common{"lambda", "law",   "bounds",     "compliance",
                                                     "bias",   "units", "slip_speed", "function"};
    for (const std::string& key : root_.keys) {
      const bool known =
          (global ? std::ranges::find(whole, key) != whole.end() : std::ranges::find(local, key) != local.end()) ||
          std::ranges::find(common, key) != common.end() || (key == "v" && global);
      if (!known) {
        numbers_.refuse(key, std::string("found an unknown key, expected ") +
                                 (global ? "dimension, M, H, f, w, mu, G, b, r, u, v, lambda, law, title"
                                         : "dimension, W, q, mu, V, R, s, r, u, lambda, law, title") +
                                 " or another of FORMATS.md");
      }
    }
  }

  const JsonNode& root_;
  JsonNumbers numbers_;
  ReadProblem read_;
};

}  // namespace

ReadProblem read_json_problem(std::string_view text, const std::string& file) {
  const JsonNode root = read_json_tree(text, file);
  return JsonProblem(root, file).read();
}

}  // namespace slipproof
