#include <pybind11/stl.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "claims/reading/read_claims_file.hpp"
#include "contact/impact/solve_impact.hpp"
#include "contact/space/search_space.hpp"
#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/scene/narrow.hpp"
#include "proofs/check/files.hpp"
#include "proofs/check_contact/files.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/statement/statement_text.hpp"
#include "report/papers/verify_report.hpp"
#include "report/uniqueness/search_report.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;

struct Report {
  std::string json, text, summary;
};

/// A text has no folder with certificates.
Report verified(const std::string& path, const std::optional<std::string>& text, VerifyOptions options, Call& call) {
  const std::filesystem::path claims(path);
  const ClaimsFile file = text ? parse_claims(*text, path) : read_claims(claims);
  if (!text) options.certificates = std::make_shared<Certificates>(paper_folder(claims));
  options.progress = [&call](std::uint64_t done, std::uint64_t all) { call.at(done, all); };
  const VerifyResult result = verify(file, options);
  return {verify_json(file, result), text_of(verify_document(file, result)),
          std::string(summary_word(summary(file, result)))};
}

py::tuple verify_claims(const std::string& path, const std::optional<std::string>& text, std::uint64_t samples,
                        std::optional<std::uint64_t> lines, std::uint64_t seed, const std::string& only,
                        unsigned threads, const py::object& progress) {
  VerifyOptions options;
  options.samples = samples;
  options.lines = lines;
  options.seed = seed;
  options.only = only;
  options.threads = threads;
  const Report report = interruptible([=](Call& call) { return verified(path, text, options, call); }, progress);
  return py::make_tuple(report.json, report.text, report.summary);
}

/// `file`: none for a formula.
py::dict prove_text(const std::optional<std::string>& file, const std::string& text, std::uint64_t steps,
                    const py::object& progress) {
  const ProofOutcome outcome = interruptible(
      [=](Call& call) {
        prove::Limits limits;
        limits.steps = steps;
        limits.tick = [&call, steps](std::uint64_t done) { call.at(done, steps); };
        return file ? prove_statement(*file, text, limits) : prove_formula(text, limits);
      },
      progress);
  py::dict counterexample, result;
  for (const auto& [name, value] : outcome.counterexample) counterexample[py::str(name)] = value.str();
  result["theorem"] = outcome.theorem;
  result["statement"] = file ? text : formula_statement(text);
  result["verdict"] = std::string(name(outcome.verdict));
  result["certificate"] = outcome.certificate;
  result["vacuous"] = outcome.vacuous;
  result["counterexample"] = std::move(counterexample);
  result["left_with"] = outcome.leftover;
  result["exhausted"] = outcome.exhausted;
  result["steps"] = outcome.steps;
  return result;
}

py::tuple check(const std::vector<std::string>& paths) {
  const auto report = interruptible([paths](Call&) { return check::check_files(paths); });
  py::list results;
  for (const check::FileResult& r : report.results) {
    results.append(py::make_tuple(r.certificate.string(), std::string(to_string(r.verdict)), r.theorem, r.message));
  }
  return py::make_tuple(std::move(results), report.text, report.summary);
}

Report search_report(const std::string& name, const std::optional<std::string>& text, const std::string& within,
                     const MechanismRequest& request, SearchOptions options, Call& call) {
  Mechanism mechanism = mechanism_to_search(mechanism_of(name, text, request), options);
  if (!within.empty()) mechanism = narrowed(mechanism, within, "within");
  options.progress = [&call](std::uint64_t done, std::uint64_t all) { call.at(done, all); };
  MotionSearch search(mechanism, options);
  const SearchReport report = searched(mechanism, options, within, search, solve_impact);
  return {search_json(report), text_of(search_document(report)), std::string(slipproof::name(verdict(report)))};
}

py::tuple search(const std::string& name, const std::optional<std::string>& text, const std::string& within,
                 std::optional<std::uint64_t> samples, std::uint64_t seed, const std::optional<std::string>& wanted,
                 bool hysteresis, const std::optional<std::string>& law, unsigned threads, const py::object& progress) {
  SearchOptions options;
  options.samples = samples;
  options.seed = seed;
  options.threads = threads;
  options.hysteresis = hysteresis;
  if (wanted) options.wanted = parse_search_for(*wanted);
  MechanismRequest request = Dimensions::any;
  if (law) request.impact = ImpactRequest{parse_impact_law(*law)};
  const Report report =
      interruptible([=](Call& call) { return search_report(name, text, within, request, options, call); }, progress);
  return py::make_tuple(report.json, report.text, report.summary);
}

}  // namespace

void bind_papers(py::module_& module) {
  module.def("verify", &verify_claims);
  module.def("prove", &prove_text);
  module.def("check", &check);
  module.def("search", &search);
}

}  // namespace slipproof::python
