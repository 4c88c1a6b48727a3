// All solutions of a contact problem, with the proof that there are no others (MATHEMATICS.md, "All solutions").
#pragma once

#include <functional>

#include "base/number/effort.hpp"
#include "contact/complete/motion/frictionless.hpp"

namespace slipproof {

/// A node of the tree of patterns: what closes it, or what it is split into.
struct PatternNode {
  enum class End : std::uint8_t {
    undecided,     ///< nothing: motions may be left in it
    empty,         ///< multipliers prove that it has no motion
    motion,        ///< all of its motions are one that is known, or near it
    frictionless,  ///< it has no motion but one that needs no friction (frictionless.hpp)
    split
  };
  /// Multipliers that prove a lower bound of a form.
  struct Bound {
    ContactForm form;
    std::vector<Rational> y;
  };
  ContactPattern pattern;
  End end = End::undecided;
  std::vector<Rational> y;      ///< empty
  std::size_t motion = 0;       ///< motion, frictionless: which
  std::vector<Bound> bounds;    ///< motion
  std::size_t contact = 0;      ///< split: of which contact
  std::size_t first_child = 0;  ///< split: children stand side by side
  std::size_t children = 0;
};

/// How far a search is.
struct SearchState {
  std::size_t patterns = 0;  ///< of the tree
  std::size_t open = 0;      ///< that wait to be looked at
  std::size_t motions = 0;   ///< found
};
using SearchProgress = std::function<void(const SearchState&)>;

struct CompleteOptions {
  Work effort = 20'000'000'000;  ///< about 20 seconds
  std::size_t most_nodes = 200'000;
  SearchProgress progress = {};  ///< called from one thread, each time that a generation of patterns begins
};

/// In the units of `scaled`.
struct CompleteSolutions {
  ScaledContacts scaled;
  std::vector<SpatialMotion> motions;
  /// By motion, and row of u: others that count as this one are at most so far from where it is. Empty: there are none.
  std::vector<std::vector<Rational>> within;
  std::vector<PatternNode> nodes;       ///< the tree, its root first
  std::vector<WeightedSquare> squares;  ///< r . W r as their sum, if a node is frictionless
  std::size_t programs = 0;             ///< linear programs

  /// Whether no node is undecided: all motions are known.
  bool complete() const;
  std::size_t undecided() const;
};

/// Splits patterns until each is proved empty, or to hold one known motion only; or motions near it: within 2^-20 of
/// the largest velocity, or, where forces are open and move the body differently, wherever they are. The same on any
/// number of threads.
CompleteSolutions all_solutions(const ExactContacts& contacts, const CompleteOptions& options = {});

}  // namespace slipproof
