#include "mechanics/search/search_bytes.hpp"

namespace slipproof {

namespace {

/// Enumerations and flags, each a number.
template <class Item>
void write_numbers(ByteWriter& bytes, const std::vector<Item>& items) {
  bytes.number(items.size());
  for (const auto item : items) bytes.number(static_cast<std::uint64_t>(item));
}

template <class Item>
std::vector<Item> read_numbers(ByteReader& bytes) {
  std::vector<Item> items;
  for (std::uint64_t left = bytes.number(); left > 0; --left) items.push_back(static_cast<Item>(bytes.number()));
  return items;
}

void write_modes(ByteWriter& bytes, const std::vector<MechanismMode>& modes) {
  bytes.number(modes.size());
  for (const MechanismMode& mode : modes) write_numbers(bytes, mode);
}

std::vector<MechanismMode> read_modes(ByteReader& bytes) {
  std::vector<MechanismMode> modes;
  for (std::uint64_t left = bytes.number(); left > 0; --left) modes.push_back(read_numbers<ElementState>(bytes));
  return modes;
}

void write_found(ByteWriter& bytes, const FoundMotions& found) {
  bytes.number(static_cast<std::uint64_t>(found.count)).number(found.on_boundary).number(found.modes.size());
  for (const auto& modes : found.modes) write_modes(bytes, modes);
  write_modes(bytes, found.continua);
  write_numbers(bytes, found.not_modelled);
  bytes.number(found.in_space.size());
  for (const std::string& mode : found.in_space) bytes.text(mode);
  bytes.number(static_cast<std::uint64_t>(found.energy));
}

FoundMotions read_found(ByteReader& bytes) {
  FoundMotions found;
  found.count = static_cast<MotionCount>(bytes.number());
  found.on_boundary = bytes.number();
  for (std::uint64_t left = bytes.number(); left > 0; --left) found.modes.push_back(read_modes(bytes));
  found.continua = read_modes(bytes);
  found.not_modelled = read_numbers<std::size_t>(bytes);
  for (std::uint64_t left = bytes.number(); left > 0; --left) found.in_space.emplace_back(bytes.text());
  found.energy = static_cast<EnergyBalance>(bytes.number());
  return found;
}

void write_place(ByteWriter& bytes, const SearchPlace& place) {
  const MechanismValues& values = place.values;
  bytes.rationals(values.parameters);
  write_numbers(bytes, values.given);
  bytes.number(values.angles.size());
  for (const MechanismValues::Circle& angle : values.angles) bytes.rationals({angle.cosine, angle.sine});
  write_numbers(bytes, values.starts);
  bytes.rationals(place.load ? std::vector{*place.load} : std::vector<Rational>{});
}

SearchPlace read_place(ByteReader& bytes) {
  SearchPlace place;
  MechanismValues& values = place.values;
  values.parameters = bytes.rationals();
  values.given = read_numbers<bool>(bytes);
  for (std::uint64_t left = bytes.number(); left > 0; --left) {
    const std::vector<Rational> angle = bytes.rationals();
    values.angles.push_back({angle.at(0), angle.at(1)});
  }
  values.starts = read_numbers<ElementKind::Start>(bytes);
  if (const std::vector<Rational> load = bytes.rationals(); !load.empty()) place.load = load.front();
  return place;
}

}  // namespace

std::string shown_bytes(const Shown& shown) {
  ByteWriter bytes;
  bytes.number(static_cast<std::uint64_t>(shown.end)).number(shown.one_everywhere ? 1 : 0);
  bytes.number(shown.realisable ? 1 : 0).number(static_cast<std::uint64_t>(shown.energy));
  write_numbers(bytes, std::vector<MotionCount>(shown.counts.begin(), shown.counts.end()));
  bytes.number(shown.places.size());
  for (const auto& [found, place] : shown.places) {
    write_found(bytes, found);
    write_place(bytes, place);
  }
  return bytes.take();
}

Shown read_shown(std::string_view text) {
  ByteReader bytes(text);
  Shown shown;
  shown.end = static_cast<Shown::End>(bytes.number());
  shown.one_everywhere = bytes.number() != 0;
  shown.realisable = bytes.number() != 0;
  shown.energy = static_cast<EnergyBalance>(bytes.number());
  for (const MotionCount count : read_numbers<MotionCount>(bytes)) shown.counts.insert(count);
  for (std::uint64_t left = bytes.number(); left > 0; --left) {
    FoundMotions found = read_found(bytes);
    shown.places.emplace_back(std::move(found), read_place(bytes));
  }
  bytes.end();
  return shown;
}

std::string cell_bytes(const SearchCell& cell) {
  ByteWriter bytes;
  write_found(bytes, cell.found);
  bytes.number(cell.samples).number(cell.realisable ? 1 : 0);
  write_place(bytes, cell.simplest);
  if (cell.realisable) write_place(bytes, *cell.realisable);
  return bytes.take();
}

SearchCell read_cell(std::string_view text) {
  ByteReader bytes(text);
  SearchCell cell;
  cell.found = read_found(bytes);
  cell.samples = bytes.number();
  const bool realisable = bytes.number() != 0;
  cell.simplest = read_place(bytes);
  if (realisable) cell.realisable = read_place(bytes);
  bytes.end();
  return cell;
}

}  // namespace slipproof
