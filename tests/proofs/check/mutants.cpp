// All shipped certificates are accepted, and of what a change makes of them only what is the same proof, or another one
// that a second reading confirms.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "proofs/check/examples.hpp"
#include "proofs/check/files.hpp"
#include "proofs/check/record.hpp"
#include "proofs/check/second_reading.hpp"
#include "support/how_many.hpp"
#include "support/run_program.hpp"

using namespace slipproof::check;

namespace {

/// A soak test takes all, as does the README's command that checks the folder, which the tests of pages run.
std::vector<std::filesystem::path> shipped() {
  const auto all = certificates_in(std::filesystem::path(SLIPPROOF_SOURCE_DIR) / "proofs");
  const auto every =
      slipproof::test::how_many("SLIPPROOF_CERTIFICATES_EVERY", slipproof::test::quick<std::size_t>(4, 16));
  std::vector<std::filesystem::path> some;
  for (std::size_t i = 0; i < all.size(); i += every) some.push_back(all[i]);
  return some;
}

std::string content(const std::filesystem::path& path) {
  static std::map<std::filesystem::path, TheoremFile> files;
  const auto [file, is_new] = files.try_emplace(path.parent_path());
  if (is_new) file->second = split_theorems(slipproof::test::read_file(file->first));
  const StatedTheorem& theorem = file->second.theorems.at(path.stem().string());
  return path.extension() == ".cert" ? theorem.certificate.text : theorem.statement.text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream input(text);
  for (std::string line; std::getline(input, line);) result.push_back(line);
  return result;
}

/// A polynomial that is written as a sum of products of numbers and powers, in an order; anything else as it stands.
std::string ordered_polynomial(const std::string& text) {
  std::map<std::map<std::string, unsigned long>, long long> terms;
  std::size_t at = 0;
  const auto is_word = [&](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
  const auto word = [&] {
    const std::size_t start = at;
    while (at < text.size() && is_word(text[at])) ++at;
    return text.substr(start, at - start);
  };
  while (at < text.size()) {
    long long coefficient = 1;
    if (text[at] == '+') ++at;
    for (; at < text.size() && text[at] == '-'; ++at) coefficient = -coefficient;
    std::map<std::string, unsigned long> powers;
    do {
      if (text[at] == '*') ++at;
      const std::string factor = word();
      if (factor.empty() || factor.size() > 17) return text;
      if (std::isdigit(static_cast<unsigned char>(factor.front()))) {
        if (factor.find_first_not_of("0123456789") != std::string::npos || factor.size() > 9) return text;
        if (__builtin_mul_overflow(coefficient, std::stoll(factor), &coefficient)) return text;
        continue;
      }
      unsigned long exponent = 1;
      if (at < text.size() && text[at] == '^') {
        ++at;
        const std::string digits = word();
        if (digits.empty() || digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos)
          return text;
        exponent = std::stoul(digits);
      }
      powers[factor] += exponent;
    } while (at < text.size() && text[at] == '*');
    if (at < text.size() && text[at] != '+' && text[at] != '-') return text;
    terms[powers] += coefficient;
  }
  std::string result;
  for (const auto& [powers, coefficient] : terms) {
    if (coefficient == 0) continue;
    result += "+" + std::to_string(coefficient);
    for (const auto& [name, exponent] : powers) result += "*" + name + "^" + std::to_string(exponent);
  }
  return result;
}

/// A line `RULE NAME: POLYNOMIAL ...` with its polynomial in order; others without blanks.
std::string ordered_line(std::string line) {
  line.erase(std::remove(line.begin(), line.end(), ' '), line.end());
  const std::size_t start = line.find(':') + 1, end = std::min(line.find_first_of("<>="), line.size());
  if (start == 0 || start > end) return line;
  return line.substr(0, start) + ordered_polynomial(line.substr(start, end - start)) + line.substr(end);
}

/// `term C H K^2 ...`: its factors in the order of their names, each once.
std::string ordered_term(std::istringstream& words, bool alone) {
  std::string coefficient;
  words >> coefficient;
  std::map<std::string, unsigned long> exponents;
  for (std::string factor; words >> factor;) {
    const std::size_t mark = factor.find('^');
    exponents[factor.substr(0, mark)] += mark == std::string::npos ? 1 : std::stoul(factor.substr(mark + 1));
  }
  std::string result = "term " + (alone ? "1" : coefficient);
  for (const auto& [name, exponent] : exponents) result += " " + name + "^" + std::to_string(exponent);
  return result;
}

/// The normal form of a certificate: certificates with the same are the same proof. It drops comments and blanks, the
/// order in polynomials, and in an identity, a sum of products, the order of terms and of factors; c p = 0 with c > 0
/// is p = 0 for it, too.
std::vector<std::string> normal_form(const std::string& text) {
  std::vector<std::string> result, identity;
  const auto finish = [&] {
    for (std::string& line : identity) {
      std::istringstream words(line);
      std::string first;
      words >> first;
      if (first == "term") line = ordered_term(words, identity.size() == 1);
    }
    std::sort(identity.begin(), identity.end());
    result.insert(result.end(), identity.begin(), identity.end());
    identity.clear();
  };
  for (std::string line : lines_of(text)) {
    std::istringstream words(line);
    std::string first;
    if (!(words >> first) || first.front() == '#') continue;
    if (first == "term" || first == "equation") {
      identity.push_back(first == "equation" ? ordered_line(line) : line);
      continue;
    }
    finish();
    result.push_back(ordered_line(line));
  }
  finish();
  return result;
}

}  // namespace

TEST_CASE("the normal form tells proofs apart, and only proofs") {
  CHECK(ordered_polynomial("0-2*x*y+-3*x^2+0*z") == ordered_polynomial("-3*x*x+-2*y*x"));
  for (const char* other :
       {"2*x*y", "-2*x*y", "-2*x*y-3*x", "-2*x*y-3*x^3", "-2*x*z-3*x^2", "-2*x*y+3*x^2", "x^", "(x)"}) {
    CHECK(ordered_polynomial(other) != ordered_polynomial("-2*x*y-3*x^2"));
  }
  const auto normal = normal_form(kSplitProof);
  CHECK(normal_form(replaced(kSplitProof, "term 3 d.1\nterm 3 s.2\n", "# a comment\nterm 3  s.2\nterm 3 d.1^1\n")) ==
        normal);
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"term 3 d.1", "term 2 d.1"},
                                                        {"term 1 r^2", "term 1 r"},
                                                        {"split r: x - y", "split r: y - x"},
                                                        {"have k: t - x = 0", "have k: t - x >= 0"},
                                                        {"equation k: 3", "equation k: -3"},
                                                        {"qed\n", ""},
                                                        {"branch 2", "branch 1"},
                                                        {"term 1 k\n", "term 1 k\nterm 1 k\n"}}) {
    CHECK(normal_form(replaced(kSplitProof, from, to)) != normal);
  }
}

namespace {

/// A statement that stays read while many certificates are held against it.
struct Read {
  explicit Read(const std::string& text) : reader(text), statement(reader) {}

  bool accepts(const std::string& certificate) const {
    FormulaReader certificate_reader(certificate);
    try {
      certificate_reader.expect_line("slipproof-certificate 1");
      Proof(statement, certificate_reader);
      return true;
    } catch (const Rejection&) {
      return false;
    }
  }

  FormulaReader reader;
  Statement statement;
};

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// One line deleted, doubled, exchanged or replaced by another, a character changed, or the end cut off.
std::string mutant_of(std::vector<std::string> lines, std::mt19937_64& random) {
  const std::string symbols = "0123456789+-*/^=<> .:abxyR#";
  const std::size_t at = random() % lines.size(), other = random() % lines.size();
  const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
  const std::string copy = lines[other];
  switch (random() % 6) {
    case 0:
      lines.erase(place);
      break;
    case 1:
      lines.insert(place, copy);
      break;
    case 2:
      std::swap(lines[at], lines[other]);
      break;
    case 3:
      lines[at] = copy;
      break;
    case 4:
      lines.resize(at);
      break;
    default:
      lines[at][random() % lines[at].size()] = symbols[random() % symbols.size()];
  }
  return joined(lines);
}

/// One token left out, or another of the text or a sign put in its place or before it.
std::string with_another_token(const std::string& text, std::mt19937_64& random) {
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == 0 || !is_word(text[i]) || !is_word(text[i - 1])) tokens.emplace_back();
    tokens.back() += text[i];
  }
  static const std::vector<std::string> signs = {"-", "/",  "^",  "^2",      "(",     ")",        "{",      "}",
                                                 "<", "!=", "<=", " and ",   " or ",  "false",    "/(x-x)", "0",
                                                 "1", "\n", "#",  "exists ", "real ", "let z = ", "show ",  "goal.1"};
  std::string& token = tokens[random() % tokens.size()];
  const std::string other = random() % 2 == 0 ? signs[random() % signs.size()] : tokens[random() % tokens.size()];
  const std::size_t kind = random() % 3;
  token = kind == 0 ? "" : kind == 1 ? other : other + token;
  std::string result;
  for (const std::string& part : tokens) result += part;
  return result;
}

std::size_t wanted_mutants() {
  return slipproof::test::how_many<std::size_t>("SLIPPROOF_CHECK_MUTANTS", 1'000);
}

}  // namespace

TEST_CASE("all shipped certificates are accepted") {
  const auto certificates = shipped();
  REQUIRE(certificates.size() > 40);
  Checker checker;
  for (const auto& certificate : certificates) {
    const FileResult result = checker.check(certificate);
    INFO(result.message);
    CHECK(result.verdict == Verdict::accepted);
  }
}

TEST_CASE("mutants of the shipped certificates are rejected, the same proof, or another one that is confirmed") {
  const std::size_t wanted = wanted_mutants();
  std::mt19937_64 random(20240607);
  const auto certificates = shipped();
  double weights = 0;  // long certificates take long: the number of mutants falls with the length
  for (const auto& path : certificates) weights += 1.0 / static_cast<double>(content(path).size());
  std::size_t mutants = 0, identical = 0, others = 0, confirmed = 0;
  for (auto path : certificates) {
    const std::string valid = content(path);
    const std::vector<std::string> lines = lines_of(valid);
    const std::string statement_text = content(path.replace_extension(".statement"));
    const Read statement(statement_text);
    const double share = static_cast<double>(wanted) / weights / static_cast<double>(valid.size());
    const auto count = std::max(wanted / 1'000, static_cast<std::size_t>(share) + 1);
    for (std::size_t i = 0; i < count; ++i, ++mutants) {
      const std::string mutant = mutant_of(lines, random);
      const bool accepted = statement.accepts(mutant);
      record(statement_text, mutant, accepted ? Verdict::accepted : Verdict::rejected);
      if (!accepted) continue;
      if (normal_form(mutant) == normal_form(valid)) {
        ++identical;
        continue;
      }
      ++others;
      const auto found = lines_of(mutant);
      const auto place = std::mismatch(lines.begin(), lines.end(), found.begin(), found.end());
      const auto line = [](auto at, const auto& all) { return at == all.end() ? std::string("(the end)") : *at; };
      const std::string change = path.string() + ":" + std::to_string(place.first - lines.begin() + 1) + ": " +
                                 line(place.first, lines) + " -> " + line(place.second, found);
      const std::string doubt = slipproof::test::unconfirmed(statement_text, mutant);
      INFO(change);
      CHECK(doubt == "");
      if (!doubt.empty()) continue;
      ++confirmed;
      MESSAGE("another proof, confirmed: " << change);
    }
  }
  MESSAGE(mutants << " mutants: " << mutants - identical - others << " rejected, " << identical << " the same proof, "
                  << confirmed << " another proof, confirmed, " << others - confirmed << " unconfirmed");
  CHECK(mutants >= wanted);
}

TEST_CASE("of mutants of the shipped statements, only what a second reading confirms is accepted") {
  std::mt19937_64 random(20261122);
  const auto certificates = shipped();
  const std::size_t wanted = wanted_mutants() / slipproof::test::quick(5, 10);
  std::size_t accepted = 0;
  for (std::size_t i = 0; i < wanted;) {
    std::filesystem::path path = certificates[random() % certificates.size()];
    const std::string certificate = content(path);
    if (certificate.size() > 20'000) continue;  // the long ones would take all the time
    ++i;
    const std::string statement = content(path.replace_extension(".statement"));
    std::vector<std::string> lines = lines_of(statement);
    std::erase_if(lines, [](const std::string& line) { return line.starts_with("#"); });  // the prover reads some
    std::string mutant = mutant_of(lines, random);
    if (i % 2 == 0) mutant = with_another_token(joined(lines), random);
    std::string own = certificate;  // with the mutant's fingerprint, where it has one
    try {
      own.replace(0, header(statement).size(), header(mutant));
    } catch (const Rejection&) {
      CHECK(verdict(mutant, certificate) != "");
      continue;
    }
    if (verdict(mutant, own) != "") continue;
    ++accepted;
    CAPTURE(path);
    CAPTURE(mutant);
    CHECK(slipproof::test::unconfirmed(mutant, own) == "");
  }
  MESSAGE(wanted << " mutants of statements, " << accepted << " proved");
  CHECK(accepted > 0);
}
