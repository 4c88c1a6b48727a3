#include "report/engines/engine_pages.hpp"

#include <fmt/format.h>

#include "report/engines/engine_sections.hpp"
#include "report/html/frame.hpp"

namespace slipproof {

void write_engine_pages(const EngineResults& results, const std::string& folder, const std::string& version,
                        const std::string& explorer, const PageSink& write) {
  const JudgedEngines& judged = results.judged;
  const EnginePageInput input{
      results, engine_classes(judged), engine_rows(judged), engine_thresholds(results), folder, explorer, write};
  const auto page = [&](const std::string& title, const std::string& description, const std::string& up,
                        const std::function<void(const Element&)>& fill) {
    std::vector<std::pair<std::string, std::string>> links{{up + "index.html", "Engines"}};
    for (const std::string& name : input.classes) links.emplace_back(up + name + ".html", class_title(name));
    PageFrame frame{"slipproof: " + title, version, std::move(links),
                    "Made by slipproof " + version + " from recorded answers. Each page says how to ask again."};
    frame.brand = up + "index.html";
    frame.description = description;
    frame.script = search_script;
    return framed(frame, fill);
  };
  const std::string all = fmt::format("What {} physics engines answer to {} scenes whose motions are known exactly.",
                                      judged.engines.size(), judged.scenes.size());
  write("index.html", page("Engines, tested against the truth", all, "",
                           [&](const Element& main) { add_engines_index(main, input); }));
  for (const std::string& name : input.classes) {
    write(name + ".html",
          page(class_title(name), all, "", [&](const Element& main) { add_class_page(main, input, name); }));
  }
  for (std::size_t i = 0; i < judged.scenes.size(); ++i) {
    const EngineScene& scene = judged.scenes[i];
    write(scene.name + ".html", page(scene.scene.name, scene.scene.question, "../",
                                     [&](const Element& main) { add_scene_page(main, input, i); }));
  }
}

}  // namespace slipproof
