#include "records/record/record.hpp"

#include <algorithm>
#include <cmath>

#include "base/expression/parser.hpp"
#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/mechanism/words.hpp"
#include "mechanics/points/degrees.hpp"

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

RecordFields::RecordFields(const CertifiedMechanism& certified)
    : word_(certified.word),
      parameters_(certified.mechanism.parameters.size()),
      angles_(certified.mechanism.angles.size()) {
  const Mechanism& mechanism = certified.mechanism;
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
  for (const ShortForm& form : certified.forms) {
    for (const std::string& symbol : form.symbols) add(symbol);
  }
  first_answer_ = names_.size();
  for (std::string& name : acceleration_names(mechanism)) add(std::move(name));
  accelerations_ = names_.size() - first_answer_;
  for (std::string& name : force_names(mechanism)) add(std::move(name));
  modes_ = std::make_shared<RecordModes>(element_kinds(mechanism));
  has_modes_ = mechanism.dimension == 2;
  for (const std::string& name : certified.answers) required_.push_back(*find(name));
  // By Poisson's law there are velocities at the end of compression, too, which an answer need not have.
  const std::size_t unknowns = mechanism.impact ? mechanism.impact->velocities.size() : mechanism.accelerations;
  for (std::size_t i = 0; i < unknowns && certified.answers.empty(); ++i) {
    required_.push_back(first_answer_ + i);
  }
  for (const ShortForm& form : certified.forms) {
    Form& made = forms_.emplace_back();
    for (const std::string& symbol : form.symbols) made.symbols.push_back(*find(symbol));
    for (const ShortForm::Set& set : form.sets) {
      const std::size_t target = *find(set.target);
      made.sets.push_back(
          {target < parameters_ ? target : parameters_, Program(parse_expression(set.expression, Sort::number),
                                                                [this](std::string_view name) { return find(name); })});
    }
  }
}

std::optional<std::size_t> RecordFields::find_word(std::string_view word) const {
  const auto place = std::find(word_->words.begin(), word_->words.end(), word);
  if (place == word_->words.end()) return std::nullopt;
  return static_cast<std::size_t>(place - word_->words.begin());
}

std::optional<std::size_t> RecordFields::find(std::string_view name) const {
  const auto place = places_.find(name);
  return place == places_.end() ? std::nullopt : std::optional(place->second);
}

void Record::clear(std::size_t fields) {
  values.resize(fields);
  present.assign(fields, false);
  exact.clear();
  mode = no_mode;
  not_finite.reset();
}

void Record::set(std::size_t field, double value) {
  values[field] = value;
  present[field] = true;
}

void Record::set(std::size_t field, Rational value) {
  const double nearest = nearest_binary64(value);
  set(field, nearest);
  if (!std::isfinite(nearest) || to_rational(nearest) != value) exact.emplace_back(field, std::move(value));
}

bool Record::is_exact(std::size_t field) const {
  return std::none_of(exact.begin(), exact.end(), [field](const auto& x) { return x.first == field; });
}

Rational Record::exactly(std::size_t field) const {
  const auto found = std::find_if(exact.begin(), exact.end(), [field](const auto& x) { return x.first == field; });
  return found == exact.end() ? to_rational(values[field]) : found->second;
}

namespace {

/// The angle from cosine and sine in a record, which are a point exactly on the circle or near it.
RecordAngle angle_of_point(const Record& record, std::size_t cosine, std::size_t sine, std::string& mistake) {
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

RecordAngle angle_of(const Record& record, const RecordFields& fields, std::size_t angle, std::string& mistake) {
  const auto field = [&](RecordFields::AngleForm form) { return fields.angle(angle, form); };
  const std::size_t tan_half = field(RecordFields::tan_half);
  if (record.present[tan_half]) {
    RecordAngle result{false, record.values[tan_half], std::nullopt};
    if (!record.is_exact(tan_half)) result.exact = record.exactly(tan_half);
    return result;
  }
  if (record.present[field(RecordFields::degrees)]) {
    return angle_of_degrees(record.exactly(field(RecordFields::degrees)));
  }
  return angle_of_point(record, field(RecordFields::cosine), field(RecordFields::sine), mistake);
}

namespace {

/// For one angle: which forms are missing or given in addition; empty if the record has one form, or the scene gives
/// the angle.
std::string incomplete_angle(const std::vector<bool>& present, const RecordFields& fields, std::size_t angle,
                             bool in_scene) {
  const auto has = [&](RecordFields::AngleForm form) { return present[fields.angle(angle, form)]; };
  const auto name = [&](RecordFields::AngleForm form) { return fields.name(fields.angle(angle, form)); };
  using enum RecordFields::AngleForm;
  const bool point = has(cosine) || has(sine);
  const int forms = static_cast<int>(has(tan_half)) + static_cast<int>(point) + static_cast<int>(has(degrees));
  if (forms > 1) {
    std::vector<std::string> found;
    for (const auto form : {tan_half, cosine, sine, degrees}) {
      if (has(form)) found.push_back(name(form));
    }
    return "found " + listed(found) + " together, expected the angle in one form";
  }
  if (point && !(has(cosine) && has(sine))) return "missing " + name(has(cosine) ? sine : cosine);
  if (forms == 1 || in_scene) return {};
  return "missing " + name(tan_half) + ", or " + name(cosine) + " and " + name(sine) + ", or " + name(degrees);
}

/// The field that a form sets.
std::size_t target_field(const RecordFields& fields, const RecordFields::Form::Set& set) {
  return set.target < fields.parameters() ? set.target : *fields.load();
}

/// The mistake in the short forms of a record, if any; adds the fields that the forms set to `set`.
std::string mistake_in_forms(const std::vector<bool>& present, const RecordFields& fields, std::vector<bool>& set) {
  const auto has = [&](std::size_t field) { return present[field]; };
  const auto name = [&](std::size_t field) { return fields.name(field); };
  for (const RecordFields::Form& form : fields.forms()) {
    if (std::none_of(form.symbols.begin(), form.symbols.end(), has)) continue;
    for (const std::size_t symbol : form.symbols) {
      if (!present[symbol]) return "missing " + fields.name(symbol) + ", expected " + listed(form.symbols, name);
    }
    for (const RecordFields::Form::Set& one : form.sets) {
      const std::size_t field = target_field(fields, one);
      if (present[field] || set[field]) {
        return "found " + listed(form.symbols, name) + " together with " + fields.name(field) +
               (present[field] ? "" : " in another form") + ", expected only one of them";
      }
    }
    for (const RecordFields::Form::Set& one : form.sets) set[target_field(fields, one)] = true;
  }
  return {};
}

/// " (or h0)" where forms would give a field, too.
std::string other_forms(const RecordFields& fields, std::size_t field) {
  std::string text;
  for (const RecordFields::Form& form : fields.forms()) {
    const auto sets = [&](const RecordFields::Form::Set& one) { return target_field(fields, one) == field; };
    if (std::ranges::none_of(form.sets, sets)) continue;
    text += text.empty() ? " (or " : ", or ";
    text += listed(
        form.symbols, [&](std::size_t symbol) { return fields.name(symbol); }, " and ");
  }
  return text.empty() ? text : text + ")";
}

}  // namespace

std::string incomplete(const std::vector<bool>& present, const RecordFields& fields,
                       const CertifiedMechanism& mechanism) {
  for (std::size_t i = 0; i < fields.angles(); ++i) {
    if (std::string reason = incomplete_angle(present, fields, i, mechanism.has_angle[i]); !reason.empty()) {
      return reason;
    }
  }
  std::vector<bool> set(fields.size(), false);
  if (std::string reason = mistake_in_forms(present, fields, set); !reason.empty()) return reason;
  std::vector<std::string> missing;
  const auto need = [&](std::size_t field) {
    if (!present[field] && !set[field]) missing.push_back(fields.name(field) + other_forms(fields, field));
  };
  for (std::size_t i = 0; i < fields.parameters(); ++i) {
    if (!mechanism.values.given[i] && !mechanism.mechanism.parameters[i].optional) need(i);
  }
  if (fields.load() && !mechanism.load) need(*fields.load());
  for (const std::size_t field : fields.required_answers()) need(field);
  return missing.empty() ? "" : "missing " + listed(missing);
}

}  // namespace slipproof
