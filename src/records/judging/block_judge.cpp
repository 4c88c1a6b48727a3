#include "records/judging/block_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/number/binary64.hpp"
#include "floating/batch/lane_points.hpp"
#include "records/judging/lane_answer.hpp"

namespace slipproof {

namespace {

constexpr auto row_numbers = [] {
  std::array<std::uint16_t, block_records> rows{};
  for (std::uint16_t i = 0; i < block_records; ++i) rows[i] = i;
  return rows;
}();

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  ///< nothing is sure of it

/// A short form that binary64 can compute: a number, a symbol, or the difference of two symbols.
struct SimpleForm {
  std::optional<Rational> number;
  std::optional<std::size_t> plus, minus;  ///< fields
};

std::optional<SimpleForm> simple_form(const Program& program) {
  const auto& code = program.code();
  const auto symbol = [&](std::uint32_t index) -> std::optional<std::size_t> {
    return code[index].operation == Operation::symbol ? std::optional<std::size_t>(code[index].first) : std::nullopt;
  };
  const Program::Instruction& root = code[program.root()];
  if (root.operation == Operation::number) return SimpleForm{program.constants()[root.first], {}, {}};
  if (root.operation == Operation::symbol) return SimpleForm{{}, symbol(program.root()), {}};
  if (root.operation != Operation::subtract || !symbol(root.first) || !symbol(root.second)) return std::nullopt;
  return SimpleForm{{}, symbol(root.first), symbol(root.second)};
}

}  // namespace

BlockJudge::Number BlockJudge::number_of(const Rational& x) {
  const double nearest = nearest_binary64(x);
  return {nearest, std::isfinite(nearest) && to_rational(nearest) == x};
}

BlockJudge::BlockJudge(const RecordJudge& judge) : judge_(judge), part_(judge.fields()) {
  const CertifiedMechanism& certified = judge.certified();
  for (const Rational& value : certified.values.parameters) base_.push_back(number_of(value));
  base_.push_back(number_of(certified.load.value_or(0)));
  for (const MechanismValues::Circle& at : certified.values.angles) {
    base_angles_.push_back(at.cosine == -1 ? Number{unknown, false} : number_of(at.sine / (1 + at.cosine)));
  }
}

/// The source of a parameter, or of the load, which comes after the parameters.
BlockJudge::Source BlockJudge::source(std::size_t input, const std::vector<bool>& present) const {
  const RecordFields& fields = judge_.fields();
  const bool load = input == fields.parameters();
  if (load && !fields.load()) return {};
  const std::size_t field = load ? *fields.load() : input;
  if (present[field]) return {Source::Kind::field, {}, field};
  for (const RecordFields::Form& form : fields.forms()) {
    if (!present[form.symbols.front()]) continue;
    for (const RecordFields::Form::Set& set : form.sets) {
      if (set.target == input) return source(set, present);
    }
  }
  const bool given = load ? judge_.certified().load.has_value() : judge_.certified().values.given[input];
  return given ? Source{Source::Kind::same, base_[input]} : Source{};
}

BlockJudge::Source BlockJudge::source(const RecordFields::Form::Set& set, const std::vector<bool>& present) const {
  const Source exact_only{Source::Kind::exact_only};
  const auto simple = simple_form(set.value);
  if (!simple) return exact_only;
  if (simple->number) return {Source::Kind::same, number_of(*simple->number)};
  if (!present[*simple->plus]) return exact_only;
  if (!simple->minus) return {Source::Kind::field, {}, *simple->plus};
  if (present[*simple->minus]) return {Source::Kind::difference, {}, *simple->plus, *simple->minus};
  const Source other = source(*simple->minus, present);
  if (other.kind != Source::Kind::same || !other.number.exact) return exact_only;
  return {Source::Kind::difference, other.number, *simple->plus, 0, true};
}

void BlockJudge::use(const std::vector<bool>& present) {
  const RecordFields& fields = judge_.fields();
  present_ = present;
  sources_.clear();
  // no program tries the modes of others, or tells an energy
  const Mechanism& mechanism = judge_.certified().mechanism;
  able_ = fields.modes().has_all() && mechanism.dimension == 2 && !mechanism.impact;
  if (!able_) return;
  std::vector<bool> given;
  for (std::size_t i = 0; i <= fields.parameters(); ++i) sources_.push_back(source(i, present));
  for (std::size_t i = 0; i < fields.parameters(); ++i) given.push_back(sources_[i].kind != Source::Kind::none);
  batch_ = &judge_.batch(given);
  able_ = batch_->code() != nullptr &&
          std::ranges::none_of(sources_, [](const Source& x) { return x.kind == Source::Kind::exact_only; });
  if (!able_) return;
  run_ = std::make_unique<ModeRun>(*batch_->code());
  modes_.assign(fields.modes().size(), no_mode);
  names_.clear();
  for (const MechanismMode& mode : batch_->modes()) {
    names_.push_back(*fields.find_mode(name(mode)));
    modes_[names_.back()] = static_cast<std::uint16_t>(names_.size() - 1);
  }
  buffers_.resize(sources_.size() + fields.angles());
  points_.clear();
}

Column BlockJudge::column(const Source& source, const RecordBlock& block, std::vector<double>& buffer) const {
  switch (source.kind) {
    case Source::Kind::same:
      return Column(source.number.nearest).rounded(!source.number.exact);
    case Source::Kind::field: {
      const std::span<const double> numbers = block.numbers(source.field);
      const bool is_word = judge_.fields().word() && source.field == judge_.fields().word_field();
      return (is_word ? Column(numbers[0]) : Column(numbers)).rounded(block.rounded(source.field));
    }
    case Source::Kind::difference: {
      // If both numbers are exact, their difference is rounded only once.
      if (block.rounded(source.field) || (!source.minus_number && block.rounded(source.minus))) return Column(unknown);
      buffer.resize(block.size());
      const std::span<const double> x = block.numbers(source.field);
      for (std::size_t i = 0; i < buffer.size(); ++i) {
        buffer[i] = x[i] - (source.minus_number ? source.number.nearest : block.numbers(source.minus)[i]);
      }
      return Column(buffer).rounded();
    }
    default:
      return {};
  }
}

/// tan(angle/2) of each record; NaN if the kernel must compute it.
Column BlockJudge::angle(std::size_t index, const RecordBlock& block, std::vector<double>& buffer) const {
  const RecordFields& fields = judge_.fields();
  if (!gives_angle(block.present(), fields, index)) {
    const Number& number = base_angles_[index];
    return Column(number.nearest).rounded(!number.exact);
  }
  const std::size_t tan_half = fields.angle(index, RecordFields::tan_half);
  if (block.present()[tan_half]) return column({Source::Kind::field, {}, tan_half}, block, buffer);
  Record record;
  record.clear(fields.size());
  std::vector<std::size_t> forms;
  for (std::size_t form = 0; form < RecordFields::angle_forms; ++form) {
    const std::size_t field = fields.angle(index, RecordFields::AngleForm{form});
    if (block.rounded(field)) return Column(unknown);
    if (block.present()[field]) forms.push_back(field);
  }
  for (const std::size_t field : forms) record.present[field] = true;
  bool exact = true;
  buffer.resize(block.size());
  for (std::size_t row = 0; row < buffer.size(); ++row) {
    for (const std::size_t field : forms) record.values[field] = block.numbers(field)[row];
    std::string mistake;
    const RecordAngle found = angle_of(record, fields, index, mistake);
    buffer[row] = found.half_turn || !mistake.empty() ? unknown : found.nearest;
    exact = exact && !found.exact;
  }
  return Column(buffer).rounded(!exact);
}

void BlockJudge::fill_columns(const RecordBlock& block) {
  const std::size_t parameters = judge_.fields().parameters();
  columns_ = {};
  for (std::size_t i = 0; i < parameters; ++i) {
    columns_.parameters.push_back(column(sources_[i], block, buffers_[i]));
  }
  columns_.load = column(sources_[parameters], block, buffers_[parameters]);
  for (std::size_t i = 0; i < judge_.fields().angles(); ++i) {
    columns_.tan_halves.push_back(angle(i, block, buffers_[parameters + 1 + i]));
  }
}

void BlockJudge::look_at(const RecordBlock& block) {
  if (!present_ || *present_ != block.present()) use(block.present());
  motions_.assign(block.size(), no_mode);
  if (!able_ || block.size() == 0) return;
  status_.resize(block.size() * names_.size());
  for_each_word(block, [this](const RecordBlock& part, std::span<const std::uint16_t> rows, double word) {
    look_at(part, rows, word);
  });
}

/// see(part, rows, word) of records that have the same word: it is no number that varies.
template <class See>
void BlockJudge::for_each_word(const RecordBlock& block, const See& see) {
  const auto all = std::span(row_numbers).first(block.size());
  const RecordFields& fields = judge_.fields();
  if (!fields.word() || !block.present()[fields.word_field()]) return see(block, all, 0);
  const std::span<const double> words = block.numbers(fields.word_field());
  std::vector<double> values;  // a row without a finite one is left to the kernel
  std::ranges::copy_if(words, std::back_inserter(values), [](double word) { return std::isfinite(word); });
  const bool all_have_one = values.size() == words.size();
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (all_have_one && values.size() == 1) return see(block, all, values.front());
  std::array<std::uint16_t, block_records> rows;
  for (const double value : values) {
    const auto end =
        std::ranges::copy_if(all, rows.begin(), [&](std::uint16_t row) { return words[row] == value; }).out;
    const auto some = std::span(rows).first(static_cast<std::size_t>(end - rows.begin()));
    part_.take(block, some);
    see(part_, some, value);
  }
}

/// `rows` are those of the part's records in the whole block.
void BlockJudge::look_at(const RecordBlock& part, std::span<const std::uint16_t> rows, double word) {
  fill_columns(part);
  find_motions(rows, points_.try_emplace(word, *batch_, columns_).first->second);
  std::vector<std::uint16_t> occur;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::uint16_t& motion = motions_[rows[i]];
    motion = claimed_mode(rows[i], motion, part.mode(i));
    if (motion != no_mode && std::ranges::find(occur, motion) == occur.end()) occur.push_back(motion);
  }
  std::array<std::uint16_t, block_records> own;
  for (const std::uint16_t mode : occur) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {  // no branch: which rows are wanted is anyone's guess
      own[count] = static_cast<std::uint16_t>(i);
      count += static_cast<std::size_t>(motions_[rows[i]] == mode);
    }
    bound_errors(part, mode, std::span(own).first(count), rows);
  }
}

/// Of each record the first mode of its only motion, if binary64 is sure of it.
void BlockJudge::find_motions(std::span<const std::uint16_t> rows, SurePoints& points) {
  const auto varies = [](const Column& column) { return column.size() > 1; };
  const bool one_point = !varies(columns_.load) && std::ranges::none_of(columns_.parameters, varies) &&
                         std::ranges::none_of(columns_.tan_halves, varies);
  const auto put = [&](std::size_t row, std::span<const ModeAt> status, std::size_t mode) {
    motions_[row] = static_cast<std::uint16_t>(mode);
    std::ranges::copy(status, &status_[row * names_.size()]);
  };
  points.decide(one_point ? 1 : rows.size(),
                [&](std::size_t point, std::span<const ModeAt> status, const std::optional<std::size_t>& mode) {
                  if (!mode) return;
                  if (!one_point) return put(rows[point], status, *mode);
                  for (const std::uint16_t row : rows) put(row, status, *mode);
                });
}

/// The mode that a record claims, if it is a strict mode of the only motion; without a claim, the first mode of that
/// motion.
std::uint16_t BlockJudge::claimed_mode(std::size_t row, std::uint16_t only, std::uint16_t claimed) const {
  if (only == no_mode || claimed == no_mode) return only;
  const std::uint16_t mode = modes_[claimed];
  return mode != no_mode && is_of_motion(row, only, mode) ? mode : no_mode;
}

/// Whether a mode is strict at a record's point and gives the same motion as `motion`.
bool BlockJudge::is_of_motion(std::size_t row, std::uint16_t motion, std::uint16_t mode) const {
  const auto& programs = batch_->code()->programs().programs;
  return programs[mode].motion == programs[motion].motion && status_[row * names_.size() + mode] == ModeAt::strict;
}

/// Of some records of a part, whose rows in the whole block are `rows`.
void BlockJudge::bound_errors(const RecordBlock& part, std::uint16_t mode, std::span<const std::uint16_t> own,
                              std::span<const std::uint16_t> rows) {
  const ModePrograms& programs = batch_->code()->programs();
  for (std::size_t first = 0; first < own.size(); first += lane_count) {
    const auto some = own.subspan(first, std::min<std::size_t>(lane_count, own.size() - first));
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      put_point(columns_, programs, some[std::min(lane, some.size() - 1)], lane, *run_);
    }
    const ModeRun::Values& values = run_->compute_values(mode);
    run_->compute_scales();
    const Lanes errors = answer_errors(part, some, judge_.fields(), programs, mode, *run_, values);
    for (std::size_t lane = 0; lane < some.size(); ++lane) errors_[rows[some[lane]]] = errors[lane];
  }
}

bool BlockJudge::certified(std::size_t row, RecordJudgement& judgement) const {
  const std::uint16_t mode = motions_[row];
  if (mode == no_mode || !(errors_[row] <= judge_.options().tolerance)) return false;
  judgement.verdict = RecordVerdict::certified;
  judgement.tier = Tier::filter;
  judgement.motions = 1;
  judgement.continuum = judgement.contact_problem = false;
  judgement.max_error = errors_[row];
  judgement.rho = 0;
  for (std::string* text : {&judgement.mode_names, &judgement.details, &judgement.members}) text->clear();
  judgement.modes.clear();
  for (std::uint16_t i = 0; i < names_.size(); ++i) {
    if (is_of_motion(row, mode, i)) judgement.add_mode(names_[i], judge_.fields().mode_name(names_[i]));
  }
  return true;
}

}  // namespace slipproof
