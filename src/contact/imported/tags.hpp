// What stands in a file of XML, by its tags: each is read, exerts no force, or is refused. The formats' own parsers
// pass over what they do not know.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "contact/imported/scene.hpp"

namespace slipproof::imported {

/// The tags of one format.
struct Tags {
  std::vector<std::string_view> read;  ///< tags that are read, with their contents
  /// Tags that are ignored, with their contents: pictures, sensors, names of materials.
  std::vector<std::string_view> left_out;
  /// Tags that may exert a force: the mechanism in space leaves them out by name, the other ways refuse them.
  std::vector<std::string_view> only_in_space;
  bool reads_all_others = false;  ///< the format's own parser refuses what it does not know
};

/// The words of a text with single spaces.
std::vector<std::string_view> words_of(std::string_view text);

class TaggedFile {
 public:
  /// Parses a text. Throws InputError if it is not XML.
  TaggedFile(std::string text, std::string file);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& file() const { return file_; }
  const std::string& text() const { return text_; }

  /// Adds a mistake for each tag that is neither read nor left out, and takes those out of the document that are, with
  /// sentences about these in the scene.
  void check(const Tags& tags, Scene& scene, Mistakes& mistakes);

  Place place(const pugi::xml_node& node) const;
  /// The place of the first tag of this kind with this name; the beginning of the file if there is none.
  Place place(std::string_view tag, std::string_view name) const;
  /// The document as it is now.
  std::string rest() const;

 private:
  void check(pugi::xml_node node, const Tags& tags, Scene& scene, Mistakes& mistakes);

  std::string text_, file_;
  pugi::xml_document document_;
  std::map<std::string, std::vector<std::size_t>> left_out_;  ///< lines, by tag
};

}  // namespace slipproof::imported
