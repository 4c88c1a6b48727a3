// The report for people: one HTML file that needs no other files, no network and no script.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "claims/planes/figures.hpp"
#include "claims/reading/source_lines.hpp"
#include "claims/uniqueness/scene_along.hpp"
#include "claims/verify/verify.hpp"
#include "floating/trade/trade.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/html/second_opinions.hpp"
#include "report/html/solvers.hpp"

namespace slipproof {

/// A file that the page was made from.
struct PageSource {
  std::string name;
  std::string sha256;  ///< in hexadecimal
};

/// A statement, and what the checker says about its certificate.
struct PageCertificate {
  std::string theorem, file;
  std::string statement;  ///< its text
  CertificateState state = CertificateState::missing;
  std::string message;  ///< why it is not accepted
};

struct PageInput {
  const ClaimsFile* claims = nullptr;
  const VerifyResult* result = nullptr;  ///< the verification that the page is about
  std::string command;                   ///< the command that makes the page again
  std::string version;
  std::string gallery;   ///< a link to the page of all papers; empty: there is none
  std::string explorer;  ///< a link to the explorer's page (src/faces/explorer); empty: there is none
  std::string image;     ///< as in PageFrame
  std::vector<Figure> figures;
  std::vector<PageCertificate> certificates;
  std::optional<SecondOpinions> opinions;  ///< by theorem of `certificates`
  std::optional<MechanismScene> model;     ///< the bicycle of the labelled figure
  std::vector<MechanismScene> scenes;      ///< for each, a plane of its friction and load is drawn
  std::vector<SceneAlong> machines;  ///< the paper's scenes, with the friction from which on they have several motions
  std::vector<SolverVerdicts> solvers;
  std::optional<Trade> trade;
  std::optional<SourceLines> source;  ///< the text that was judged, if it is beside the claims file
  std::vector<PageSource> sources;
};

/// The files that the parts of a report come from. A part that is not given is left out.
struct PageFolders {
  std::filesystem::path
      claims;  ///< the claims file; figures.toml, certificates/ and second-opinions.csv are in its folder
  std::filesystem::path model;    ///< the scene of the labelled figure
  std::filesystem::path cases;    ///< scenes
  std::filesystem::path solvers;  ///< recorded outputs of solvers, CSV
  std::filesystem::path trade;    ///< a file that `slipproof trade --json` wrote
};

/// The files that gather() reads.
std::vector<std::filesystem::path> files_of(const PageFolders& folders, const ClaimsFile& claims);

/// Makes all input but the result: reads the files and certifies the solvers' outputs. `certificates` are those in the
/// claims' folder. File names are relative to the folders, so that the page does not depend on their location. Throws
/// InputError.
PageInput gather(const PageFolders& folders, const ClaimsFile& claims, Certificates& certificates);

/// The page as HTML 5. The same input gives the same bytes.
std::string page_html(const PageInput& input);

}  // namespace slipproof
