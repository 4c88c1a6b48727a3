// Inside the reading of claims files: what its parts share.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input/table_reader.hpp"
#include "claims/paper/claims_file.hpp"

namespace slipproof::claims_reader {

/// Which symbols an expression may use, beyond the parameters of its setting.
struct Allowed {
  bool definitions = false;
  bool force = false;
  bool quantities = false;
  bool unknowns = false;  ///< of the model's equations; the force too
};

/// An expression that was read, to be checked when all names are known.
struct Use {
  Expression expression;
  PlacedText text;
  std::string key;
  std::size_t setting = 0;
  Allowed allowed;
  std::string independent_of;  ///< a symbol that it must not depend on; empty: none
};

class Context {
 public:
  Context(ClaimsFile& claims_file, Mistakes& list) : file(claims_file), mistakes(list) {}

  /// The expression in a key's string; a mistake is reported, and `true` or 0 stands in for it.
  Expression expression(const TableReader& table, std::string_view key, Sort sort, std::size_t setting,
                        Allowed allowed);
  Expression expression(const PlacedText& text, std::string_view key, Sort sort, std::size_t setting, Allowed allowed);
  /// The text of a required key; a mistake is reported, and it is empty.
  std::string text(const TableReader& table, std::string_view key, std::string_view expected);
  std::string optional_text(const TableReader& table, std::string_view key);
  /// A line number of the source.
  std::size_t line(const TableReader& table, std::string_view key, bool required);
  void refuse(const PlacedText& text, std::size_t position, std::string_view key, const std::string& message) {
    mistakes.add(text.at(position), std::string(key) + ": " + message);
  }

  ClaimsFile& file;
  Mistakes& mistakes;
  std::vector<Use> uses;
  /// Those that were opened, by what names them.
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const Mechanism>> mechanisms;
};

void read_settings(const TableReader& root, Context& context);
/// Whether a setting names no mechanism: it is of the bicycle, and its force says whether it is external.
inline bool of_bicycle(const TableReader& setting) {
  return !setting.has("mechanism");
}
/// The mechanism of a setting with its states before the motion, before everything else of the setting; false if there
/// is none, which is reported.
bool read_mechanism(const TableReader& table, Context& context, Setting& setting);
/// What the mechanism's symbols are, after the paper's symbols.
void read_scene(const TableReader& table, Context& context, Setting& setting);
/// The references of claims, by their texts: ids are known only when all claims are read.
class OpenReferences {
 public:
  void add(const TableReader& table, std::size_t claim, Reading reading, const ClaimKind& kind);
  void add_part(std::size_t claim, const PlacedText& id) { parts_.emplace_back(claim, &id); }
  /// A repaired reading at this place that has nothing of its own.
  void add_only_expecting(std::size_t claim, Place place) { only_expecting_.emplace_back(claim, place); }

  /// Resolves them, and adds the readings that claims have because of others.
  void resolve(Context& context) const;

 private:
  struct Texts {
    std::size_t claim;
    Reading reading;
    std::string_view key;
    References ClaimBody::*list;
    std::vector<const PlacedText*> ids;
  };
  std::vector<Texts> texts_;
  std::vector<std::pair<std::size_t, Place>> only_expecting_;
  std::vector<std::pair<std::size_t, const PlacedText*>> parts_;
};

/// All keys that some kind of claim has, and those that say something of every kind.
std::vector<std::string_view> body_keys();
/// Refuses a table that lacks what claims of the kind have to have.
void require_body(const TableReader& table, const ClaimKind& kind);
/// Reads over what `body`, whose kind is known, already holds; but for references.
void read_body(const TableReader& table, Context& context, std::size_t setting, ClaimBody& body);
/// After the settings.
void read_claims(const TableReader& root, Context& context);
/// Symbols that do not exist or must not be used, definitions in circles or too large to evaluate.
void check_uses(Context& context);

/// `unknown NAME, did you mean ...`.
std::string unknown(std::string_view what, std::string_view found, const std::vector<std::string_view>& known);

}  // namespace slipproof::claims_reader
