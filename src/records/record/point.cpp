#include "records/record/point.hpp"

#include "base/expression/evaluate.hpp"
#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "mechanics/points/degrees.hpp"

namespace slipproof {

bool gives_angle(const std::vector<bool>& present, const RecordFields& fields, std::size_t angle) {
  for (std::size_t form = 0; form < RecordFields::angle_forms; ++form) {
    if (present[fields.angle(angle, RecordFields::AngleForm{form})]) return true;
  }
  return false;
}

namespace {

/// The values that the short forms of a record give, in addition to the record's own.
class FormValues {
 public:
  FormValues(const RecordSetting& setting, const Record& record, RecordPoint& point)
      : fields_(setting.fields), record_(record), point_(point) {
    scope_.slots.resize(fields_.size());
  }

  void take(const RecordFields::Form& form) {
    if (!record_.present[form.symbols.front()]) return;
    for (const RecordFields::Form::Set& set : form.sets) {
      Evaluator<Rational> at(scope_);
      for (const std::size_t slot : set.value.slots()) {
        if (auto number = number_of(slot)) at.set(slot, std::move(*number));
      }
      put(set, at.number(set.value).number);
    }
  }

 private:
  std::optional<Rational> number_of(std::size_t field) const {
    if (field < fields_.parameters()) return point_.values.parameters[field];
    return field == fields_.load() ? point_.load : std::optional(record_.exactly(field));
  }

  void put(const RecordFields::Form::Set& set, std::optional<Rational> value) {
    const bool load = set.target == fields_.parameters();
    if (!value) {
      point_.mistake = fields_.name(load ? *fields_.load() : set.target) + " has no value: it divides by zero";
    } else if (load) {
      point_.load = std::move(value);
    } else {
      point_.values.parameters[set.target] = std::move(*value);
      point_.values.given[set.target] = true;
    }
  }

  const RecordFields& fields_;
  const Record& record_;
  RecordPoint& point_;
  Scope scope_;
};

}  // namespace

RecordPoint point_of(const RecordSetting& setting, const Record& record) {
  const auto& [certified, fields, maker, kinds] = setting;
  RecordPoint point{certified.values, certified.load, {}};
  for (std::size_t i = 0; i < fields.parameters(); ++i) {
    if (!record.present[i]) continue;
    point.values.parameters[i] = record.exactly(i);
    point.values.given[i] = true;
  }
  for (std::size_t i = 0; i < fields.angles(); ++i) {
    if (!gives_angle(record.present, fields, i)) continue;
    std::string mistake;
    const RecordAngle angle = angle_of(record, fields, i, mistake);
    if (!mistake.empty() && point.mistake.empty()) {
      point.mistake = certified.mechanism.angles[i].name + ": " + mistake;
    }
    point.values.angles[i] = angle.half_turn
                                 ? MechanismValues::Circle{-1, 0}
                                 : point_of_tan_half(angle.exact ? *angle.exact : to_rational(angle.nearest));
  }
  if (fields.load() && record.present[*fields.load()]) point.load = record.exactly(*fields.load());
  FormValues forms(setting, record, point);
  for (const RecordFields::Form& form : fields.forms()) forms.take(form);
  return point;
}

std::string outside_domain(const RecordSetting& setting, const RecordPoint& point) {
  const Mechanism& mechanism = setting.certified.mechanism;
  const auto broken = setting.maker.broken(point.values);
  using What = ProblemMaker::Broken::What;
  if (!broken.empty()) {
    const ProblemMaker::Broken& one = broken.front();
    const std::string expected = ", expected " + to_string(one.condition->expression);
    if (one.what == What::parameter) {
      return mechanism.parameters[one.index].symbol + ": found " + exact_text(point.values.parameters[one.index]) +
             expected;
    }
    if (one.what == What::angle) {
      const MechanismValues::Circle& at = point.values.angles[one.index];
      return mechanism.angles[one.index].name + ": found the cosine " + decimal_text(at.cosine, 6) + " and the sine " +
             decimal_text(at.sine, 6) + expected;
    }
    return "found values that break " + mechanism.assume[one.index].name + expected;
  }
  if (!point.load) return {};
  const ForceInterval loads = setting.maker.load_domain(point.values);
  if (loads.contains(*point.load)) return {};
  return mechanism.load->symbol + ": found " + exact_text(*point.load) + ", expected a value in " + to_string(loads);
}

}  // namespace slipproof
