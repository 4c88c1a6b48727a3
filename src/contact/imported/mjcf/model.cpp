#ifdef SLIPPROOF_MJCF

#include "contact/imported/mjcf/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <list>
#include <set>

#include "base/input/text_file.hpp"

namespace slipproof::imported {

namespace {

constexpr std::size_t max_size = std::size_t{16} << 20U;

/// Tags that show or measure. MuJoCo itself refuses what it does not know, so that all others are read.
const std::vector<std::string_view> seen_only{"visual", "statistic", "texture", "material", "skin", "camera", "light",
                                              "sensor", "size",      "custom",  "numeric",  "text", "tuple"};

void say_nothing(const char*) {}

/// All files of a model in memory, under names of their own.
class ModelFiles {
 public:
  ModelFiles(const ReadOptions& options, Scene& scene, Mistakes& mistakes)
      : options_(options), scene_(scene), mistakes_(mistakes) {}

  Model load(TaggedFile& file) {
    folder_ = std::filesystem::path(file.file()).parent_path();
    take(file);
    if (!mistakes_.empty()) return nullptr;
    read_meshes();
    if (meshes_left_out_ > 0) {
      scene_.import_notes.push_back(
          fmt::format("left out: meshes, as --without-meshes says ({} files)", meshes_left_out_));
    }
    if (!mistakes_.empty()) return nullptr;
    // What later versions of MuJoCo take for granted, and its files therefore: a range is a limit.
    if (!has_auto_limits_) file.root().prepend_child("compiler").append_attribute("autolimits") = "true";
    files_.insert(files_.begin(), {"scene.xml", file.rest()});
    std::size_t number = 0;
    for (const TaggedFile& one : included_) files_.emplace_back(included_name(number++), one.rest());
    std::string why;
    Model model = model_of(files_, why);
    if (!model) mistakes_.add(file.place(file.root()), "MuJoCo: " + why);
    return model;
  }

 private:
  static std::string included_name(std::size_t i) { return fmt::format("included{}.xml", i); }

  /// Takes out what is only seen, and puts what a file includes in memory.
  void take(TaggedFile& file) {
    Scene of_included;
    file.check({{}, seen_only, {}, true}, included_.empty() ? scene_ : of_included, mistakes_);
    visit(file, file.root());
  }

  /// Leaves the attributes of a tag that say what the scene is; others say how it is computed, and later versions of
  /// MuJoCo have ones that this one does not know.
  static void keep_attributes(pugi::xml_node node, const std::vector<std::string_view>& kept) {
    for (pugi::xml_attribute one = node.first_attribute(), next; one; one = next) {
      next = one.next_attribute();
      if (std::ranges::find(kept, std::string_view(one.name())) == kept.end()) node.remove_attribute(one);
    }
  }

  void visit(TaggedFile& file, pugi::xml_node node) {
    const std::string_view own = node.name();
    if (own == "option") keep_attributes(node, words_of("gravity density viscosity wind timestep"));
    if (own == "flag") {
      keep_attributes(node,
                      words_of("constraint equality frictionloss limit contact passive gravity clampctrl actuation "
                               "filterparent"));
    }
    node.remove_attribute("material");
    for (pugi::xml_node child = node.first_child(), next; child; child = next) {
      next = child.next_sibling();
      if (child.type() != pugi::node_element) continue;
      const std::string_view tag = child.name();
      if (tag == "include") {
        include(file, child);
        continue;
      }
      if (tag == "compiler") {
        has_auto_limits_ = has_auto_limits_ || child.attribute("autolimits");
        for (const char* name : {"meshdir", "texturedir"}) {
          if (std::string_view(name) == "meshdir" && child.attribute(name))
            mesh_folder_ = child.attribute(name).value();
          child.remove_attribute(name);
        }
      } else if ((tag == "mesh" || tag == "hfield") && child.attribute("file")) {
        meshes_.emplace_back(&file, child);
      } else if (tag == "geom" && options_.without_meshes && child.attribute("mesh")) {
        ++meshes_left_out_;
        node.remove_child(child);
        continue;
      }
      visit(file, child);
    }
  }

  void include(TaggedFile& file, pugi::xml_node node) {
    const std::filesystem::path path = folder_ / node.attribute("file").value();
    try {
      if (!names_.insert(path.string()).second) throw InputError({{file.file(), 0, 0, "is included twice"}});
      included_.emplace_back(read_text_file(path, max_size), path.string());
      node.attribute("file") = included_name(included_.size() - 1).c_str();
      take(included_.back());
      if (!included_.back().root().first_child()) node.parent().remove_child(node);  // only what is seen
    } catch (const std::exception& error) {  // of another type beyond this module
      mistakes_.add(file.place(node), std::string("found an included file that cannot be read: ") + error.what());
    }
  }

  void read_meshes() {
    const std::filesystem::path folder = folder_ / mesh_folder_;
    for (auto& [file, node] : meshes_) {
      const std::string wanted = node.attribute("file").value();
      if (options_.without_meshes && std::string_view(node.name()) == "mesh") {
        node.parent().remove_child(node);
        continue;
      }
      const std::filesystem::path path = folder / wanted;
      std::ifstream stream(path, std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
      if (bytes.empty() || bytes.rfind("version https://git-lfs", 0) == 0) {
        mistakes_.add(file->place(node), "found the file " + in_quotes(wanted) +
                                             ", which cannot be read, expected it at " + in_quotes(path.string()) +
                                             " (--without-meshes leaves meshes out)");
        continue;
      }
      if (!node.attribute("name")) node.append_attribute("name") = path.stem().c_str();
      files_.emplace_back(fmt::format("file{}{}", files_.size(), path.extension().string()), bytes);
      node.attribute("file") = files_.back().first.c_str();
    }
  }

  const ReadOptions& options_;
  Scene& scene_;
  Mistakes& mistakes_;
  std::filesystem::path folder_, mesh_folder_;
  std::list<TaggedFile> included_;
  std::set<std::string> names_;
  std::vector<std::pair<TaggedFile*, pugi::xml_node>> meshes_;
  std::vector<std::pair<std::string, std::string>> files_;  ///< by the names that they have in memory
  std::size_t meshes_left_out_ = 0;
  bool has_auto_limits_ = false;
};

}  // namespace

Model model_of(const std::vector<std::pair<std::string, std::string>>& files, std::string& why) {
  mju_user_warning = say_nothing;  // or it writes a file of its own
  const auto memory = std::make_unique<mjVFS>();
  mj_defaultVFS(memory.get());
  bool fits = true;
  for (const auto& [name, bytes] : files) {
    fits = fits && mj_makeEmptyFileVFS(memory.get(), name.c_str(), static_cast<int>(bytes.size())) == 0;
    if (fits) std::memcpy(memory->filedata[mj_findFileVFS(memory.get(), name.c_str())], bytes.data(), bytes.size());
  }
  std::array<char, 1000> error{};
  Model model;
  if (fits) model.reset(mj_loadXML(files.front().first.c_str(), memory.get(), error.data(), error.size()));
  // From the last on: MuJoCo 2.2.2 does not end where one is deleted that has others behind it.
  for (auto file = files.rbegin(); file != files.rend(); ++file) mj_deleteFileVFS(memory.get(), file->first.c_str());
  why = fits ? error.data() : "found more files than it holds in memory";
  return model;
}

Model load_model(TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes) {
  return ModelFiles(options, scene, mistakes).load(file);
}

}  // namespace slipproof::imported

#endif
