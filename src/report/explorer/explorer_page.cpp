#include "report/explorer/explorer_page.hpp"

#include <string_view>

#include "base/input/diagnostic.hpp"
#include "base/output/json.hpp"
#include "base/output/percent.hpp"
#include "report/explorer/inside_script.hpp"
#include "report/explorer/portable_scene.hpp"

namespace slipproof {

namespace {

constexpr std::string_view given_element = "<script type=\"application/json\" id=\"given\">null</script>";

Json portable_json(const MechanismScene& scene) {
  const PortableScene given = portable(scene);
  return {{"scene", given.scene}, {"mechanism", given.mechanism}, {"along", given.along}, {"file", given.file}};
}

}  // namespace

std::string explorer_page(const std::string& built, const std::string& file, const MechanismScene& scene) {
  const std::size_t at = built.find(given_element);
  if (at == std::string::npos) throw InputError({{file, 0, 0, "found another file, expected the explorer's page"}});
  std::string page = built;
  page.replace(at + given_element.find("null"), 4, inside_script(json_text(portable_json(scene))));
  return page;
}

std::string explorer_link(const std::string& page, const MechanismScene& scene) {
  return page + "#scene:=" + percent_encoded(json_text(portable_json(scene)));
}

}  // namespace slipproof
