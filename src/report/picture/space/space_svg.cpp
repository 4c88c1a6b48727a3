#include "report/picture/space/space_svg.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/input/diagnostic.hpp"
#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "report/markup/symbol.hpp"
#include "report/picture/frame/panels.hpp"
#include "report/picture/labels/contact_table.hpp"
#include "report/picture/palette.hpp"
#include "report/picture/space/scenery.hpp"
#include "report/picture/space/space_arrows.hpp"

namespace slipproof {

namespace {

constexpr double space_width = 330, space_height = 270, axes_room = 62, axes_length = 17;

/// What pictures of several motions share.
class SpacePicture {
 public:
  SpacePicture(const MechanismScene& scene, const std::vector<SpaceMotion>& motions, const Vec3& from,
               bool is_virtual = false)
      : scene_(scene),
        is_virtual_(is_virtual),
        geometry_(space_geometry(scene)),
        numbers_(scene, motions),
        view_(from, geometry_.up),
        scenery_(geometry_, from) {
    const std::vector<Vec3> corners = scenery_.corners();
    if (corners.empty()) {
      throw InputError({{scene.mechanism.file, 0, 0,
                         "the mechanism " + scene.mechanism.name +
                             " has no picture, expected a body with a shape, or a contact that has a place"}});
    }
    sizes_.see(geometry_);
    for (const SpaceMotion& motion : motions) sizes_.see(scene, geometry_, motion);
    fit(corners);
  }

  const SpaceNumbers& numbers() const { return numbers_; }
  const std::set<SpaceSign>& signs() const { return signs_; }

  /// What a page needs to draw the same from other directions, without motions.
  Json model() const {
    Json model{{"up", geometry_.up}, {"size", room()}, {"scale", view_.scale()}};
    model["corners"] = scenery_.corners();
    for (const char* key : {"pieces", "sticks", "joints"}) model[key] = Json::array();
    for (const Scenery::Piece& piece : scenery_.pieces()) model["pieces"].push_back(piece_json(piece));
    for (const auto& stick : geometry_.sticks) model["sticks"].push_back({stick.from, stick.to});
    for (const auto& joint : geometry_.joints) {
      model["joints"].push_back({{"at", joint.at},
                                 {"to", joint.to},
                                 {"axes", joint.axes},
                                 {"mark", mark_of(joint.kind)},
                                 {"css", line_of(joint.kind)}});
    }
    return model;
  }
  /// The same of a motion.
  Json model(const SpaceMotion& motion) const {
    const ElementTree scratch("svg");
    PictureLabels labels;
    SpaceArrows arrows(scratch.root(), {scene_, &motion, geometry_, numbers_, view_, sizes_, lettered(), is_virtual_},
                       labels);
    arrows.draw();
    Json model{{"heading", heading_of(motion)}, {"kind", kind_of(motion)}};
    model["rows"] = contact_rows(scene_, &motion, numbers_, lettered());
    for (const char* key : {"strokes", "labels"}) model[key] = Json::array();
    for (const SpaceStroke& stroke : arrows.strokes()) model["strokes"].push_back(stroke_json(stroke));
    for (const SpaceLabel& label : arrows.labels()) {
      model["labels"].push_back({{"anchor", label.anchor}, {"at", label.at}, {"text", label.text}});
    }
    return model;
  }

  /// Scenery, arrows, labels, axes and the table of contacts; returns what they are in words.
  std::vector<std::string> draw(const Element& svg, const SpaceMotion* motion, PictureFrame& frame) {
    PictureLabels labels;
    labels.keep_between(-PictureFrame::widest / 2, PictureFrame::widest / 2);
    frame.begin(box_);
    scenery_.draw(svg, view_, labels);
    SpaceArrows arrows(svg, {scene_, motion, geometry_, numbers_, view_, sizes_, lettered(), is_virtual_}, labels);
    arrows.draw();
    for (const Point& end : arrows.ends()) frame.see(end);
    signs_.insert(arrows.signs().begin(), arrows.signs().end());
    if (scenery_.shows_shadows(view_)) signs_.insert(SpaceSign::shadow);
    name_parts(labels);
    for (const LabelBox& box : labels.draw(svg)) frame.see(box);
    below(svg, motion, frame);
    return arrows.described();
  }

 private:
  static Json piece_json(const Scenery::Piece& piece) {
    const Solid& solid = piece.solid;
    Json json{{"corners", solid.corners}, {"extent", extent(solid.corners)}, {"floor", piece.floor}};
    for (const char* key : {"faces", "edges"}) json[key] = Json::array();
    json["shadows"] = piece.shadows;
    for (const auto& face : solid.faces) json["faces"].push_back({{"corners", face.corners}, {"normal", face.normal}});
    for (const auto& edge : solid.edges) {
      json["edges"].push_back({{"from", edge.from}, {"to", edge.to}, {"faces", edge.faces}, {"smooth", edge.smooth}});
    }
    return json;
  }
  static Json stroke_json(const SpaceStroke& stroke) {
    constexpr std::array<const char*, 5> kinds{"arrow", "area", "cone", "turn", "dot"};
    return {{"kind", kinds[static_cast<std::size_t>(stroke.kind)]},
            {"anchor", stroke.anchor},
            {"points", stroke.points},
            {"css", stroke.css},
            {"dashes", dashes_of(stroke.line)}};
  }

  bool lettered() const { return scene_.mechanism.contacts.size() >= fewest_lettered; }
  std::array<double, 2> room() const {
    return lettered() ? std::array{lettered_width, lettered_height} : std::array{space_width, space_height};
  }

  void fit(const std::vector<Vec3>& corners) {
    LabelBox all{1e300, 1e300, -1e300, -1e300};
    for (const Vec3& corner : corners) {
      const Point p = view_.flat(corner);
      all = all.around({p[0], p[1], p[0], p[1]});
    }
    const double across = all.right - all.left, up = all.bottom - all.top;
    double scale = 1;
    if (across > 0 || up > 0) {
      const auto [width, height] = room();
      scale = std::min(across > 0 ? width / across : height / up, up > 0 ? height / up : width / across);
    }
    view_.fit({(all.left + all.right) / 2, (all.top + all.bottom) / 2}, scale);
    box_ = {-scale * across / 2, -scale * up / 2, scale * across / 2, scale * up / 2};
  }

  /// Bodies where there are several, and joints, unless there are many.
  void name_parts(PictureLabels& labels) const {
    constexpr std::size_t most = 6, most_joints = 2;
    if (geometry_.bodies.size() > 1 && geometry_.bodies.size() <= most) {
      for (const auto& body : geometry_.bodies) labels.words({view_.pixel(body.at)}, body.name);
    }
    if (geometry_.joints.size() > most_joints) return;
    for (const auto& joint : geometry_.joints) labels.words({view_.pixel(joint.at)}, joint.name);
  }

  /// The axes of the scene, and beside them the table.
  void below(const Element& svg, const SpaceMotion* motion, PictureFrame& frame) const {
    const double left = frame.drawn().left, top = frame.drawn().bottom + 6;
    axes(svg, {left + axes_room / 2 - 4, top + axes_room / 2});
    auto rows = contact_rows(scene_, motion, numbers_, lettered());
    for (auto& row : rows) {
      if (is_virtual_) row.resize(2);
    }
    if (!rows.empty())
      frame.see(add_text_table(svg, rows, {left + axes_room, top + 4}, PictureFrame::widest - axes_room));
    frame.see(LabelBox{left, top, left + axes_room, top + axes_room});
  }
  void axes(const Element& svg, Point at) const {
    const Element group = svg.add("g", "axes");
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    const Point origin = view_.pixel({0, 0, 0});
    for (std::size_t i = 0; i < 3; ++i) {
      Vec3 axis{};
      axis[i] = axes_length / view_.scale();
      const Point end = view_.pixel(axis);
      const double dx = end[0] - origin[0], dy = end[1] - origin[1], size = std::hypot(dx, dy);
      if (size < 3) continue;
      group.add("line", "frame").set("x1", at[0]).set("y1", at[1]).set("x2", at[0] + dx).set("y2", at[1] + dy);
      const double away = (size + 7) / size;
      group.add("text", "soft")
          .set("x", at[0] + away * dx - 3)
          .set("y", at[1] + away * dy + 4)
          .set("font-size", 11)
          .text(names[i]);
    }
  }

  const MechanismScene& scene_;
  const bool is_virtual_;
  const SpaceGeometry geometry_;
  const SpaceNumbers numbers_;
  SpaceView view_;
  const Scenery scenery_;
  SpaceSizes sizes_;
  LabelBox box_;
  std::set<SpaceSign> signs_;
};

std::string single_file(const MechanismScene& scene, const SpaceMotion* motion, const Vec3& from,
                        const std::string& heading, bool is_virtual = false) {
  const std::vector<SpaceMotion> shown = motion == nullptr ? std::vector<SpaceMotion>{} : std::vector{*motion};
  SpacePicture picture(scene, shown, from, is_virtual);
  const std::string mode = !heading.empty() ? heading : motion == nullptr ? "" : heading_of(*motion);
  return picture_file(
      scene.name + (mode.empty() ? "" : ": " + mode), 1.6,
      [&](const Element& svg) {
        PictureFrame frame(svg);
        const std::vector<std::string> described = picture.draw(svg, motion, frame);
        std::vector<std::string> pieces;
        if (scene.mechanism.load && scene.load) pieces.push_back(load_text(scene, picture.numbers().words()));
        if (motion == nullptr) pieces.emplace_back("arrows show positive directions, not to scale");
        if (motion != nullptr && !kind_of(*motion).empty()) pieces.push_back(kind_of(*motion));
        frame.caption(pieces);
        const LabelBox drawn = frame.drawn();
        const double height = add_space_legend(svg, picture.signs(), {drawn.left, drawn.bottom + 8},
                                               PictureFrame::widest - 20, scene.mechanism.impact.has_value());
        frame.see(LabelBox{drawn.left, drawn.top, std::max(drawn.right, drawn.left + PictureFrame::widest - 20),
                           drawn.bottom + 8 + height});
        frame.heading(scene.name, mode);
        return DrawnPicture{fmt::format("{}.", fmt::join(described, "; ")), frame.box()};
      },
      space_style());
}

/// `F = 3 N, 2 motions`; of an impact outcomes.
std::string counted_in_space(const SolvedSpace& solved, const SpaceNumbers& numbers) {
  std::string text;
  if (solved.scene.mechanism.load && solved.scene.load) text = load_text(solved.scene, numbers.words()) + ", ";
  return text + counted_motions(solved);
}

}  // namespace

std::string space_svg_file(const MechanismScene& scene, const Vec3& from) {
  return single_file(scene, nullptr, from, {});
}

std::string space_svg_file(const SolvedSpace& solved, std::size_t motion, const Vec3& from,
                           const std::string& heading) {
  return single_file(solved.scene, &solved.motions[motion], from, heading);
}

std::string virtual_motion_svg_file(const MechanismScene& scene, const SpaceMotion& rates, const Vec3& from,
                                    const std::string& heading) {
  return single_file(scene, &rates, from, heading, true);
}

std::string space_model_json(const SolvedSpace& solved) {
  const SpacePicture picture(solved.scene, solved.motions, view_direction(usual_view));
  Json model = picture.model();
  model["name"] = solved.scene.name;
  model["counted"] = counted_in_space(solved, picture.numbers());
  model["from"] = Json::parse("[" + std::string(usual_view) + "]");
  model["motions"] = Json::array();
  for (const SpaceMotion& motion : solved.motions) model["motions"].push_back(picture.model(motion));
  return json_text(model);
}

std::string space_motions_svg_file(const SolvedSpace& solved, const Vec3& from) {
  SpacePicture picture(solved.scene, solved.motions, from);
  PanelSheet sheet{solved.scene.name, counted_in_space(solved, picture.numbers()), {}, 430};
  for (std::size_t i = 0; i < std::max<std::size_t>(solved.motions.size(), 1); ++i) {
    const SpaceMotion* const motion = i < solved.motions.size() ? &solved.motions[i] : nullptr;
    const std::string heading = motion == nullptr ? "" : fmt::format("{}: {}", i + 1, heading_of(*motion));
    sheet.panels.push_back({heading, motion == nullptr ? "" : kind_of(*motion),
                            [&, motion, heading](const Element& parent, LabelBox& seen) {
                              const Element svg = parent.add("svg", "mechanism").set("role", "img");
                              svg.add("title").text(motion == nullptr ? "no motion" : heading);
                              const Element description = svg.add("desc");
                              PictureFrame frame(svg);
                              description.text(fmt::format("{}.", fmt::join(picture.draw(svg, motion, frame), "; ")));
                              seen = frame.box();
                              return svg;
                            }});
  }
  sheet.legend = [&](const Element& svg, Point corner, double width) {
    return add_space_legend(svg, picture.signs(), corner, width, solved.scene.mechanism.impact.has_value());
  };
  sheet.more_style = space_style();
  return panels_svg_file(sheet);
}

}  // namespace slipproof
