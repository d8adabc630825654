// Everything a scene can say, from the schemas of its kinds.
#include "binding.h"

#include <vug/base/diagnostics.h>
#include <vug/loading/catalogue.h>
#include <vug/loading/plugin.h>
#include <nlohmann/json.hpp>

namespace vug::python {
namespace {

py::list kinds_for_python(const std::string& word) {
  const std::vector<const KindInfo*> kinds = loading::find_kinds(word);
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
      "Loads a plugin, a shared library with further kinds; before the first scene. Those in\n"
      "the folders of $VUG_PLUGIN_PATH are loaded by `import vug`.");
  module.def("plugins_in_path", &loading::plugins_in_path, "Those that `import vug` loads.");
  module.def("find_kinds", &kinds_for_python, "word"_a = "",
             "What `vug list WORD --json` prints: kinds of that name, category or family, or all;\n"
             "and of each parameter its type, range and default in a line, 'text'.");
  module.def("kind_words", &loading::kind_words, "Words that find_kinds knows.");
  module.def("suggestion", &suggestion, "name"_a, "candidates"_a,
             "A sentence that offers the nearest candidate.");
}

}  // namespace vug::python
