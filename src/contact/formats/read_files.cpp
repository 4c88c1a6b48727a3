#include "contact/formats/read_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>

#include "base/files/numpy.hpp"
#include "base/files/words.hpp"
#include "base/input/text_file.hpp"
#include "base/input/utf8.hpp"
#include "contact/formats/fclib.hpp"
#include "contact/formats/json_problem.hpp"
#include "contact/formats/matrix_market.hpp"
#include "contact/formats/problem_check.hpp"
#include "contact/formats/siconos.hpp"

namespace slipproof {

namespace {

/// Nothing where no format begins so.
std::optional<ProblemFormat> format_of(std::string_view bytes) {
  if (bytes.starts_with(hdf5_signature)) return ProblemFormat::fclib;
  if (bytes.starts_with('%')) return ProblemFormat::matrix_market;  // its banner, or what was meant to be it
  if (WordReader(bytes).rest().starts_with('{')) return ProblemFormat::json;
  if (begins_as_siconos(bytes)) return ProblemFormat::siconos;
  return std::nullopt;
}

struct PartName {
  std::string_view name;
  std::vector<double> SolverAnswer::*part;
  std::optional<std::size_t> AnswerSizes::*size;
};

constexpr std::array<PartName, 10> part_names{{
    {"r", &SolverAnswer::r, &AnswerSizes::r},
    {"z", &SolverAnswer::r, &AnswerSizes::r},
    {"reaction", &SolverAnswer::r, &AnswerSizes::r},
    {"u", &SolverAnswer::u, &AnswerSizes::u},
    {"w", &SolverAnswer::u, &AnswerSizes::u},
    {"velocity", &SolverAnswer::u, &AnswerSizes::u},
    {"v", &SolverAnswer::v, &AnswerSizes::v},
    {"globalVelocity", &SolverAnswer::v, &AnswerSizes::v},
    {"l", &SolverAnswer::lambda, &AnswerSizes::lambda},
    {"lambda", &SolverAnswer::lambda, &AnswerSizes::lambda},
}};

const PartName* part_named(std::string_view name) {
  const auto* const at = std::ranges::find(part_names, name, &PartName::name);
  return at == part_names.end() ? nullptr : at;
}

struct NamedNumbers {
  std::string name;
  std::vector<double> numbers;
};

/// What a file calls by the names of parts.
SolverAnswer answer_of(const std::vector<NamedNumbers>& named, const std::string& file) {
  SolverAnswer answer;
  for (const auto& [name, numbers] : named) {
    const PartName* part = part_named(name);
    if (part == nullptr) continue;
    if (!(answer.*part->part).empty()) {
      refuse(file, name + ": found the same part under two names, expected one of them");
    }
    answer.*part->part = numbers;
  }
  return answer;
}

SolverAnswer json_answer(std::string_view text, const std::string& file, const AnswerSizes& sizes) {
  const JsonProblem json(text, file);
  std::vector<NamedNumbers> lists;
  for (const std::string_view key : json.keys()) {
    const PartName* part = part_named(key);
    if (part == nullptr) continue;
    NamedNumbers& list = lists.emplace_back(NamedNumbers{std::string(key), {}});
    const JsonNode& node = *json.find(key);
    refuse_more(file, list.name + ": ", node.size(), sizes.*part->size);
    std::size_t rounded = 0;
    json.each_number(node, list.name,
                     [&](const JsonNode& x) { list.numbers.push_back(nearest_number(x, true, rounded)); });
  }
  return answer_of(lists, file);
}

std::vector<double> plain_numbers(std::string_view text, const std::string& file, std::optional<std::size_t> most) {
  WordReader words(text);
  std::vector<double> result;
  try {
    while (!words.peek().empty()) {
      if (most && result.size() == *most)
        words.stop("the end of the " + std::to_string(*most) + " numbers of the answer");
      result.push_back(words.number("a number of the answer"));
    }
  } catch (const FormatStop& stop) {
    refuse(file, text, stop);
  }
  return result;
}

/// Of what does not even begin like a text of Siconos; returns of what begins with a digit, for its grammars to refuse.
void refuse_unknown(std::string_view bytes, const std::string& file) {
  const std::string expected =
      "a contact problem in HDF5, MatrixMarket, JSON, or text of Siconos, which begins with counts";
  WordReader words(bytes);
  std::string_view word = words.peek();
  if (!word.empty() && word[0] >= '0' && word[0] <= '9') return;
  for (; !word.empty(); word.remove_prefix(utf8_length(word))) {
    const bool is_text = utf8_length(word) > 0 && word[0] != '\0';
    if (!is_text) refuse(file, "found bytes that are not text, expected " + expected);
  }
  try {
    words.stop(expected);
  } catch (const FormatStop& stop) {
    refuse(file, bytes, stop);
  }
}

SolverAnswer answer_in(const std::string& bytes, const std::string& file, const AnswerSizes& sizes) {
  if (bytes.starts_with(zip_signature)) {
    refuse(
        file,
        "found an archive of NumPy (.npz), expected one array (.npy) with r, or JSON with r, u, v and lambda. Python "
        "makes one: numpy.save(\"r.npy\", numpy.load(\"a.npz\")[\"r\"])");
  }
  if (bytes.starts_with(npy_signature)) return answer_of({{"r", read_npy(bytes, file, sizes.r)}}, file);
  const std::optional<ProblemFormat> format = format_of(bytes);
  if (format == ProblemFormat::fclib) return read_fclib_answer(bytes, file, sizes);
  if (format == ProblemFormat::json) return json_answer(bytes, file, sizes);
  if (format == ProblemFormat::matrix_market) {
    return answer_of({{"r", read_market_vector(bytes, file, sizes.r)}}, file);
  }
  return answer_of({{"r", plain_numbers(bytes, file, sizes.r)}}, file);
}

/// Whether the object in a file is a problem for this reader: a large one, or one on several lines. What is no JSON but
/// has a list is meant as one.
bool is_problem_object(const std::string& path) {
  try {
    const std::string text = read_text_file(path, max_problem_file_size);
    const std::size_t begin = text.find('{'), end = text.rfind('}');
    const bool in_lines = text.find('\n', begin) < end;
    try {
      const JsonProblem json(text, path);
      return json.is_large() || (in_lines && json.is_problem());
    } catch (const InputError&) {
      return text.find('[') != std::string::npos;
    }
  } catch (const InputError&) {
    return false;
  }
}

/// With all remarks.
ReadProblem checked(ReadProblem read, const std::string& path) {
  Mistakes mistakes(path);
  check_problem(read.problem, mistakes);
  for (const SolverAnswer& answer : read.answers) check_answer(read.problem, answer, answer.origin + ": ", mistakes);
  mistakes.refuse_if_any();
  add_remarks(read);
  return read;
}

}  // namespace

ReadProblem read_problem_file(const std::string& path) {
  const std::string bytes = read_text_file(path, max_problem_file_size);
  ReadProblem result;
  switch (const auto format = format_of(bytes); format.value_or(ProblemFormat::siconos)) {
    case ProblemFormat::fclib:
      result = read_fclib(bytes, path);
      break;
    case ProblemFormat::matrix_market:
      result = read_matrix_market(bytes, path);
      break;
    case ProblemFormat::json:
      result = read_json_problem(bytes, path);
      break;
    case ProblemFormat::siconos:
      if (!format) refuse_unknown(bytes, path);
      result.problem = read_siconos(bytes, path);
      break;
  }
  return checked(std::move(result), path);
}

ReadProblem read_problem_line(const JsonProblem& json) {
  return checked(read_json_problem(json), json.file());
}

SolverAnswer read_answer_file(const std::string& path, const AnswerSizes& sizes) {
  SolverAnswer answer = answer_in(read_text_file(path, max_problem_file_size), path, sizes);
  answer.origin = path;
  if (answer.r.empty() && answer.u.empty()) {
    refuse(path, "found neither r nor u, expected an answer: numbers, or r, u, v and lambda under their names");
  }
  return answer;
}

bool is_json_lines(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  constexpr const char* blanks = " \t\r\n";
  std::string line;
  if (!(file >> std::ws) || file.peek() != '{' || !std::getline(file, line)) return false;
  return line[line.find_last_not_of(blanks)] == '}' && (file >> std::ws) && file.peek() == '{';
}

bool is_problem_file(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string start(4096, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  const std::optional<ProblemFormat> format = format_of(start);
  if (format != ProblemFormat::json) return format.has_value();
  return !is_json_lines(path) && is_problem_object(path);
}

}  // namespace slipproof
