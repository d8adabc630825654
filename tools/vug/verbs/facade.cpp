// SPDX-License-Identifier: Apache-2.0
// `vug facade VERB ...`: each verb is a file in facade/ and a line in CMakeLists.txt.
#include "arguments.h"
#include "verb.h"

#include <fmt/format.h>

#include <map>
#include <memory>

namespace vug::cli {

#define VUG_FACADE_VERB(name) Verb facade_##name##_verb();
#include <facade_verbs.inc>
#undef VUG_FACADE_VERB

namespace {

[[noreturn]] void refuse(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  throw unknown_verb_error(word, names, app.get_name());
}

}  // namespace

Verb facade_verb() {
  return {"facade", "Reconstructs and models facades from pictures and scans.", [](CLI::App& app) {
            using Runs = std::map<const CLI::App*, std::function<int()>>;
            auto runs = std::make_shared<Runs>();
            // Collects unknown words so that they can be reported.
            auto unknown = std::make_shared<std::vector<std::string>>();
            app.add_option("verb", *unknown)->group("")->expected(0, 1000);
            app.require_subcommand(0, 1);
            for (const Verb& verb : {
#define VUG_FACADE_VERB(name) facade_##name##_verb(),
#include <facade_verbs.inc>
#undef VUG_FACADE_VERB
                 }) {
              CLI::App* command = app.add_subcommand(verb.name, verb.doc);
              (*runs)[command] = verb.setup(*command);
            }
            return [&app, runs, unknown] {
              if (app.get_subcommands().empty())
                refuse(app, unknown->empty() ? "" : unknown->front());
              if (!unknown->empty())
                throw Error(ErrorCode::bad_input,
                            fmt::format("unexpected argument: '{}'", unknown->front()));
              return runs->at(app.get_subcommands().at(0))();
            };
          }};
}

}  // namespace vug::cli
