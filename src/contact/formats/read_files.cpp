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

SolverAnswer json_answer(const std::string& text, const std::string& file, const AnswerSizes& sizes) {
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

SolverAnswer market_answer(const std::string& bytes, const std::string& file, const AnswerSizes& sizes) {
  return answer_of({{"r", read_market_vector(bytes, file, sizes.r)}}, file);
}

SolverAnswer plain_answer(const std::string& bytes, const std::string& file, const AnswerSizes& sizes) {
  return answer_of({{"r", plain_numbers(bytes, file, sizes.r)}}, file);
}

/// A format of files with a contact problem, or with an answer alone.
struct FileFormat {
  std::string_view name;
  bool (*begins)(std::string_view bytes);
  ReadProblem (*read)(const std::string& bytes, const std::string& file);
  SolverAnswer (*read_answer)(const std::string& bytes, const std::string& file, const AnswerSizes& sizes);
};

bool begins_as_json(std::string_view bytes) {
  return WordReader(bytes).rest().starts_with('{');
}

constexpr std::array<FileFormat, 4> file_formats{{
    {"FCLIB HDF5", [](std::string_view bytes) { return bytes.starts_with(hdf5_signature); }, read_fclib,
     read_fclib_answer},
    {"Siconos text", begins_as_siconos,
     [](const std::string& bytes, const std::string& file) {
       return ReadProblem{read_siconos(bytes, file), {}};
     },
     plain_answer},
    {"MatrixMarket", [](std::string_view bytes) { return bytes.starts_with('%'); },  // its banner, or meant to be it
     [](const std::string& bytes, const std::string& file) { return read_matrix_market(bytes, file); }, market_answer},
    {"JSON", begins_as_json,
     [](const std::string& bytes, const std::string& file) { return read_json_problem(bytes, file); }, json_answer},
}};

/// Null where no format begins so.
const FileFormat* format_of(std::string_view bytes) {
  const auto* const at = std::ranges::find_if(file_formats, [&](const FileFormat& f) { return f.begins(bytes); });
  return at == file_formats.end() ? nullptr : at;
}

/// Refuses what begins like no format. What begins with a digit is meant as a text of Siconos, whose grammars refuse
/// it.
ReadProblem read_unknown(std::string_view bytes, const std::string& file) {
  const std::string expected = "a contact problem: " + problem_formats();
  WordReader words(bytes);
  std::string_view word = words.peek();
  if (!word.empty() && word[0] >= '0' && word[0] <= '9') return {read_siconos(bytes, file), {}};
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
  const FileFormat* format = format_of(bytes);
  return (format == nullptr ? plain_answer : format->read_answer)(bytes, file, sizes);
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

std::string problem_formats() {
  std::string text;
  for (const FileFormat& format : file_formats) text += (text.empty() ? "" : ", ") + std::string(format.name);
  return text;
}

ReadProblem read_problem_file(const std::string& path) {
  const std::string bytes = read_text_file(path, max_problem_file_size);
  const FileFormat* format = format_of(bytes);
  return checked(format == nullptr ? read_unknown(bytes, path) : format->read(bytes, path), path);
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
  if (begins_as_json(start)) return !is_json_lines(path) && is_problem_object(path);
  return format_of(start) != nullptr;
}

}  // namespace slipproof
