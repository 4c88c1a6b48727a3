// What follows from what in a setting, for all parameters, with proofs that the certificate checker accepts.
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

/// Proofs that were found or sought in vain, for any number of threads.
class LemmaBook {
 public:
  explicit LemmaBook(const prove::Limits& limits) : limits_(limits) {}
  /// The certificate of a statement; empty: none was found.
  std::string certificate(const std::string& statement);

 private:
  prove::Limits limits_;
  std::mutex mutex_;
  std::map<std::string, std::string> known_;
};

/// What the unknowns of an implication are, where they are no motion in a mode.
enum class Obeying : std::uint8_t {
  nothing,           ///< any numbers
  equations_on_road  ///< numbers that obey the equations of motion with both wheels on the road
};

/// Implications in one setting of a claims file with one reading. Each of them adds what it proves to `lemmas`.
class Implications {
 public:
  /// What is given must outlive it.
  Implications(const ClaimsFile& file, std::size_t setting, LemmaBook& book)
      : file_(&file), setting_(setting), names_(file.settings[setting]), book_(&book) {}

  const SettingNames& names() const { return names_; }

  /// `given` implies `shown`: of any numbers, of all motions in a mode, or of unknowns that obey equations.
  bool implies(std::vector<Expression> given, const Expression& shown, Lemmas& lemmas,
               const std::optional<MechanismMode>& mode = std::nullopt, Obeying obeying = Obeying::nothing) const;
  /// x and y are true of the same under `given`, and what only y divides by is never 0 there.
  bool equivalent(const std::vector<Expression>& given, const Expression& x, const Expression& y, Lemmas& lemmas,
                  Obeying obeying = Obeying::nothing) const;
  /// What only y divides by, up to what is `alike`, is not 0 under `given` wherever the other conditions of y hold.
  using Alike = std::function<bool(const Expression&, const Expression&)>;
  bool divides_alike(const std::vector<Expression>& given, const Expression& x, const Expression& y, Lemmas& lemmas,
                     const Alike& alike = same) const;
  /// Under `given`, which must not depend on the parameter, `shown` is true from some value of the parameter on: what
  /// is compared has leading coefficients of the right sign.
  bool eventually(const Expression& given, const Expression& shown, std::string_view parameter, Lemmas& lemmas) const;
  /// The claim with this body is a theorem: all statements are proved that together say what it says.
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
};

}  // namespace slipproof
