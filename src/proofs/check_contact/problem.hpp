// The problem and the answer of a certificate (FORMAT.md, "The problem").
#pragma once

#include "proofs/check_contact/hash.hpp"
#include "proofs/check_contact/reader.hpp"

namespace slipproof::check_contact {

inline void require(bool condition, const char* otherwise) {
  if (!condition) throw Rejected(otherwise);
}

/// `contact 3: OTHERWISE`.
inline void require(bool condition, const char* what, std::size_t index, const char* otherwise) {
  if (!condition) throw Rejected(what + (" " + std::to_string(index)) + ": " + otherwise);
}

inline Number dot(const Row& row, const Vector& x) {
  Number sum;
  for (const auto& [j, a] : row) sum += a * x[j];
  return sum;
}

/// w = A x + c.
struct Problem {
  std::size_t dimension, free;
  Vector mu;
  Matrix A;
  Vector c;
  std::optional<Vector> answer;
  std::optional<std::string> named;  ///< which problem the file says that this is

  explicit Problem(Reader& reader) {
    reader.expect("slipproof-contact");
    reader.expect("1");
    if (reader.accept("problem")) named = reader.name();
    reader.expect("dimension");
    dimension = reader.accept("1") ? 1 : reader.accept("2") ? 2 : 3;
    if (dimension == 3) reader.expect("3");
    reader.expect("free");
    free = reader.count();
    reader.expect("contacts");
    mu = reader.numbers("mu", reader.count());
    reader.announce(size());
    A = reader.entries("matrix", size(), size());
    c = reader.numbers("constant", size());
    if (!reader.accept("no-answer")) answer = reader.numbers("answer", size());
  }

  std::size_t contacts() const { return mu.size(); }
  std::size_t size() const { return free + dimension * contacts(); }
  std::size_t normal(std::size_t k) const { return free + dimension * k; }
  Number entry(std::size_t i, std::size_t j) const {
    const auto found = A[i].find(j);
    return found == A[i].end() ? Number() : found->second;
  }
  Number motion(std::size_t i, const Vector& x) const { return dot(A[i], x) + c[i]; }

  const Vector& the_answer() const {
    require(answer.has_value(), "the claim speaks of the answer, and there is no-answer");
    return *answer;
  }

  void check_mu() const {
    for (std::size_t k = 0; k < contacts(); ++k) {
      require(mu[k].sign() >= 0, "contact", k, "mu is negative");
      require(dimension > 1 || mu[k].sign() == 0, "contact", k, "mu is not 0 in dimension 1");
    }
  }

  /// SHA-256 of its canonical form (FORMAT.md, "The name of a problem").
  std::string name() const {
    Sha256 hash;
    const auto add = [&](const char* word, const Vector& numbers) {
      hash.add(word);
      for (const Number& x : numbers) hash.add(" " + canonical(x));
      hash.add("\n");
    };
    hash.add("slipproof-contact-problem 1\ndimension " + std::to_string(dimension) + " free " + std::to_string(free) +
             " contacts " + std::to_string(contacts()) + "\n");
    add("mu", mu);
    add("matrix", {});
    for (std::size_t i = 0; i < size(); ++i) {
      for (const auto& [j, a] : A[i]) {
        if (a.sign() != 0) hash.add(std::to_string(i) + " " + std::to_string(j) + " " + canonical(a) + "\n");
      }
    }
    add("constant", c);
    return hash.hexadecimal();
  }

  /// That it is the one it says, and the one that was asked about, if one was. Returns which it is, in words.
  std::string check_name(std::string_view asked) const {
    const std::string own = name();
    if (named && *named != own) throw Rejected("it names the problem " + *named + ", and has the numbers of " + own);
    if (!asked.empty() && asked != own) throw Rejected("it is about another problem, " + own);
    return (named ? "of the problem " : "names no problem, has the numbers of ") + own;
  }

  std::string in_words() const {
    return std::to_string(contacts()) + " contacts in dimension " + std::to_string(dimension) +
           (free > 0 ? " and " + std::to_string(free) + " free unknowns" : "");
  }
};

}  // namespace slipproof::check_contact
