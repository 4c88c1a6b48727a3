#include "report/explorer/space_page.hpp"

#include <string_view>

#include "report/explorer/inside_script.hpp"
#include "report/explorer/turned/assets.hpp"
#include "report/picture/palette.hpp"
#include "report/picture/space/space_svg.hpp"

namespace slipproof {

namespace {

void put(std::string& page, std::string_view mark, std::string_view text) {
  page.replace(page.find(mark), mark.size(), text);
}

}  // namespace

std::string space_page(const SolvedSpace& solved) {
  std::string page(assets::page_html);
  put(page, "@style@", picture_style() + space_style());
  put(page, "@turn@", assets::turn_js);
  put(page, "@page@", assets::page_js);
  put(page, "@scene@", inside_script(space_model_json(solved)));
  return page;
}

}  // namespace slipproof
