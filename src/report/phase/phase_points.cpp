#include "report/phase/phase_points.hpp"

#include <algorithm>
#include <map>

#include "base/number/binary64.hpp"
#include "report/values/mode_json.hpp"

namespace slipproof {

namespace {

PhasePoint::Motion motion_at(const MotionOverLoads& motion, const std::vector<MotionQuantity>& quantities,
                             const Rational& load) {
  PhasePoint::Motion found{modes_in_order(motion), !motion.modes.empty(), {}};
  for (const MotionQuantity& q : quantities) {
    const std::optional<Affine<Rational>> value =
        q.is_force ? motion.forces[q.index] : std::optional(motion.accelerations[q.index]);
    found.values.push_back(value ? std::optional(value->at(load)) : std::nullopt);
  }
  return found;
}

/// Values that occur often, each written once.
class Listed {
 public:
  std::size_t index(Json value) {
    const auto [found, is_new] = indices_.emplace(json_text(value), all_.size());
    if (is_new) all_.push_back(std::move(value));
    return found->second;
  }
  const Json& all() const { return all_; }

 private:
  Json all_ = Json::array();
  std::map<std::string, std::size_t> indices_;
};

}  // namespace

std::vector<PhasePoint> sample_points(const PhaseDiagram& diagram, std::size_t across, std::size_t up) {
  std::vector<const PhaseColumn*> even;
  for (const PhaseColumn& column : diagram.columns) {
    if (column.even && column.x != diagram.plane.x.from && column.x != diagram.plane.x.to) even.push_back(&column);
  }
  const Axis& y = diagram.plane.y;
  const std::size_t step = std::max<std::size_t>(1, even.size() / std::max<std::size_t>(across, 1));
  std::vector<PhasePoint> points;
  for (std::size_t i = step / 2; i < even.size(); i += step) {
    PhaseColumn column;
    column.cells = diagram.plane.numbers(even[i]->x);
    for (std::size_t j = 0; j < up; ++j) {
      const Rational load = y.from + (y.to - y.from) * Rational(2 * j + 1) / Rational(2 * up);
      const LoadCell* cell = find_cell(column, load);
      if (cell == nullptr) continue;
      PhasePoint point{even[i]->x, load, {}, cell->continua};
      for (const MotionOverLoads& motion : cell->motions) {
        point.motions.push_back(motion_at(motion, diagram.plane.quantities, load));
      }
      points.push_back(std::move(point));
    }
  }
  return points;
}

std::string points_json(const PhaseDiagram& diagram, const std::vector<PhasePoint>& points) {
  const Axis &x = diagram.plane.x, &y = diagram.plane.y;
  const auto share = [](const Rational& value, const Axis& axis) {
    return nearest_binary64((value - axis.from) / (axis.to - axis.from));
  };
  Listed xs, ys, modes;
  Json names = Json::array(), list = Json::array();
  for (const MotionQuantity& quantity : diagram.plane.quantities) names.push_back(quantity.name);
  for (const PhasePoint& point : points) {
    Json motions = Json::array();
    for (const PhasePoint::Motion& found : point.motions) {
      Json values = Json::array();
      for (const auto& value : found.values) {
        values.push_back(!value ? Json(nullptr) : value->is_zero() ? Json(0) : to_json(*value));
      }
      motions.push_back({modes.index({names_json(found.modes), found.strict}), std::move(values)});
    }
    list.push_back({xs.index({share(point.x, x), to_json(point.x)}), ys.index({share(point.y, y), to_json(point.y)}),
                    std::move(motions), names_json(point.continua)});
  }
  const Json document{{"x", x.symbol},  {"y", y.symbol},        {"names", std::move(names)}, {"xs", xs.all()},
                      {"ys", ys.all()}, {"modes", modes.all()}, {"points", std::move(list)}};
  std::string text;
  for (const char c : document.dump(-1, ' ', true, nlohmann::detail::error_handler_t::replace)) {
    text += c == '<' ? "\\u003c" : c == '&' ? "\\u0026" : c == '>' ? "\\u003e" : std::string(1, c);
  }
  return text;
}

}  // namespace slipproof
