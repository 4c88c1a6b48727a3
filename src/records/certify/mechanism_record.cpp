#include "records/certify/mechanism_record.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/mechanism/words.hpp"
#include "mechanics/scene/degrees.hpp"

namespace slipproof {

CertifiedMechanism::CertifiedMechanism(Mechanism given)
    : mechanism(std::move(given)), values(default_values(mechanism)), has_angle(mechanism.angles.size(), false) {
  values.given.assign(mechanism.parameters.size(), false);
}

CertifiedMechanism::CertifiedMechanism(MechanismScene scene)
    : mechanism(std::move(scene.mechanism)),
      values(std::move(scene.values)),
      has_angle(mechanism.angles.size(), true),
      load(std::move(scene.load)) {}

MechanismFields::MechanismFields(const Mechanism& mechanism)
    : parameters_(mechanism.parameters.size()), angles_(mechanism.angles.size()) {
  const auto add = [this](std::string name) {
    places_.emplace(name, names_.size());
    names_.push_back(std::move(name));
  };
  for (const MechanismParameter& parameter : mechanism.parameters) add(parameter.symbol);
  for (const MechanismAngle& angle : mechanism.angles) {
    for (const char* form : {".tan_half", ".cos", ".sin", ".degrees"}) add(angle.name + form);
  }
  if (mechanism.load) {
    load_ = names_.size();
    add(mechanism.load->symbol);
  }
  first_answer_ = names_.size();
  for (std::string& name : acceleration_names(mechanism)) add(std::move(name));
  accelerations_ = names_.size() - first_answer_;
  for (std::string& name : force_names(mechanism)) add(std::move(name));
  const auto kinds = element_kinds(mechanism);
  refuse_too_many_modes(mechanism, kinds);
  for (MechanismMode& mode : modes_of(kinds)) {
    std::string text = slipproof::name(mode);
    modes_.emplace(std::move(text), std::move(mode));
  }
}

std::optional<std::size_t> MechanismFields::find(std::string_view name) const {
  const auto place = places_.find(name);
  return place == places_.end() ? std::nullopt : std::optional(place->second);
}

const MechanismMode* MechanismFields::find_mode(std::string_view name) const {
  const auto place = modes_.find(name);
  return place == modes_.end() ? nullptr : &place->second;
}

void MechanismRecord::clear(std::size_t fields) {
  values.resize(fields);
  present.assign(fields, false);
  exact.clear();
  mode = nullptr;
  not_finite.reset();
}

void MechanismRecord::set(std::size_t field, double value) {
  values[field] = value;
  present[field] = true;
}

void MechanismRecord::set(std::size_t field, Rational value) {
  set(field, nearest_binary64(value));
  exact.emplace_back(field, std::move(value));
}

bool MechanismRecord::is_exact(std::size_t field) const {
  return std::none_of(exact.begin(), exact.end(), [field](const auto& x) { return x.first == field; });
}

Rational MechanismRecord::exactly(std::size_t field) const {
  const auto found = std::find_if(exact.begin(), exact.end(), [field](const auto& x) { return x.first == field; });
  return found == exact.end() ? to_rational(values[field]) : found->second;
}

namespace {

/// cos and sin of a record, exactly on the circle or near it.
RecordAngle angle_of_point(const MechanismRecord& record, std::size_t cosine, std::size_t sine, std::string& mistake) {
  const double c = record.values[cosine], s = record.values[sine];
  const bool binary64 = record.is_exact(cosine) && record.is_exact(sine);
  if (!binary64 || s == 0) {
    const Rational x = record.exactly(cosine), y = record.exactly(sine);
    if (Rational(x * x + y * y) == 1) {
      if (x == -1) return {true, 0, std::nullopt};
      Rational t = y / (1 + x);
      const double nearest = nearest_binary64(t);
      return {false, nearest, std::move(t)};
    }
  }
  const double deviation = c * c + s * s - 1;
  if (!(std::fabs(deviation) <= circle_tolerance)) {
    mistake =
        "found cos^2 + sin^2 = " + decimal_text(to_rational(c) * to_rational(c) + to_rational(s) * to_rational(s), 17) +
        ", expected 1 to within 4e-15; tan_half has no such limit";
    return {};
  }
  if (s == 0) return {c < 0, 0, std::nullopt};
  return {false, c >= 0 ? s / (1 + c) : (1 - c) / s, std::nullopt};
}

RecordAngle angle_of_degrees(const Rational& degrees) {
  const MechanismValues::Circle point = angle_from_degrees(degrees).point;
  if (point.cosine == -1) return {true, 0, std::nullopt};
  return {false, nearest_binary64(Rational(point.sine / (1 + point.cosine))), std::nullopt};
}

}  // namespace

RecordAngle angle_of(const MechanismRecord& record, const MechanismFields& fields, std::size_t angle,
                     std::string& mistake) {
  const auto field = [&](MechanismFields::AngleForm form) { return fields.angle(angle, form); };
  const std::size_t tan_half = field(MechanismFields::tan_half);
  if (record.present[tan_half]) {
    RecordAngle result{false, record.values[tan_half], std::nullopt};
    if (!record.is_exact(tan_half)) result.exact = record.exactly(tan_half);
    return result;
  }
  if (record.present[field(MechanismFields::degrees)]) {
    return angle_of_degrees(record.exactly(field(MechanismFields::degrees)));
  }
  return angle_of_point(record, field(MechanismFields::cosine), field(MechanismFields::sine), mistake);
}

namespace {

std::string listed(const std::string& text, const std::string& name) {
  return text + (text.empty() ? "" : ", ") + name;
}

/// Of one angle: which forms are missing, or too many; empty if it has one, or the scene has it.
std::string incomplete_angle(const MechanismRecord& record, const MechanismFields& fields, std::size_t angle,
                             bool in_scene) {
  const auto has = [&](MechanismFields::AngleForm form) { return record.present[fields.angle(angle, form)]; };
  const auto name = [&](MechanismFields::AngleForm form) { return fields.name(fields.angle(angle, form)); };
  using enum MechanismFields::AngleForm;
  const bool point = has(cosine) || has(sine);
  const int forms = static_cast<int>(has(tan_half)) + static_cast<int>(point) + static_cast<int>(has(degrees));
  if (forms > 1) {
    std::string found;
    for (const auto form : {tan_half, cosine, sine, degrees}) {
      if (has(form)) found = listed(found, name(form));
    }
    return "found " + found + " together, expected the angle in one form";
  }
  if (point && !(has(cosine) && has(sine))) return "missing " + name(has(cosine) ? sine : cosine);
  if (forms == 1 || in_scene) return {};
  return "missing " + name(tan_half) + ", or " + name(cosine) + " and " + name(sine) + ", or " + name(degrees);
}

}  // namespace

std::string incomplete(const MechanismRecord& record, const MechanismFields& fields,
                       const CertifiedMechanism& mechanism) {
  for (std::size_t i = 0; i < fields.angles(); ++i) {
    if (std::string reason = incomplete_angle(record, fields, i, mechanism.has_angle[i]); !reason.empty()) {
      return reason;
    }
  }
  std::string missing;
  const auto need = [&](std::size_t field) {
    if (!record.present[field]) missing = listed(missing, fields.name(field));
  };
  for (std::size_t i = 0; i < fields.parameters(); ++i) {
    if (!mechanism.values.given[i] && !mechanism.mechanism.parameters[i].optional) need(i);
  }
  if (fields.load() && !mechanism.load) need(*fields.load());
  for (std::size_t i = 0; i < mechanism.mechanism.accelerations; ++i) need(fields.first_answer() + i);
  return missing.empty() ? missing : "missing " + missing;
}

}  // namespace slipproof
