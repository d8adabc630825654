// `vug facade VERB ...`: one file each in facade/, listed in CMakeLists.txt.
#include "verb.h"

#include <map>
#include <memory>

namespace vug::cli {

#define VUG_FACADE_VERB(name) Verb facade_##name##_verb();
#include <facade_verbs.inc>
#undef VUG_FACADE_VERB

Verb facade_verb() {
  return {"facade", "Reads facades out of pictures and scans.", [](CLI::App& app) {
            using Runs = std::map<const CLI::App*, std::function<int()>>;
            auto runs = std::make_shared<Runs>();
            app.require_subcommand(1);
            for (const Verb& verb : {
#define VUG_FACADE_VERB(name) facade_##name##_verb(),
#include <facade_verbs.inc>
#undef VUG_FACADE_VERB
                 }) {
              CLI::App* command = app.add_subcommand(verb.name, verb.doc);
              (*runs)[command] = verb.setup(*command);
            }
            return [&app, runs] { return runs->at(app.get_subcommands().at(0))(); };
          }};
}

}  // namespace vug::cli
