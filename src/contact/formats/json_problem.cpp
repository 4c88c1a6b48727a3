#include "contact/formats/json_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/files/words.hpp"
#include "contact/formats/problem_check.hpp"

namespace slipproof {

namespace {

constexpr std::array<std::string_view, 15> local_keys{"dimension", "title", "contacts", "W", "M", "q", "mu",    "V",
                                                      "R",         "s",     "r",        "z", "u", "w", "lambda"};
constexpr std::array<std::string_view, 14> global_keys{"dimension", "title", "contacts", "M", "H", "f", "w",
                                                       "mu",        "G",     "b",        "r", "z", "u", "lambda"};
constexpr std::array<std::string_view, 12> law_keys{
    "law",        "bounds",   "compliance", "bias",        "units",
    "slip_speed", "function", "impact",     "restitution", "tangential_restitution",
    "u_before",   "v_before"};

}  // namespace

JsonProblem::JsonProblem(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
  try {
    tree_ = read_json_tree(text);
  } catch (const FormatStop& stop) {
    slipproof::refuse(file_, text, stop);
  }
}

const JsonNode& JsonProblem::need(const std::string& key, const std::string& expected) const {
  const JsonNode* node = find(key);
  if (node == nullptr) refuse(key, "found nothing, expected " + expected);
  return *node;
}

void JsonProblem::refuse(const std::string& where, const std::string& message) const {
  slipproof::refuse(file_, where + ": " + message);
}

void JsonProblem::refuse(const JsonNode& node, const std::string& where, const std::string& message) const {
  const char *const begin = text_.data(), *const at = node.text.data();
  const bool is_there = std::greater_equal<>()(at, begin) && std::less<>()(at, begin + text_.size());
  if (!is_there) refuse(where, message);
  slipproof::refuse(file_, text_, {static_cast<std::size_t>(at - begin), where + ": " + message});
}

bool JsonProblem::is_problem() const {
  const JsonNode* q = find("q");
  return (q != nullptr && q->kind == JsonNode::Kind::list) || is_large();
}

bool JsonProblem::is_large() const {
  const JsonNode* dimension = find("dimension");
  if (dimension != nullptr && dimension->text == "3") return true;
  if (find("M") != nullptr && find("H") != nullptr) return true;
  constexpr std::array<const char*, 6> matrices{"W", "M", "H", "G", "V", "R"};
  const auto is_sparse = [&](const char* matrix) {
    const JsonNode* node = find(matrix);
    return node != nullptr && node->kind == JsonNode::Kind::object;
  };
  const auto has = [&](std::string_view key) { return find(key) != nullptr; };
  constexpr std::array<std::string_view, 4> bilateral{"V", "R", "s", "lambda"};
  return std::ranges::any_of(matrices, is_sparse) || std::ranges::any_of(law_keys, has) ||
         std::ranges::any_of(bilateral, has);
}

ProblemForm JsonProblem::form() const {
  if (find("H") != nullptr) return ProblemForm::global;
  return find("dimension") != nullptr || find("mu") != nullptr ? ProblemForm::local : ProblemForm::complementarity;
}

std::size_t JsonProblem::dimension(std::size_t components, std::optional<std::size_t> coefficients) const {
  if (const JsonNode* given = find("dimension")) {
    const std::size_t dimension = count(*given, "dimension");
    if (dimension == 2 || dimension == 3) return dimension;
    refuse("dimension", "found " + std::to_string(dimension) + ", expected 2 or 3");
  }
  const DimensionBySizes found = dimension_by_sizes(components, coefficients);
  if (!found.mistake.empty()) refuse(found.key, found.mistake);
  return found.dimension;
}

const char* JsonProblem::matrix_name() const {
  if (find("M") == nullptr) return "W";
  if (find("W") != nullptr) refuse("M", "found it together with W, expected one of them");
  return "M";
}

void JsonProblem::each_entry(const std::string& name, std::size_t rows, std::size_t columns,
                             const PutEntry& put) const {
  const JsonNode& node = need(name, "a matrix");
  if (node.kind == JsonNode::Kind::object) return each_of_sparse(node, name, rows, columns, put);
  each_of_rows(node, name, rows, columns, put);
}

void JsonProblem::expect_size(const std::string& where, std::size_t found, std::size_t expected) const {
  if (found == expected) return;
  refuse(where,
         "found " + std::to_string(found) + ", expected " + std::to_string(expected) + ", the length of the vectors");
}

void JsonProblem::each_number(const JsonNode& list, const std::string& where,
                              const std::function<void(const JsonNode&)>& put) const {
  if (list.kind != JsonNode::Kind::list) refuse(where, "found no list, expected a list of numbers");
  std::size_t k = 0;
  try {
    for (; k < list.size(); ++k) put(list.item(k));
  } catch (const NumberError& error) {
    refuse(list.item(k), where + "[" + std::to_string(k + 1) + "]", error.what());
  }
}

void JsonProblem::each_of_rows(const JsonNode& node, const std::string& name, std::size_t rows, std::size_t columns,
                               const PutEntry& put) const {
  if (node.kind != JsonNode::Kind::list) {
    refuse(name, "found no matrix, expected a list of rows, or an object of rows, columns and entries");
  }
  expect_size("the number of rows of " + name, node.size(), rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::string where = name + "[" + std::to_string(i + 1) + "]";
    if (node.items.empty()) refuse(where, "found no list, expected a list of numbers");
    const JsonNode& row = node.items[i];
    std::size_t j = 0;
    if (row.kind == JsonNode::Kind::list) expect_size("the number of columns of " + where, row.size(), columns);
    each_number(row, where, [&](const JsonNode& number) { put(i, j, number), ++j; });
  }
}

void JsonProblem::each_of_sparse(const JsonNode& node, const std::string& name, std::size_t rows, std::size_t columns,
                                 const PutEntry& put) const {
  const JsonNode *high = node.find("rows"), *wide = node.find("columns"), *list = node.find("entries");
  if (high == nullptr || wide == nullptr || list == nullptr || node.keys.size() != 3 ||
      list->kind != JsonNode::Kind::list) {
    refuse(name, "found other keys, expected rows, columns and a list of entries");
  }
  expect_size(name + ".rows", count(*high, name + ".rows"), rows);
  expect_size(name + ".columns", count(*wide, name + ".columns"), columns);
  for (std::size_t k = 0; k < list->size(); ++k) {
    const JsonNode entry = list->item(k);
    const std::string where = name + ".entries[" + std::to_string(k + 1) + "]";
    if (entry.kind != JsonNode::Kind::list || entry.size() != 3) {
      refuse(where, "found no entry, expected [row, column, number]");
    }
    const auto i = index(entry.item(0), where + "[1]", rows), j = index(entry.item(1), where + "[2]", columns);
    at(entry.item(2), where + "[3]", [&] { put(i, j, entry.item(2)); });
  }
}

std::size_t JsonProblem::count(const JsonNode& node, const std::string& where) const {
  std::size_t rounded = 0;
  const double x = at(node, where, [&] { return nearest_number(node, false, rounded); });
  if (x < 0 || x > 0x1p53 || x != std::floor(x)) refuse(where, "found no count, expected 0, 1, 2, ...");
  return static_cast<std::size_t>(x);
}

std::size_t JsonProblem::index(const JsonNode& node, const std::string& where, std::size_t bound) const {
  const std::size_t found = count(node, where);
  if (found < bound) return found;
  refuse(where, "found " + std::to_string(found) + ", expected one from 0 to " + std::to_string(bound) + " - 1");
}

std::pair<const JsonNode*, std::string> JsonProblem::part(std::initializer_list<const char*> names) const {
  std::pair<const JsonNode*, std::string> result{nullptr, *names.begin()};
  for (const char* name : names) {
    const JsonNode* node = find(name);
    if (node == nullptr) continue;
    if (result.first != nullptr) refuse(name, "found it together with " + result.second + ", expected one of them");
    result = {node, name};
  }
  return result;
}

void JsonProblem::refuse_unknown() const {
  const bool global = form() == ProblemForm::global;
  for (const std::string_view key : tree_.root.keys) {
    const bool known = (global ? std::ranges::find(global_keys, key) != global_keys.end() || key == "v"
                               : std::ranges::find(local_keys, key) != local_keys.end()) ||
                       std::ranges::find(law_keys, key) != law_keys.end() || (key == "mode" && !is_large());
    if (!known) {
      refuse(std::string(key), std::string("found an unknown key, expected ") +
                                   (global ? "dimension, M, H, f, w, mu, G, b, r, u, v, lambda, law, title"
                                           : "dimension, W, q, mu, V, R, s, r, u, lambda, law, title") +
                                   " or another of FORMATS.md");
    }
  }
}

}  // namespace slipproof
