#include "base/input/table_reader.hpp"

#include <algorithm>
#include <utility>

#include "base/input/near_match.hpp"
#include "base/number/parse.hpp"

namespace slipproof {

std::optional<Rational> read_number(const TomlValue& value, std::string_view name, Mistakes& mistakes) {
  const std::string prefix = std::string(name) + ": ";
  if (value.kind != TomlValue::Kind::number && value.kind != TomlValue::Kind::string) {
    mistakes.add(value.place, prefix + "found " + std::string(kind_name(value.kind)) + ", expected a number");
    return std::nullopt;
  }
  std::string text = value.text.text();
  if (value.kind == TomlValue::Kind::number) std::erase(text, '_');  // TOML's own separators
  try {
    return parse_rational(text);
  } catch (const NumberError& error) {
    mistakes.add(value.text.at(error.position()), prefix + error.what());
    return std::nullopt;
  }
}

TableReader::TableReader(const TomlValue& table, std::string name, std::span<const std::string_view> keys,
                         Mistakes& mistakes)
    : table_(table), name_(std::move(name)), mistakes_(mistakes) {
  for (const TomlEntry& entry : table.entries) {
    if (std::ranges::find(keys, entry.key) != keys.end()) continue;
    std::string message = "unknown key " + in_quotes(entry.key);
    if (!name_.empty()) message += " in " + name_;
    if (const auto meant = near_match(entry.key, keys)) {
      message += ", did you mean '" + std::string(*meant) + "'?";
    } else if (keys.empty()) {
      message += ", expected none";
    } else {
      message += ", expected one of";
      for (const std::string_view key : keys) message += (key == keys.front() ? " " : ", ") + std::string(key);
    }
    mistakes_.add(entry.place, std::move(message));
  }
}

bool TableReader::require(std::string_view key, std::string_view expected) const {
  if (has(key)) return true;
  mistakes_.add(table_.place, "missing " + std::string(key) + (name_.empty() ? "" : " in " + name_) + ", expected " +
                                  std::string(expected));
  return false;
}

const TomlValue* TableReader::value(std::string_view key) const {
  const TomlEntry* entry = table_.find(key);
  return entry == nullptr ? nullptr : &entry->value;
}

std::optional<Rational> TableReader::number(std::string_view key) const {
  const TomlValue* found = value(key);
  return found == nullptr ? std::nullopt : read_number(*found, key, mistakes_);
}

const TomlValue* TableReader::of_kind(std::string_view key, TomlValue::Kind kind) const {
  const TomlValue* found = value(key);
  if (found == nullptr || found->kind == kind) return found;
  refuse(key, "found " + std::string(kind_name(found->kind)) + ", expected " + std::string(kind_name(kind)));
  return nullptr;
}

const PlacedText* TableReader::string(std::string_view key) const {
  const TomlValue* found = of_kind(key, TomlValue::Kind::string);
  return found == nullptr ? nullptr : &found->text;
}

std::optional<bool> TableReader::boolean(std::string_view key) const {
  const TomlValue* found = of_kind(key, TomlValue::Kind::boolean);
  return found == nullptr ? std::nullopt : std::optional(found->text.text() == "true");
}

const TomlValue* TableReader::table(std::string_view key) const {
  return of_kind(key, TomlValue::Kind::table);
}

std::vector<const TomlValue*> TableReader::items(std::string_view key, TomlValue::Kind kind) const {
  std::vector<const TomlValue*> result;
  const TomlValue* array = of_kind(key, TomlValue::Kind::array);
  if (array == nullptr) return result;
  for (const TomlValue& item : array->items) {
    if (item.kind == kind) {
      result.push_back(&item);
    } else {
      mistakes_.add(item.place, std::string(key) + ": found " + std::string(kind_name(item.kind)) + ", expected " +
                                    std::string(kind_name(kind)));
    }
  }
  return result;
}

std::vector<const PlacedText*> TableReader::strings(std::string_view key) const {
  std::vector<const PlacedText*> result;
  for (const TomlValue* item : items(key, TomlValue::Kind::string)) result.push_back(&item->text);
  return result;
}

std::vector<const TomlValue*> TableReader::tables(std::string_view key) const {
  return items(key, TomlValue::Kind::table);
}

Place TableReader::place(std::string_view key) const {
  const TomlValue* found = value(key);
  return found == nullptr ? table_.place : found->place;
}

void TableReader::refuse(std::string_view key, const std::string& message) const {
  mistakes_.add(place(key), std::string(key) + ": " + message);
}

}  // namespace slipproof
