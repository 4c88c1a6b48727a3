// Documents of elements, HTML and SVG: a tree that is escaped when it is written, so that no text can become markup.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace pugi {
class xml_document;
struct xml_node_struct;
}  // namespace pugi

namespace slipproof {

/// One element of an ElementTree: a handle, cheap to copy, valid as long as the tree. Setters return the element.
class Element {
 public:
  /// Adds a last child.
  Element add(const char* name) const;
  /// Adds a last child with a class.
  Element add(const char* name, std::string_view css_class) const;
  Element set(const char* attribute, std::string_view value) const;
  Element set(const char* attribute, int value) const;
  /// Sets a length in a picture, with at most two decimals.
  Element set(const char* attribute, double value) const;
  /// Adds text after the present content. Characters that XML cannot contain (control characters, broken UTF-8) become
  /// U+FFFD.
  Element text(std::string_view text) const;
  /// Sets the contents of a script or a style unchanged, in a form that HTML and XML both understand. Throws
  /// std::invalid_argument for code that would end its own element.
  Element code(std::string_view code) const;
  /// Adds a copy of another element, of this document or another, as the last child.
  Element add(const Element& other) const;
  /// Adds copies of the element's children.
  Element add_children_of(const Element& other) const;
  /// The element as XML, without a declaration.
  std::string xml() const;

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
  /// The document with the document type of HTML 5; it is also well-formed XML.
  std::string html() const;
  /// The document as an XML file in UTF-8.
  std::string xml() const;

 private:
  std::unique_ptr<pugi::xml_document> tree_;
};

}  // namespace slipproof
