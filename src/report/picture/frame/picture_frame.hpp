// What is around the drawing of a picture: its box, a heading, a caption; and the SVG file in which it stands.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "report/markup/element.hpp"
#include "report/picture/labels/label_placer.hpp"

namespace slipproof {

/// The box of all that is drawn, which grows with each part.
class PictureFrame {
 public:
  static constexpr double widest = 456;  ///< between the labels on the left and the right

  /// `share`: of the width that pictures have at least.
  explicit PictureFrame(const Element& svg, double share = 1) : svg_(svg), share_(share) {}

  void begin(const LabelBox& box) { box_ = box; }
  void see(const LabelBox& box) { box_ = box_.around(box); }
  void see(Point p) { see(LabelBox{p[0], p[1], p[0], p[1]}); }

  /// Two lines of text above the drawing; one where the second is empty.
  void heading(const std::string& name, const std::string& below);
  /// The pieces, joined to lines below the drawing.
  void caption(const std::vector<std::string>& pieces);

  const LabelBox& drawn() const { return box_; }
  /// With a margin, and at least as wide as others.
  LabelBox box() const;

 private:
  const Element svg_;
  double share_;
  LabelBox box_;
};

std::string view_box(const LabelBox& box);

/// An SVG file with a title, a background and the styles of pictures; `draw` fills it, and returns what its description
/// says and its box, which is drawn larger by `scale`.
struct DrawnPicture {
  std::string description;
  LabelBox box;
};
std::string picture_file(const std::string& title, double scale,
                         const std::function<DrawnPicture(const Element&)>& draw, const std::string& more_style = {});

}  // namespace slipproof
