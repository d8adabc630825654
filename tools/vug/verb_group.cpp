// SPDX-License-Identifier: Apache-2.0
#include "verb_group.h"
#include "arguments.h"

#include <fmt/format.h>

#include <map>
#include <memory>

namespace vug::cli {
namespace {

[[noreturn]] void refuse(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  throw unknown_verb_error(word, names, app.get_name());
}

}  // namespace

Verb verb_group(std::string name, std::string doc, std::vector<Verb> verbs) {
  return {std::move(name), std::move(doc), [verbs = std::move(verbs)](CLI::App& app) {
            using Runs = std::map<const CLI::App*, std::function<int()>>;
            auto runs = std::make_shared<Runs>();
            // Collects unknown words so that they can be reported.
            auto unknown = std::make_shared<std::vector<std::string>>();
            app.add_option("verb", *unknown)->group("")->expected(0, 1000);
            app.require_subcommand(0, 1);
            for (const Verb& verb : verbs) {
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
