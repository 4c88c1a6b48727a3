// Internal to the reading of claims files: declarations that its parts share, and what kinds need for keys of their
// own.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input/table_reader.hpp"
#include "claims/paper/claims_file.hpp"

namespace slipproof::claims_reader {

/// The symbols that an expression may use in addition to the parameters of its setting.
struct Allowed {
  bool definitions = false;
  bool force = false;
  bool quantities = false;
  bool unknowns = false;  ///< the unknowns of the model's equations, and the force
};

/// An expression that was read; it is checked when all names are known.
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

  /// The expression in the string of a key. A mistake is reported, and `true` or 0 takes its place.
  Expression expression(const TableReader& table, std::string_view key, Sort sort, std::size_t setting,
                        Allowed allowed);
  Expression expression(const PlacedText& text, std::string_view key, Sort sort, std::size_t setting, Allowed allowed);
  /// The text of a required key. A mistake is reported, and the text is then empty.
  std::string text(const TableReader& table, std::string_view key, std::string_view expected);
  std::string optional_text(const TableReader& table, std::string_view key);
  /// A line number of the source.
  std::size_t line(const TableReader& table, std::string_view key, bool required);
  /// Whose claim it is; `otherwise` if the table does not say.
  Origin origin(const TableReader& table, Origin otherwise);
  void refuse(const PlacedText& text, std::size_t position, std::string_view key, const std::string& message) {
    mistakes.add(text.at(position), std::string(key) + ": " + message);
  }

  ClaimsFile& file;
  Mistakes& mistakes;
  std::vector<Use> uses;
  /// The mechanisms that were opened, by the texts that name them, their line and the law of impact.
  std::map<std::array<std::string, 3>, std::shared_ptr<const Mechanism>> mechanisms;
};

/// The keys of a claim in one reading, and the body of known kind that they are read into.
struct BodyTable {
  const TableReader& table;
  Context& context;
  std::size_t setting;
  ClaimBody& body;

  /// Null if there is none of this index.
  const Setting* in_setting() const {
    return setting < context.file.settings.size() ? &context.file.settings[setting] : nullptr;
  }
  Expression read(std::string_view key, Sort sort, Allowed allowed) const {
    return context.expression(table, key, sort, setting, allowed);
  }
};

void read_settings(const TableReader& root, Context& context);
/// Whether a setting names no mechanism: it then describes the bicycle, and its force says whether it is external.
inline bool of_bicycle(const TableReader& setting) {
  return !setting.has("mechanism");
}
/// Reads the mechanism of a setting and its states before the motion; must come before the rest of the setting. If
/// there is no mechanism, reports that and returns false.
bool read_mechanism(const TableReader& table, Context& context, Setting& setting);
/// Reads the values of the mechanism's symbols; must come after the paper's symbols.
void read_scene(const TableReader& table, Context& context, Setting& setting);
/// References between claims, as texts: their ids are known only when all claims are read.
class OpenReferences {
 public:
  void add(const TableReader& table, std::size_t claim, Reading reading, const ClaimKind& kind);
  void add_part(std::size_t claim, const PlacedText& id) { parts_.emplace_back(claim, &id); }
  /// Adds a repaired reading at this place that changes nothing but the expected verdict.
  void add_only_expecting(std::size_t claim, Place place) { only_expecting_.emplace_back(claim, place); }

  /// Resolves the references, and adds the readings that claims have because of other claims.
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

/// All keys that some kind of claim has, and those that apply to every kind.
std::vector<std::string_view> body_keys();
/// Reports the required keys of the kind that a table lacks.
void require_body(const TableReader& table, const ClaimKind& kind);
/// Reads the keys of a table over the present values of its body; does not read references.
void read_body(const BodyTable& table);
/// Must come after the settings.
void read_claims(const TableReader& root, Context& context);
/// Reports symbols that do not exist or must not be used, and definitions that are circular or too large to evaluate.
void check_uses(Context& context);

/// `unknown NAME, did you mean ...`.
std::string unknown(std::string_view what, std::string_view found, const std::vector<std::string_view>& known);

}  // namespace slipproof::claims_reader
