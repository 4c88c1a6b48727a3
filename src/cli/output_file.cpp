#include "cli/output_file.hpp"

#include <utility>

#include "input/diagnostic.hpp"

namespace slipproof::cli {

namespace {

InputError cannot_write(const std::filesystem::path& path) {
  return InputError({{path.string(), 0, 0, "cannot be written"}});
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  keep_ = std::filesystem::exists(path_, error);
  stream_.open(path_, std::ios::binary | std::ios::app);
  if (!stream_) throw cannot_write(path_);
}

OutputFile::~OutputFile() {
  if (keep_) return;
  stream_.close();
  std::error_code error;
  std::filesystem::remove(path_, error);
}

void OutputFile::write(std::string_view contents) {
  std::error_code error;
  // Neither a pipe nor a device has a size.
  if (std::filesystem::is_regular_file(path_, error)) std::filesystem::resize_file(path_, 0, error);
  stream_ << contents;
  if (error || !stream_.flush()) throw cannot_write(path_);
  keep_ = true;
}

}  // namespace slipproof::cli
