#include "claims/meaning/statement_judge.hpp"

#include <algorithm>

namespace slipproof::meaning {

namespace {

bool relation_holds(Relation relation, const Rational& difference) {
  switch (relation) {
    case Relation::less:
      return difference < 0;
    case Relation::less_equal:
      return difference <= 0;
    case Relation::greater:
      return difference > 0;
    case Relation::greater_equal:
      return difference >= 0;
    case Relation::equal:
      return difference == 0;
    case Relation::not_equal:
      break;
  }
  return difference != 0;
}

Number calculated(const Expression& e, const std::vector<Rational>& parts) {
  switch (e->operation) {
    case Operation::negate:
      return -parts[0];
    case Operation::add:
      return parts[0] + parts[1];
    case Operation::subtract:
      return parts[0] - parts[1];
    case Operation::multiply:
      return parts[0] * parts[1];
    case Operation::divide:
      return parts[1] == 0 ? Number() : Rational(parts[0] / parts[1]);
    case Operation::power:
      return to_power(parts[0], e->exponent);
    default:
      throw std::logic_error("no operation of a statement");
  }
}

}  // namespace

StatementValues::StatementValues(const StatementText& statement) {
  for (const Directive& line : statement.directives) {
    if (line.kind == Directive::Kind::let || line.kind == Directive::Kind::define) {
      abbreviations_[line.names.front()] = line.body;
    }
  }
}

Number StatementValues::number(const Expression& e) const {
  if (e->operation == Operation::number) return e->number;
  if (e->operation == Operation::symbol) {
    const auto variable = variables_.find(e->symbol);
    return variable != variables_.end() ? variable->second : number(abbreviations_.at(e->symbol));
  }
  std::vector<Rational> parts;
  for (const Expression& operand : e->operands) {
    const Number value = number(operand);
    if (!value) return {};
    parts.push_back(*value);
  }
  return calculated(e, parts);
}

bool StatementValues::holds(const Expression& f) const {
  const auto part_holds = [&](const Expression& part) { return holds(part); };
  switch (f->operation) {
    case Operation::symbol:
      return holds(abbreviations_.at(f->symbol));
    case Operation::truth:
      return f->truth;
    case Operation::logical_and:
      return std::all_of(f->operands.begin(), f->operands.end(), part_holds);
    case Operation::logical_or:
      return std::any_of(f->operands.begin(), f->operands.end(), part_holds);
    default:
      break;
  }
  for (std::size_t i = 0; i < f->relations.size(); ++i) {
    const Number left = number(f->operands[i]), right = number(f->operands[i + 1]);
    if (!left || !right || !relation_holds(f->relations[i], *left - *right)) return false;
  }
  return true;
}

std::set<std::string> StatementValues::variables(const Expression& formula) const {
  std::set<std::string> result;
  for (const std::string& symbol : symbols(formula)) {
    const auto abbreviation = abbreviations_.find(symbol);
    if (abbreviation == abbreviations_.end()) {
      result.insert(symbol);
    } else {
      result.merge(variables(abbreviation->second));
    }
  }
  return result;
}

StatementJudge::StatementJudge(const File& file, const World& world, std::size_t claim, Dice& dice)
    : world_(world), dice_(dice) {
  const SecondJudge judge(file, world);
  const std::string& kind = file.claims[claim].kind;
  linear_ = kind == "consequence" || kind == "system";
  if (kind == "limit") {
    parameter_ = file.claims[claim].parameter;
    values_ = judge.values_of_parameter(file.claims[claim]);
    points_[0] = {};
  } else if (linear_) {
    find_solutions(judge, file.claims[claim]);
  } else {
    for (const Rational& x : judge.places(claim)) points_[x] = {};
    find_motions(judge, file.claims[claim]);
  }
}

bool StatementJudge::is_true(const std::string& text) const {
  const Reading reading = read(text);
  if (values_.empty()) return is_true_at(reading, world_.names());
  return std::all_of(values_.begin(), values_.end(), [&](const Rational& value) {
    Names names = world_.names();
    names.values[parameter_] = value;
    return is_true_at(reading, names);
  });
}

bool StatementJudge::is_true_at(const Reading& reading, const Names& names) const {
  StatementValues values(reading.text);
  for (const auto& [symbol, value] : names.values) values.set(symbol, value);
  Free free = free_of(reading.known);
  if (!values_.empty()) free = {};  // nothing in a limit depends on the force
  // Statements about many motions at once have too many points: a motion that is none is passed over at once.
  const auto assumed = assumed_after(reading, values, free);
  const auto possible = [&](std::size_t endings) {
    return std::ranges::all_of(assumed[endings], [&](const Expression& formula) { return values.holds(formula); });
  };
  return !some(free, values, possible, [&] { return !conclusion(reading, values); });
}

std::vector<std::vector<Expression>> StatementJudge::assumed_after(const Reading& reading,
                                                                   const StatementValues& values,
                                                                   const Free& free) const {
  std::vector<std::vector<Expression>> result(free.endings.size() + 1);
  for (const Expression& formula : reading.assumed) {
    const std::set<std::string> names = values.variables(formula);
    const std::vector<std::string> its = free_of({names.begin(), names.end()}).endings;
    std::size_t after = 0;
    for (std::size_t i = 0; i < free.endings.size(); ++i) {
      if (std::ranges::find(its, free.endings[i]) != its.end()) after = i + 1;
    }
    result[after].push_back(formula);
  }
  return result;
}

StatementJudge::Reading StatementJudge::read(const std::string& text) {
  Reading result{read_statement("random", text), {}, {}, {}, {}};
  for (const Directive& line : result.text.directives) {
    std::vector<std::string>& names = line.kind == Directive::Kind::exists ? result.sought : result.known;
    const bool declares = line.kind == Directive::Kind::exists || line.kind == Directive::Kind::real;
    if (declares) names.insert(names.end(), line.names.begin(), line.names.end());
    if (line.kind == Directive::Kind::assume) result.assumed.push_back(line.body);
    if (line.kind == Directive::Kind::show) result.shown = line.body;
  }
  return result;
}

StatementJudge::Free StatementJudge::free_of(const std::vector<std::string>& names) const {
  Free result;
  for (const std::string& name : names) {
    if (name == world_.setting().force) result.force = true;
    std::string unknown = name, ending;
    for (std::size_t end = 1; end < name.size() && !world_.is_unknown(unknown); ++end) {
      unknown = name.substr(0, name.size() - end);
      ending = name.substr(name.size() - end);
    }
    const auto known = std::find(result.endings.begin(), result.endings.end(), ending);
    if (world_.is_unknown(unknown) && known == result.endings.end()) result.endings.push_back(ending);
  }
  return result;
}

bool StatementJudge::conclusion(const Reading& reading, StatementValues& values) const {
  return reading.sought.empty() ? values.holds(reading.shown) : some_sought(reading, values);
}

bool StatementJudge::some_sought(const Reading& reading, StatementValues& values) const {
  const auto shown = [&] { return values.holds(reading.shown); };
  if (!values_.empty()) {  // another value of the limit's parameter
    return std::any_of(values_.begin(), values_.end(), [&](const Rational& value) {
      values.set(reading.sought.front(), value);
      return shown();
    });
  }
  const bool some_are_known = std::any_of(reading.known.begin(), reading.known.end(),
                                          [&](const std::string& name) { return world_.is_unknown(name); });
  const auto any = [](std::size_t) { return true; };
  if (!some_are_known && !linear_) return some(free_of(reading.sought), values, any, shown);
  const bool force_sought = free_of(reading.sought).force;
  if (force_sought) return some(free_of(reading.sought), values, any, shown);
  const Point point = completed(reading, values);
  StatementValues completed_values = values;
  for (std::size_t i = 0; i < world_.unknowns().size(); ++i) {
    if (std::find(reading.sought.begin(), reading.sought.end(), world_.unknowns()[i]) != reading.sought.end()) {
      completed_values.set(world_.unknowns()[i], point[i]);
    }
  }
  return completed_values.holds(reading.shown);
}

template <class Possible, class Wanted>
bool StatementJudge::some(const Free& free, StatementValues& values, const Possible& possible,
                          const Wanted& wanted) const {
  const std::string& X = world_.setting().force;
  static const std::vector<Point> none;
  const auto at = [&](const std::vector<Point>& points) {
    return some_points(free, 0, points, values, possible, wanted);
  };
  if (!free.force && free.endings.empty()) return at(none);
  if (!free.force) return at(points_.at(X.empty() ? Rational(0) : values.value(X)));
  return std::any_of(points_.begin(), points_.end(), [&](const auto& at_force) {
    values.set(X, at_force.first);
    return at(at_force.second);
  });
}

template <class Possible, class Wanted>
bool StatementJudge::some_points(const Free& free, std::size_t from, const std::vector<Point>& points,
                                 StatementValues& values, const Possible& possible, const Wanted& wanted) const {
  if (!possible(from)) return false;
  if (from == free.endings.size()) return wanted();
  return std::any_of(points.begin(), points.end(), [&](const Point& point) {
    set(values, point, free.endings[from]);
    return some_points(free, from + 1, points, values, possible, wanted);
  });
}

void StatementJudge::set(StatementValues& values, const Point& point, const std::string& ending) const {
  for (std::size_t i = 0; i < world_.unknowns().size(); ++i) values.set(world_.unknowns()[i] + ending, point[i]);
}

/// All motions in a mode, boundary motions and enough of each continuum included; and what is no motion.
void StatementJudge::find_motions(const SecondJudge& judge, const Claim& claim) {
  for (auto& [x, points] : points_) {
    for (const Mode& mode : world_.modes()) {
      const Solutions* solutions = world_.solutions(mode);
      if (solutions == nullptr) continue;
      for (const Rational& t : solutions->parameters(x, judge.planes(claim, *solutions))) {
        if (solutions->meets(x, t, false)) points.push_back(motion_point(solutions->at(x, t), x));
      }
    }
    points.push_back(random_point());
  }
}

StatementJudge::Point StatementJudge::motion_point(const Motion& motion, const Rational& x) const {
  Point result;
  for (const std::string& unknown : world_.unknowns()) result.push_back(motion.at(unknown));
  result.insert(result.end(), {x, Rational(1)});
  return result;
}

/// Points of both sides of the claim, and others: what does not follow from linear equations fails at nearly all of
/// their solutions.
void StatementJudge::find_solutions(const SecondJudge& judge, const Claim& claim) {
  const auto assumed = judge.hypotheses(claim), right = judge.right_side(claim);
  if (!assumed.fine || !right.fine) throw OutOfReach("equations that are not linear");
  hypotheses_ = assumed.rows;
  const Echelon echelon(assumed.rows, first_columns(world_.constant_column())),
      right_echelon(right.rows, first_columns(world_.constant_column()));
  for (int i = 0; i < 6; ++i) {
    for (const Point& point :
         {echelon.solution(random_point(), first_columns(world_.constant_column())),
          right_echelon.solution(random_point(), first_columns(world_.constant_column())), random_point()}) {
      const bool load = !world_.setting().force.empty();
      points_[load ? point[world_.force_column()] : Rational(0)].push_back(point);
    }
  }
}

StatementJudge::Point StatementJudge::random_point() {
  Point result;
  for (std::size_t i = 0; i <= world_.constant_column(); ++i) {
    result.emplace_back(static_cast<int>(dice_.below(200)) - 100, static_cast<int>(dice_.below(20)) + 1);
  }
  return result;
}

StatementJudge::Point StatementJudge::completed(const Reading& reading, const StatementValues& values) const {
  std::vector<std::size_t> sought, order;
  Point point(world_.constant_column() + 1);
  if (!world_.setting().force.empty()) point[world_.force_column()] = values.value(world_.setting().force);
  for (std::size_t i = 0; i < world_.unknowns().size(); ++i) {
    const bool given =
        std::find(reading.known.begin(), reading.known.end(), world_.unknowns()[i]) != reading.known.end();
    if (given) point[i] = values.value(world_.unknowns()[i]);
    if (!given) sought.push_back(i);
  }
  order = sought;
  for (const std::size_t column : first_columns(world_.constant_column())) {
    if (std::find(sought.begin(), sought.end(), column) == sought.end()) order.push_back(column);
  }
  return Echelon(hypotheses_, order).solution(point, sought);
}

}  // namespace slipproof::meaning
