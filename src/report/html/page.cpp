#include "report/html/page.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/input/text_file.hpp"
#include "base/os/sha256.hpp"
#include "base/parallel/failure.hpp"
#include "claims/reading/paper_folder.hpp"
#include "claims/statements/claim_statements.hpp"
#include "proofs/check/files.hpp"
#include "proofs/statement/theorems.hpp"
#include "report/explorer/explorer_page.hpp"
#include "report/html/assets.hpp"
#include "report/html/sections.hpp"
#include "report/html/trade_data.hpp"

namespace slipproof {

namespace {

constexpr std::size_t longest_certificate = 1U << 28U;

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, std::string_view extension) {
  std::vector<std::filesystem::path> files;
  if (folder.empty()) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The names of the statements that the claims file asks for.
std::vector<std::string> asked_for(const ClaimsFile& claims) {
  std::vector<std::string> names;
  for (const Claim& claim : claims.claims) {
    for (const Reading reading : all_readings) {
      failure_of([&] {  // a claim that fails has no statements
        for (const auto& statement : expected_statements(claims, claim, reading)) names.push_back(statement.name);
      });
    }
  }
  return names;
}

class Gathering {
 public:
  explicit Gathering(PageInput& input) : input_(input) {}

  void source(const std::filesystem::path& file, const std::string& name) {
    input_.sources.push_back({name, sha256(read_found_file(file, longest_certificate))});
  }

  void certificates(Certificates& certificates) {
    for (const CheckedCertificate& checked : certificates.all()) {
      const std::string theorem = checked.theorem.empty() ? checked.name : checked.theorem;
      const std::string statement = certificates.statement(checked.name).value_or("");
      input_.certificates.push_back({theorem, checked.name + ".cert", statement, checked.state, checked.message});
      for (const char* ending : {".statement", ".cert"}) {
        const std::filesystem::path file = file_of(certificates.folder() / (checked.name + ending));
        const std::string name = "proofs/" + file.lexically_relative(certificates.folder()).generic_string();
        if (std::filesystem::is_regular_file(file) && sources_.insert(name).second) source(file, name);
      }
    }
  }

  /// Reads the opinions. The file may also cover statements of the claims that are missing; those are not shown here,
  /// but reported elsewhere.
  void second_opinions(const std::filesystem::path& file, const Certificates& certificates) {
    if (!std::filesystem::exists(file)) return;
    const auto statement_of = [](const PageCertificate& certificate) {
      return std::filesystem::path(certificate.file).replace_extension().generic_string();
    };
    std::vector<std::string> statements;
    for (const PageCertificate& certificate : input_.certificates) statements.push_back(statement_of(certificate));
    for (const std::string& name : asked_for(*input_.claims)) statements.push_back(certificates.of_claim(name));
    const SecondOpinions opinions = read_second_opinions(file, statements);
    input_.opinions.emplace();
    for (const PageCertificate& certificate : input_.certificates) {
      const auto found = opinions.find(statement_of(certificate));
      if (found != opinions.end()) input_.opinions->emplace(certificate.theorem, found->second);
    }
    source(file, "proofs/" + file.filename().string());
  }

 private:
  PageInput& input_;
  std::set<std::string> sources_;  ///< of the statements and certificates
};

PageFrame frame_of(const PageInput& input) {
  PageFrame frame{"slipproof: " + input.claims->paper.title, input.version, {}, {}};
  if (!input.gallery.empty()) frame.links.emplace_back(frame.brand = input.gallery, "All sources");
  const auto link = [&](bool there, const char* target, const char* words) {
    if (there) frame.links.emplace_back(target, words);
  };
  link(true, "#overview", "Overview");
  link(!input.figures.empty() || !input.scenes.empty(), "#phase", "Phase diagrams");
  link(!input.machines.empty(), "#machines", "Numbers");
  link(true, "#claims", "Claims");
  link(input.source.has_value(), "#source", "Source");
  link(true, "#errata", "Errata");
  link(!input.certificates.empty(), "#certificates", "Certificates");
  link(input.trade.has_value(), "#trade", "Speed");
  link(!input.solvers.empty(), "#solvers", "Solvers");
  link(!input.claims->paper.open.empty(), "#open", "Open");
  link(true, "#notation", "Notation");
  link(true, "#reproduce", "Reproduce");
  frame.footer = "Made by slipproof " + input.version + ". Every number that is not marked as rounded is exact.";
  frame.description = input.claims->paper.found;
  frame.image = input.image;
  frame.script = assets::script_js;
  return frame;
}

}  // namespace

std::vector<std::filesystem::path> files_of(const PageFolders& folders, const ClaimsFile& claims) {
  const PaperFolder paper = paper_folder(folders.claims);
  const std::filesystem::path& beside = paper.folder;
  std::vector<std::filesystem::path> files{folders.claims, beside / "figures.toml", beside / "second-opinions.csv"};
  if (!claims.paper.source.empty()) files.push_back(beside / claims.paper.source);
  for (const auto& file : {folders.trade, folders.model}) {
    if (!file.empty()) files.push_back(file);
  }
  for (const std::string& scene : claims.paper.scenes) files.push_back(beside / scene);
  for (std::filesystem::path file : check::certificates_in(beside)) {
    if (!paper.owns(file)) continue;
    files.push_back(file_of(file));
    files.push_back(file_of(file.replace_extension(".statement")));
  }
  for (auto&& some : {files_in(folders.cases, ".toml"), files_in(folders.solvers, ".csv")}) {
    files.insert(files.end(), some.begin(), some.end());
  }
  return files;
}

PageInput gather(const PageFolders& folders, const ClaimsFile& claims, Certificates& certificates) {
  PageInput input;
  input.claims = &claims;
  if (!folders.trade.empty()) input.trade = read_trade(folders.trade);
  Gathering gathering(input);
  gathering.source(folders.claims, folders.claims.filename().string());
  const PaperFolder paper = paper_folder(folders.claims);
  const std::filesystem::path& beside = paper.folder;
  input.source = read_source_lines(folders.claims, claims.paper);
  if (input.source) gathering.source(input.source->file, claims.paper.source);
  const std::filesystem::path figures = beside / "figures.toml";
  if (paper.is_main && std::filesystem::exists(figures)) {
    input.figures = read_figures(figures, claims);
    gathering.source(figures, "figures.toml");
  }
  gathering.certificates(certificates);
  if (paper.is_main) gathering.second_opinions(beside / "second-opinions.csv", certificates);
  if (!folders.model.empty()) input.model = read_scene(folders.model);
  for (const std::string& scene : claims.paper.scenes) {
    input.machines.push_back(read_scene_along(beside / scene));
    gathering.source(beside / scene, std::filesystem::path(scene).filename().string());
  }
  for (const auto& file : files_in(folders.cases, ".toml")) {
    input.scenes.push_back(read_scene(file));
    gathering.source(file, "cases/" + file.filename().string());
  }
  for (const auto& file : files_in(folders.solvers, ".csv")) {
    input.solvers.push_back(certify_solver(file));
    gathering.source(file, "solvers/" + file.filename().string());
  }
  if (!folders.trade.empty()) gathering.source(folders.trade, folders.trade.filename().string());
  return input;
}

std::string_view verdict_name(const ClaimResult& result) {
  return result.proved && result.verdict == Verdict::holds ? "proved" : name(result.verdict);
}

Element add_chip(const Element& parent, std::string_view verdict) {
  const std::array<std::pair<std::string_view, std::string_view>, 5> signs{
      {{"proved", "✓✓ "}, {"holds", "✓ "}, {"refuted", "✗ "}, {"undecided", "? "}, {"vacuous", "∅ "}}};
  const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& s) { return s.first == verdict; });
  return add_chip(parent, verdict, sign == signs.end() ? "" : sign->second, verdict);
}

Element add_chip(const Element& parent, std::string_view css_class, std::string_view sign, std::string_view text) {
  const Element chip = parent.add("span", "chip " + std::string(css_class));
  if (!sign.empty()) chip.add("span").set("aria-hidden", "true").text(sign);
  return chip.text(text);
}

void add_claim_id(const Element& parent, const PageInput& input, std::string_view id) {
  const auto& results = input.result->claims;
  const bool judged = std::any_of(results.begin(), results.end(),
                                  [&](const auto& r) { return input.claims->claims[r.claim].id == id; });
  if (!judged) {
    parent.text(id);
    return;
  }
  parent.add("a").set("href", "#claim-" + std::string(id)).text(id);
}

std::string link_to_explorer(const PageInput& input, const MechanismScene& scene) {
  return input.explorer.empty() ? "" : explorer_link(input.explorer, scene);
}

std::string page_html(const PageInput& input) {
  return framed(frame_of(input), [&](const Element& main) {
    for (const auto& add : {add_overview, add_phase_section, add_machines_section, add_claims_section,
                            add_source_section, add_errata_section, add_certificates_section, add_trade_section,
                            add_solvers_section, add_open_section, add_notation_section, add_reproduce_section}) {
      add(main, input);
    }
  });
}

}  // namespace slipproof
