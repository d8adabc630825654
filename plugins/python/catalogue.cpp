// SPDX-License-Identifier: Apache-2.0
// The kinds of the scene language, from their schemas.
#include "binding.h"

#include <vug/base/diagnostics.h>
#include <vug/loading/catalogue.h>
#include <vug/loading/plugin.h>
#include <nlohmann/json.hpp>

namespace vug::python {
namespace {

py::list as_list(const std::vector<const KindInfo*>& kinds) {
  nlohmann::ordered_json json = loading::catalogue_json(kinds);
  for (size_t k = 0; k < kinds.size(); ++k)
    for (size_t p = 0; p < kinds[k]->params.size(); ++p)
      json[k]["params"][p]["text"] = loading::describe(kinds[k]->params[p]);
  return from_json<py::list>(json.dump());
}

}  // namespace

void bind_catalogue(py::module_& module) {
  module.def(
      "load_plugin", &loading::load_plugin, "file"_a,
      "Loads a plugin, a shared library with additional kinds. Call it before loading a scene.\n"
      "Plugins in the folders of $VUG_PLUGIN_PATH are loaded by `import vug`.");
  module.def("plugins_in_path", &loading::plugins_in_path, "Plugins that `import vug` loads.");
  module.def(
      "find_kinds", [](const std::string& word) { return as_list(loading::find_kinds(word)); },
      "word"_a = "",
      "The output of `vug list WORD --json`: kinds of that name, category or family, or all.\n"
      "Each parameter has an additional entry 'text' with its type, range and default.");
  module.def(
      "search_kinds", [](const std::string& text) { return as_list(loading::search_kinds(text)); },
      "text"_a, "The kinds whose descriptions or synonyms contain all words of the text.");
  module.def("kind_words", &loading::kind_words, "Words that find_kinds accepts.");
  module.def("suggestion", &suggestion, "name"_a, "candidates"_a,
             "A sentence that suggests the nearest candidate.");
}

}  // namespace vug::python
