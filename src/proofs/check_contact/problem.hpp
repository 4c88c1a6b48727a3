// The problem and the answer of a certificate (FORMAT.md, "The problem").
#pragma once

#include <array>

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

/// The relation between the force and the velocity of a contact (FORMAT.md, "Laws").
struct Law {
  enum class Kind { coulomb, box, diamond, fixed, associated, linear, soft };
  Kind kind = Kind::coulomb;
  Vector bounds;      ///< fixed: of the tangential components
  Number slip_speed;  ///< linear and soft

  bool is(Kind which) const { return kind == which; }
  bool is_regularised() const { return is(Kind::linear) || is(Kind::soft); }
};

/// w = A x + c.
struct Problem {
  std::size_t dimension = 3, free = 0;
  Vector mu;
  Matrix A;
  Vector c;
  Law law;
  std::optional<Vector> answer;
  std::optional<std::string> named;  ///< the name of the problem that the file states

  Problem() = default;
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
    A = reader.accept("mirrored") ? mirrored(reader, size()) : reader.entries("matrix", size(), size());
    c = reader.numbers("constant", size());
    if (reader.accept("law")) read_law(reader);
    if (!reader.accept("no-answer")) answer = reader.numbers("answer", size());
  }

  /// Row by row the entries up to the diagonal; those above it are their mirror images, of which those with one of row
  /// and column below `turned` have the other sign.
  static Matrix mirrored(Reader& reader, std::size_t size) {
    Matrix A(size);
    const std::size_t turned = reader.index(size + 1);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t left = reader.count(); left > 0; --left) reader.entry(A[i], i + 1);
      for (auto entry = A[i].begin(); entry != A[i].end() && entry->first < i; ++entry) {
        A[entry->first].emplace(i, entry->first < turned && i >= turned ? -entry->second : entry->second);
      }
    }
    return A;
  }

  void read_law(Reader& reader) {
    law.kind = read_kind(reader);
    if (law.is(Law::Kind::fixed)) law.bounds = reader.numbers((dimension - 1) * contacts());
    if (law.is_regularised()) law.slip_speed = reader.number();
  }
  static Law::Kind read_kind(Reader& reader) {
    if (reader.accept("box")) return Law::Kind::box;
    if (reader.accept("diamond")) return Law::Kind::diamond;
    if (reader.accept("fixed")) return Law::Kind::fixed;
    if (reader.accept("associated")) return Law::Kind::associated;
    if (!reader.accept("regularised")) reader.refuse("'box', 'diamond', 'fixed', 'associated' or 'regularised'");
    if (reader.accept("linear")) return Law::Kind::linear;
    reader.expect("soft");
    return Law::Kind::soft;
  }

  std::size_t contacts() const { return mu.size(); }
  std::size_t size() const { return free + dimension * contacts(); }
  std::size_t normal(std::size_t k) const { return free + dimension * k; }
  bool has_friction(std::size_t k) const { return dimension > 1 && mu[k].sign() != 0; }
  Number entry(std::size_t i, std::size_t j) const {
    const auto found = A[i].find(j);
    return found == A[i].end() ? Number() : found->second;
  }
  Number motion(std::size_t i, const Vector& x) const { return dot(A[i], x) + c[i]; }

  const Vector& the_answer() const {
    require(answer.has_value(), "the claim speaks of the answer, and there is no-answer");
    return *answer;
  }

  /// For claims that speak of Coulomb's law alone.
  void require_coulomb() const { require(law.is(Law::Kind::coulomb), "the claim is not one of this law"); }

  void check_law_numbers() const {
    for (const Number& bound : law.bounds) require(bound.sign() >= 0, "a bound is negative");
    require(!law.is_regularised() || law.slip_speed.sign() > 0, "the slip speed is not positive");
    require(dimension > 1 || law.is(Law::Kind::coulomb), "without friction there is no law of it");
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
    if (!law.is(Law::Kind::coulomb)) {
      constexpr std::array<const char*, 7> words{
          "", "box", "diamond", "fixed", "associated", "regularised linear", "regularised soft"};
      add(("law " + std::string(words[static_cast<std::size_t>(law.kind)])).c_str(),
          law.is_regularised() ? Vector{law.slip_speed} : law.bounds);
    }
    return hash.hexadecimal();
  }

  /// Checks that the problem has the name that the file states, if any, and `required_name`, if not empty. Returns the
  /// name in words.
  std::string check_name(std::string_view required_name) const {
    const std::string own = name();
    if (named && *named != own) throw Rejected("it names the problem " + *named + ", and has the numbers of " + own);
    if (!required_name.empty() && required_name != own) throw Rejected("it is about another problem, " + own);
    return (named ? "of the problem " : "names no problem, has the numbers of ") + own;
  }

  std::string in_words() const {
    constexpr std::array<const char*, 7> laws{"",
                                              ", by the box pyramid",
                                              ", by the diamond pyramid",
                                              ", by fixed bounds",
                                              ", by the associated law",
                                              ", by the linear regularised law",
                                              ", by the soft regularised law"};
    return std::to_string(contacts()) + " contacts in dimension " + std::to_string(dimension) +
           (free > 0 ? " and " + std::to_string(free) + " free unknowns" : "") +
           laws[static_cast<std::size_t>(law.kind)];
  }
};

}  // namespace slipproof::check_contact
