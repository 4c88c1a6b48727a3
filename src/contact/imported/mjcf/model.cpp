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
  ModelFiles(const ReadOptions& options, std::vector<std::string>& import_notes, Mistakes& mistakes)
      : options_(options), notes_(import_notes), mistakes_(mistakes), memory_(std::make_unique<mjVFS>()) {
    mj_defaultVFS(memory_.get());
  }
  ~ModelFiles() {
    for (int i = memory_->nfile - 1; i >= 0; --i) mj_deleteFileVFS(memory_.get(), memory_->filename[i]);
  }
  ModelFiles(const ModelFiles&) = delete;
  ModelFiles& operator=(const ModelFiles&) = delete;

  Model load(TaggedFile& file) {
    folder_ = std::filesystem::path(file.file()).parent_path();
    take(file);
    if (!mistakes_.empty()) return nullptr;
    read_meshes();
    if (meshes_left_out_ > 0) {
      notes_.push_back(fmt::format("left out: meshes, as --without-meshes says ({} files)", meshes_left_out_));
    }
    if (!mistakes_.empty()) return nullptr;
    const char* name = "scene.xml";
    if (!keep(name, file.rest())) mistakes_.add({}, "found a file beyond what MuJoCo holds in memory");
    for (std::size_t i = 0; i < included_.size(); ++i) keep(included_name(i), std::next(included_.begin(), static_cast<long>(i))->rest());
    mju_user_warning = say_nothing;  // or it writes a file of its own
    std::array<char, 1000> error{};
    Model model(mj_loadXML(name, memory_.get(), error.data(), static_cast<int>(error.size())));
    if (!model) mistakes_.add(file.place(file.root()), std::string("MuJoCo: ") + error.data());
    return model;
  }

 private:
  static std::string included_name(std::size_t i) { return fmt::format("included{}.xml", i); }

  bool keep(const std::string& name, const std::string& bytes) {
    if (mj_makeEmptyFileVFS(memory_.get(), name.c_str(), static_cast<int>(bytes.size())) != 0) return false;
    std::memcpy(memory_->filedata[mj_findFileVFS(memory_.get(), name.c_str())], bytes.data(), bytes.size());
    return true;
  }

  /// Takes out what is only seen, and puts what a file includes in memory.
  void take(TaggedFile& file) {
    const std::vector<std::string> left_out = file.check({{}, seen_only, true}, mistakes_);
    if (included_.empty()) notes_.insert(notes_.end(), left_out.begin(), left_out.end());
    visit(file, file.root());
  }

  void visit(TaggedFile& file, pugi::xml_node node) {
    node.remove_attribute("material");
    for (pugi::xml_node child = node.first_child(), next; child; child = next) {
      next = child.next_sibling();
      if (child.type() != pugi::node_element) continue;
      const std::string_view tag = child.name();
      if (tag == "include") {
        include(file, child);
      } else if (tag == "compiler") {
        for (const char* name : {"meshdir", "texturedir"}) {
          if (std::string_view(name) == "meshdir" && child.attribute(name)) mesh_folder_ = child.attribute(name).value();
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
      const std::string name = fmt::format("file{}{}", files_++, path.extension().string());
      if (!keep(name, bytes)) mistakes_.add(file->place(node), "found more files than MuJoCo holds in memory");
      node.attribute("file") = name.c_str();
    }
  }

  const ReadOptions& options_;
  std::vector<std::string>& notes_;
  Mistakes& mistakes_;
  std::unique_ptr<mjVFS> memory_;
  std::filesystem::path folder_, mesh_folder_;
  std::list<TaggedFile> included_;
  std::set<std::string> names_;
  std::vector<std::pair<TaggedFile*, pugi::xml_node>> meshes_;
  std::size_t files_ = 0, meshes_left_out_ = 0;
};

}  // namespace

Model load_model(TaggedFile& file, const ReadOptions& options, std::vector<std::string>& import_notes,
                 Mistakes& mistakes) {
  return ModelFiles(options, import_notes, mistakes).load(file);
}

}  // namespace slipproof::imported

#endif
