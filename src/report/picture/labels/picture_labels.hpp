// The labels of a picture, which are placed together once all that they should not cover is known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/markup/element.hpp"
#include "report/picture/labels/label_placer.hpp"

namespace slipproof {

class PictureLabels {
 public:
  void avoid(Point from, Point to, double weight) { placer_.avoid(from, to, weight); }
  void avoid(const LabelBox& box) { placer_.avoid(box); }
  void keep_between(double left, double right) { placer_.keep_between(left, right); }

  /// A symbol, set with its index, and its value; one of them may be empty.
  void symbol(const std::vector<Point>& near, const std::string& symbol, const std::string& value);
  /// What pushes: its name is set as a symbol where it is one, or a product of some.
  void push(const std::vector<Point>& near, const std::string& name, const std::string& value);
  void words(const std::vector<Point>& near, const std::string& words);

  /// Places and draws all labels, with lines to what they name where that is far; returns where they are.
  std::vector<LabelBox> draw(const Element& svg);

 private:
  static void lead(const Element& svg, const LabelBox& box, const std::vector<Point>& near);

  struct Text {
    double size;
    std::string_view css;
    std::string symbol, words;
  };
  std::vector<Text> texts_;
  std::vector<LabelPlacer::Label> labels_;  ///< of the texts
  LabelPlacer placer_;
};

}  // namespace slipproof
