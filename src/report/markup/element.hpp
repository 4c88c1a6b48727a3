// Documents of elements, HTML and SVG: a tree that is written out escaped, so that no text can become markup.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace pugi {
class xml_document;
struct xml_node_struct;
}  // namespace pugi

namespace slipproof {

/// One element of a ElementTree: a handle, cheap to copy, good for as long as the document is. Setters return it.
class Element {
 public:
  /// A new last child.
  Element add(const char* name) const;
  /// The same with a class.
  Element add(const char* name, std::string_view css_class) const;
  Element set(const char* attribute, std::string_view value) const;
  Element set(const char* attribute, int value) const;
  /// A length in a picture, with two decimals at most.
  Element set(const char* attribute, double value) const;
  /// Text after what is already there. What XML cannot hold (control characters, broken UTF-8) becomes U+FFFD.
  Element text(std::string_view text) const;
  /// The contents of a script or a style, as they are, in a form that HTML and XML both understand. Throws
  /// std::invalid_argument for code that would end its own element.
  Element code(std::string_view code) const;
  /// A copy of another element, of this document or another, as the last child.
  Element add(const Element& other) const;
  /// Copies of its children.
  Element add_children_of(const Element& other) const;

 private:
  friend class ElementTree;
  explicit Element(pugi::xml_node_struct* node) : node_(node) {}
  pugi::xml_node_struct* node_;
};

class ElementTree {
 public:
  explicit ElementTree(const char* root);
  ~ElementTree();
  ElementTree(ElementTree&&) noexcept;
  ElementTree& operator=(ElementTree&&) noexcept;

  Element root() const;
  /// With the document type of HTML 5; at the same time well-formed XML.
  std::string html() const;
  /// An XML file, UTF-8.
  std::string xml() const;

 private:
  std::unique_ptr<pugi::xml_document> tree_;
};

}  // namespace slipproof
