// A contact problem as one JSON object. FORMATS.md has its keys.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/json_tree.hpp"
#include "base/number/parse.hpp"
#include "contact/formats/problem_file.hpp"

namespace slipproof {

/// A contact problem as a JSON object, whose numbers are still text; the caller chooses their type. `text` must outlive
/// it. All functions throw InputError with the path of the wrong value ("W[3][2]", counted from 1), or with line and
/// column if the text is not JSON.
class JsonProblem {
 public:
  JsonProblem(std::string_view text, std::string file);

  const JsonNode* find(std::string_view key) const { return tree_.root.find(key); }
  const JsonNode& need(const std::string& key, const std::string& expected) const;
  [[noreturn]] void refuse(const std::string& where, const std::string& message) const;
  /// The same with the place of a value.
  [[noreturn]] void refuse(const JsonNode& node, const std::string& where, const std::string& message) const;

  /// Whether it is a contact problem at all: it has a list q, or M and H, or the dimension 3.
  bool is_problem() const;
  /// Whether it says more than the reader of small problems in exact numbers takes: contacts in space, a sparse matrix,
  /// bilateral rows, the global form, a law.
  bool is_large() const;

  ProblemForm form() const;
  /// The dimension of contacts with friction, from the key `dimension` or from the sizes. `coefficients` is the length
  /// of a list mu.
  std::size_t dimension(std::size_t components, std::optional<std::size_t> coefficients) const;
  /// The name of the matrix in the file: "W" or "M".
  const char* matrix_name() const;

  /// Calls read() and returns its result; adds the place and path of the node to a NumberError.
  template <class Read>
  auto at(const JsonNode& node, const std::string& where, const Read& read) const {
    try {
      return read();
    } catch (const NumberError& error) {
      refuse(node, where, error.what());
    }
  }
  /// Calls put(number) for each item of a list. The same.
  void each_number(const JsonNode& list, const std::string& where,
                   const std::function<void(const JsonNode&)>& put) const;
  /// The results of number(item) for each item of a list. The same.
  template <class Number>
  auto numbers(const JsonNode& list, const std::string& where, const Number& number) const {
    std::vector<decltype(number(list))> result;
    each_number(list, where, [&](const JsonNode& item) { result.push_back(number(item)); });
    return result;
  }
  /// Coefficients of friction for all contacts, from `mu`: a list, or one number for all. Sets the contacts' dimension.
  /// The same.
  template <class Number>
  auto coefficients(std::size_t components, std::size_t& dimension, const Number& number) const {
    const JsonNode& mu = need("mu", "a coefficient of friction, or one for each contact");
    if (mu.kind == JsonNode::Kind::list) {
      auto each = numbers(mu, "mu", number);
      dimension = this->dimension(components, each.size());
      return each;
    }
    const auto common = at(mu, "mu", [&] { return number(mu); });
    dimension = this->dimension(components, std::nullopt);
    return std::vector<decltype(number(mu))>(components / dimension, common);
  }
  /// Calls put(row, column, number) for each entry of a matrix, dense or sparse, of this size. The same.
  using PutEntry = std::function<void(std::size_t, std::size_t, const JsonNode&)>;
  void each_entry(const std::string& name, std::size_t rows, std::size_t columns, const PutEntry& put) const;

  /// The part of an answer with one of these names, and its name; null if there is none.
  std::pair<const JsonNode*, std::string> part(std::initializer_list<const char*> names) const;
  void refuse_unknown() const;

  const std::string& file() const { return file_; }
  const std::vector<std::string_view>& keys() const { return tree_.root.keys; }

 private:
  std::size_t count(const JsonNode& node, const std::string& where) const;
  std::size_t index(const JsonNode& node, const std::string& where, std::size_t bound) const;
  void expect_size(const std::string& where, std::size_t found, std::size_t expected) const;
  void each_of_rows(const JsonNode& node, const std::string& name, std::size_t rows, std::size_t columns,
                    const PutEntry& put) const;
  void each_of_sparse(const JsonNode& node, const std::string& name, std::size_t rows, std::size_t columns,
                      const PutEntry& put) const;

  std::string_view text_;
  std::string file_;
  JsonTree tree_;
};

/// Reads the complete problem, rounding numbers to the nearest binary64.
ReadProblem read_json_problem(const JsonProblem& json);
ReadProblem read_json_problem(std::string_view text, const std::string& file);

/// The nearest binary64 to a number, or to a text with one in any form that scenes have. NaN, infinities and numbers
/// that become one are numbers, too, if `any` allows them. Counts in `rounded` the fractions and hexadecimal numbers
/// that are no binary64. Throws NumberError.
double nearest_number(const JsonNode& node, bool any, std::size_t& rounded);

}  // namespace slipproof
