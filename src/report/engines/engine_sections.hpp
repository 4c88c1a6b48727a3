// The parts of the pages about engines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/engines/engine_cells.hpp"
#include "report/engines/engine_pages.hpp"

namespace slipproof {

/// What all pages are made from.
struct EnginePageInput {
  const EngineResults& results;
  std::vector<std::string> classes;
  std::vector<EngineRow> rows;
  std::vector<EngineThresholdRow> thresholds;
  const std::string& folder;    ///< what the user calls it
  const std::string& explorer;  ///< the explorer's page; empty: there is none
  const PageSink& write;

  const JudgedEngines& judged() const { return results.judged; }
  /// A number of an engine that differs from rigid contacts on purpose says so.
  ReportCell with_design(const std::string& engine, ReportCell cell) const;
};

/// The first section of a page, with its title.
Element add_title(const Element& main, const std::string& kicker, const std::string& title);
/// The signs and colours of the verdicts.
void add_key(const Element& top);

void add_engines_index(const Element& main, const EnginePageInput& input);
void add_class_page(const Element& main, const EnginePageInput& input, const std::string& name);
void add_scene_page(const Element& main, const EnginePageInput& input, std::size_t scene);

}  // namespace slipproof
