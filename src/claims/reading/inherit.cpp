#include "claims/reading/inherit.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "claims/reading/claims_reader.hpp"

namespace slipproof::claims_reader {

namespace {

using Kind = TomlValue::Kind;

constexpr std::array<std::string_view, 4> own_keys{"id", "statement", "line", "inherits"};

const PlacedText* text_of(const TomlValue& table, std::string_view key) {
  const TomlEntry* entry = table.find(key);
  return entry != nullptr && entry->value.kind == Kind::string ? &entry->value.text : nullptr;
}

TomlEntry* entry_of(TomlValue& table, std::string_view key) {
  const auto found = std::find_if(table.entries.begin(), table.entries.end(),
                                  [&](const TomlEntry& entry) { return entry.key == key; });
  return found == table.entries.end() ? nullptr : &*found;
}

/// Merges definitions by their symbols; other arrays are replaced.
TomlValue merged_definitions(const TomlValue& inherited, const TomlValue& own) {
  TomlValue result = inherited;
  result.place = own.place;
  for (const TomlValue& definition : own.items) {
    const PlacedText* symbol = text_of(definition, "symbol");
    const auto same = std::find_if(result.items.begin(), result.items.end(), [&](const TomlValue& other) {
      const PlacedText* name = text_of(other, "symbol");
      return symbol != nullptr && name != nullptr && name->text() == symbol->text();
    });
    // replaces only an inherited definition: if the setting itself defines a symbol twice, that stays a mistake
    const bool replaces = same - result.items.begin() < static_cast<std::ptrdiff_t>(inherited.items.size());
    if (same != result.items.end() && replaces) {
      *same = definition;
    } else {
      result.items.push_back(definition);
    }
  }
  return result;
}

/// Puts keys of the setting itself after those that it inherits.
TomlValue merged_table(const TomlValue& inherited, const TomlValue& own) {
  TomlValue result = own;
  result.entries = inherited.entries;
  std::erase_if(result.entries, [&](const TomlEntry& entry) { return own.find(entry.key) != nullptr; });
  result.entries.insert(result.entries.end(), own.entries.begin(), own.entries.end());
  return result;
}

TomlValue merged(const TomlValue& inherited, const TomlValue& own) {
  TomlValue result = own;
  for (const TomlEntry& entry : inherited.entries) {
    if (std::find(own_keys.begin(), own_keys.end(), entry.key) != own_keys.end()) continue;
    TomlEntry* same = entry_of(result, entry.key);
    if (same == nullptr) {
      result.entries.push_back(entry);
    } else if (same->value.kind == Kind::table && entry.value.kind == Kind::table) {
      same->value = merged_table(entry.value, same->value);
    } else if (entry.key == "definition" && same->value.kind == Kind::array && entry.value.kind == Kind::array) {
      same->value = merged_definitions(entry.value, same->value);
    }
  }
  return result;
}

class Inheritance {
 public:
  Inheritance(const std::vector<const TomlValue*>& settings, Mistakes& mistakes)
      : settings_(settings), mistakes_(mistakes) {}

  std::vector<TomlValue> written_out() {
    for (std::size_t i = 0; i < settings_.size(); ++i) {
      const std::size_t parent = parent_of(i);
      done_.push_back(parent < i ? merged(done_[parent], *settings_[i]) : *settings_[i]);
    }
    return std::move(done_);
  }

 private:
  std::size_t find(std::string_view id) const {
    const auto has_id = [&](const TomlValue* setting) {
      const PlacedText* own = text_of(*setting, "id");
      return own != nullptr && own->text() == id;
    };
    return static_cast<std::size_t>(std::find_if(settings_.begin(), settings_.end(), has_id) - settings_.begin());
  }

  /// The ids on the way from a setting back to itself; empty if there is no such way.
  std::string circle(std::size_t from) const {
    std::string way;
    std::size_t at = from;
    for (std::size_t steps = 0; steps <= settings_.size() && at < settings_.size(); ++steps) {
      const PlacedText* id = text_of(*settings_[at], "id");
      const PlacedText* inherits = text_of(*settings_[at], "inherits");
      if (id == nullptr || inherits == nullptr) return {};
      way += in_quotes(id->text()) + " inherits ";
      at = find(inherits->text());
      if (at == from) return way + in_quotes(inherits->text());
    }
    return {};
  }

  /// The index of the setting that setting i inherits from; i or more if there is none.
  std::size_t parent_of(std::size_t i) {
    const PlacedText* inherits = text_of(*settings_[i], "inherits");
    if (inherits == nullptr) return i;
    const std::size_t parent = find(inherits->text());
    if (parent < i) return parent;
    const auto refuse = [&](const std::string& message) {
      mistakes_.add(inherits->at(0), "inherits: " + message);
      return i;
    };
    if (parent == settings_.size()) return refuse(unknown("setting", inherits->text(), ids()));
    if (const std::string way = circle(i); !way.empty()) return refuse("found a circle: " + way);
    return refuse("found " + in_quotes(inherits->text()) + ", which stands later, expected a setting before this one");
  }

  std::vector<std::string_view> ids() const {
    std::vector<std::string_view> result;
    for (const TomlValue* setting : settings_) {
      if (const PlacedText* id = text_of(*setting, "id")) result.push_back(id->text());
    }
    return result;
  }

  const std::vector<const TomlValue*>& settings_;
  Mistakes& mistakes_;
  std::vector<TomlValue> done_;
};

}  // namespace

std::vector<TomlValue> written_out(const std::vector<const TomlValue*>& settings, Mistakes& mistakes) {
  return Inheritance(settings, mistakes).written_out();
}

}  // namespace slipproof::claims_reader
