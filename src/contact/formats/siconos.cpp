#include "contact/formats/siconos.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/files/words.hpp"
#include "contact/formats/siconos_matrix.hpp"

namespace slipproof {

namespace {

/// One grammar's reading of a text.
struct SiconosReading {
  ProblemFile problem;
  bool ends_with_data = true;
};

class SiconosText {
 public:
  explicit SiconosText(std::string_view text) : words_(text) {}

  SiconosReading read(ProblemForm form) {
    reading_.problem.form = form;
    form == ProblemForm::complementarity ? read_complementarity() : read_friction();
    read_rest();
    return std::move(reading_);
  }

  /// Whether it is a problem with rolling friction: in space five components a contact, and two coefficients.
  bool is_rolling(ProblemForm form) {
    reading_.problem.form = form;
    if (words_.peek() != "3" && words_.peek() != "5") return false;
    try {
      reading_.problem.dimension = words_.next() == "3" ? 3 : 5;
      read_contacts(2);
      return words_.rest().empty();
    } catch (const FormatStop&) {
      return false;
    }
  }

  /// Where it stopped, which a message may look back from.
  std::size_t reached() { return words_.position(); }

 private:
  void read_complementarity() {
    ProblemFile& p = reading_.problem;
    p.dimension = 1;
    const std::size_t size = words_.count("the size of the problem");
    p.W = matrix("W", MatrixSize{size, size});
    p.q = vector("q", size);
  }

  void read_friction() {
    ProblemFile& p = reading_.problem;
    if (words_.peek() != "2" && words_.peek() != "3") words_.stop("the dimension: 2 or 3");
    p.dimension = words_.next() == "2" ? 2 : 3;
    read_contacts(1);
  }

  /// All that follows the dimension, with so many coefficients a contact.
  void read_contacts(std::size_t coefficients) {
    ProblemFile& p = reading_.problem;
    const std::size_t contacts = words_.count("the number of contacts"), components = contacts * p.dimension;
    if (p.form == ProblemForm::local) {
      p.W = matrix("W", MatrixSize{components, components});
      p.q = vector("q", components);
    } else {
      p.M = matrix("M", std::nullopt);
      p.H = matrix("H", MatrixSize{p.M.rows, components});
      p.f = vector("f", p.M.rows);
      p.w = vector("w", components);
    }
    for (std::size_t k = 0; k < coefficients * contacts; ++k) {
      if (words_.peek().starts_with('-')) words_.stop("a coefficient of friction, which is not negative");
      p.mu.push_back(words_.finite_number("a coefficient of friction"));
    }
  }

  SparseMatrix matrix(const std::string& name, const std::optional<MatrixSize>& size) {
    return read_siconos_matrix(words_, name, size, reading_.problem.remarks);
  }

  std::vector<double> vector(const std::string& name, std::size_t size) {
    const std::string expected = "one of the " + std::to_string(size) + " components of " + name;
    std::vector<double> result;
    for (std::size_t i = 0; i < size; ++i) result.push_back(words_.finite_number(expected));
    return result;
  }

  /// Siconos reads no further. Some files end with a flag of older versions, some with words about the problem.
  void read_rest() {
    const std::string_view rest = words_.rest();
    if (rest.empty()) return;
    reading_.ends_with_data = false;
    const std::size_t start = words_.position();
    if (read_binary64(words_.peek())) {
      const std::string_view flag = words_.next();
      if (flag.find_first_not_of("0123456789") != std::string_view::npos || !words_.peek().empty()) {
        throw FormatStop{start, "found more numbers, expected the end of the file"};
      }
    }
    const std::string_view line = rest.substr(0, rest.find_first_of("\r\n"));
    reading_.problem.remarks.push_back("after the data there is " + in_quotes(line) + ", which is not read");
  }

  WordReader words_;
  SiconosReading reading_;
};

constexpr std::array<std::pair<ProblemForm, const char*>, 3> siconos_forms{{
    {ProblemForm::local, "a local friction problem"},
    {ProblemForm::global, "a global friction problem"},
    {ProblemForm::complementarity, "a complementarity problem"},
}};

}  // namespace

ProblemFile read_siconos(std::string_view text, const std::string& file) {
  struct Fit {
    SiconosReading reading;
    std::string name;
  };
  std::vector<Fit> fits;
  FormatStop farthest;
  std::size_t reached = 0;
  for (const auto& [form, name] : siconos_forms) {
    SiconosText grammar(text);
    try {
      fits.push_back({grammar.read(form), name});
    } catch (const FormatStop& stop) {
      if (!farthest.message.empty() && grammar.reached() <= reached) continue;
      reached = grammar.reached();
      farthest = {stop.position, "read as " + std::string(name) + ": " + stop.message};
    }
  }
  if (fits.empty()) {
    for (const ProblemForm form : {ProblemForm::local, ProblemForm::global}) {
      if (SiconosText(text).is_rolling(form)) {
        refuse(file,
               "found rolling friction: five components a contact, or three in the plane, and two coefficients, "
               "expected forces alone: rolling friction is not judged");
      }
    }
    refuse(file, text, farthest);
  }
  // If one grammar reads a file to its end, others may read a part and call the rest a comment.
  const auto whole = [](const Fit& fit) { return fit.reading.ends_with_data; };
  if (std::any_of(fits.begin(), fits.end(), whole)) std::erase_if(fits, [&](const Fit& fit) { return !whole(fit); });
  if (fits.size() > 1) {
    refuse(file, "found a text that is " + fits[0].name + " as well as " + fits[1].name + ", expected one of them");
  }
  return std::move(fits[0].reading.problem);
}

bool begins_as_siconos(std::string_view text) {
  const std::string_view word = WordReader(text).peek();
  return word.find_first_of("0123456789") < 2 && read_binary64(word).has_value();
}

}  // namespace slipproof
