// Builds a table from the contents of a file.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/files/words.hpp"
#include "records/tables/table.hpp"

namespace slipproof {

class TableBuilder {
 public:
  explicit TableBuilder(std::string file) { table_.file = std::move(file); }

  [[noreturn]] void fail(const std::string& message) const { refuse(table_.file, message); }
  void refuse_names(const std::vector<std::string>& names) const {
    if (!names.empty()) fail("found columns that have names, expected no other ones from --columns");
  }

  /// Adds a part with this number of items; messages use its name.
  std::size_t add_part(std::unique_ptr<ByteRun> run, std::size_t item, std::uint64_t items, const std::string& name) {
    constexpr std::size_t widest = 1U << 20U;
    if (item > widest) fail(name + ": found items of " + std::to_string(item) + " bytes, expected at most 1048576");
    table_.parts.push_back({std::move(run), item, false, {}});
    sizes_.emplace_back(items, name);
    return table_.parts.size() - 1;
  }
  void add_column(TableColumn column) { table_.columns.push_back(std::move(column)); }

  /// If there are longer or empty parts, parts with a single item are constants; all others must have the same number
  /// of items.
  Table finish() {
    if (table_.columns.empty() || sizes_.empty()) fail("found no column, expected a table with the numbers of records");
    std::size_t first = 0;
    while (first + 1 < sizes_.size() && sizes_[first].first == 1) ++first;
    for (std::size_t k = 0; k < sizes_.size(); ++k) {
      const auto& [items, name] = sizes_[k];
      if (items == sizes_[first].first) continue;
      if (items != 1) {
        fail(name + ": found " + std::to_string(items) + " items, expected " + std::to_string(sizes_[first].first) +
             " as in " + sizes_[first].second + ", or one for all");
      }
      table_.parts[k].constant = true;
    }
    table_.rows = sizes_[first].first;
    read_constants();
    return std::move(table_);
  }

 private:
  void read_constants() {
    for (TablePart& part : table_.parts) {
      if (!part.constant) continue;
      part.value.resize(part.item);
      part.run->read(part.value.data(), part.item);
    }
  }

  Table table_;
  std::vector<std::pair<std::uint64_t, std::string>> sizes_;
};

}  // namespace slipproof
