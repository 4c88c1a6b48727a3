// Implications in a setting, for all parameters, with proofs that the certificate checker accepts.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "claims/paper/setting_names.hpp"
#include "proofs/statement/limits.hpp"

namespace slipproof {

/// A statement (proofs/FORMAT.md) and the certificate that proves it.
struct Lemma {
  std::string statement;
  std::string certificate;
};
using Lemmas = std::vector<Lemma>;

/// Keeps proofs that were found, and searches that failed. May be used by several threads.
class LemmaBook {
 public:
  explicit LemmaBook(const prove::Limits& limits) : limits_(limits) {}
  /// The certificate of a statement; empty if none was found.
  std::string certificate(const std::string& statement);

 private:
  prove::Limits limits_;
  std::mutex mutex_;
  std::map<std::string, std::string> known_;
};

/// What the unknowns in an implication stand for if they are not a motion in a mode.
enum class Obeying : std::uint8_t {
  nothing,           ///< any numbers
  equations_on_road  ///< numbers that satisfy the equations of motion with both wheels on the road
};

/// Implications in one setting of a claims file, in one reading. Each function adds the lemmas that it proves to
/// `lemmas`.
class Implications {
 public:
  /// All arguments must outlive it.
  Implications(const ClaimsFile& file, std::size_t setting, LemmaBook& book)
      : file_(&file), setting_(setting), names_(file.settings[setting]), book_(&book) {}

  const SettingNames& names() const { return names_; }
  const ClaimBody& body(std::size_t claim) const { return file_->claims[claim].printed; }

  /// The same where the force is any number: true also of points at which no force is in the domain.
  Implications of_any_force() const {
    Implications result = *this;
    result.force_domain_ = false;
    return result;
  }
  /// See PlainSetting.
  bool has_interval_of_forces() const;
  bool is_linear(const Expression& equation) const;
  /// Whether a condition, or equation, has a value under `given`.
  bool has_value(const std::vector<Expression>& given, const Expression& truth, Lemmas& lemmas) const;

  /// Whether `given` implies `shown`: for any numbers, for all motions in a mode, or for unknowns that satisfy
  /// equations.
  bool implies(std::vector<Expression> given, const Expression& shown, Lemmas& lemmas,
               const std::optional<MechanismMode>& mode = std::nullopt, Obeying obeying = Obeying::nothing) const;
  /// Whether x and y are true in the same cases under `given`, and no divisor that only y has is ever 0 there.
  bool equivalent(const std::vector<Expression>& given, const Expression& x, const Expression& y, Lemmas& lemmas,
                  Obeying obeying = Obeying::nothing) const;
  /// Whether no divisor that only y has, up to what is `alike`, is 0 under `given` where the other conditions of y
  /// hold.
  using Alike = std::function<bool(const Expression&, const Expression&)>;
  bool divides_alike(const std::vector<Expression>& given, const Expression& x, const Expression& y, Lemmas& lemmas,
                     const Alike& alike = same) const;
  /// Whether under `given`, which must not depend on the parameter, `shown` is true for all sufficiently large values
  /// of the parameter: the leading coefficients of what is compared have the right signs. False if the parameter may
  /// not grow without bound.
  bool eventually(const Expression& given, const Expression& shown, std::string_view parameter, Lemmas& lemmas) const;
  /// Whether the claim with this body is a theorem: the statements that together express it are all proved.
  bool proves(std::size_t claim, const ClaimBody& body, Lemmas& lemmas) const;

 private:
  std::vector<Expression> divisors(const Expression& e) const;
  bool prove(const std::string& statement, Lemmas& lemmas) const;
  bool prove(const std::vector<Expression>& given, const Expression& shown, Lemmas& lemmas,
             const std::optional<MechanismMode>& mode, Obeying obeying) const;

  const ClaimsFile* file_;
  std::size_t setting_;
  SettingNames names_;
  LemmaBook* book_;
  bool force_domain_ = true;  ///< the force is in its domain
};

}  // namespace slipproof
