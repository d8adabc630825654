// SPDX-License-Identifier: Apache-2.0
// Parses the command line of the program vug, reports unknown options and surplus words, and runs
// the chosen verb.
#include "arguments.h"
#include "error_report.h"
#include "progress_bar.h"
#include "verb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/base/diagnostics.h>
#include <vug/loading/plugin.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>
#include <new>
#include <optional>
#include <system_error>

namespace vug::cli {

#define VUG_VERB(name) Verb name##_verb();
#include <verbs.inc>
#undef VUG_VERB

namespace {

std::vector<Verb> verbs() {
  return {
#define VUG_VERB(name) name##_verb(),
#include <verbs.inc>
#undef VUG_VERB
  };
}

/// The fault of an option's value, or an empty string. Empty values are rejected, because an unset
/// variable of a script produces them, and so are values that begin with the = of "-o=file", which
/// is not valid for short options.
std::string value_fault(std::string& text) {
  if (text.empty()) return "the value is empty";
  return text.starts_with('=') ? fmt::format("'{}' begins with '='; remove it", text) : "";
}

/// Checks the values of all options of the command and its subcommands, before their ranges.
void validate_values(CLI::App& command) {
  for (CLI::Option* option : command.get_options())
    option->transform(CLI::Validator(value_fault, ""));
  for (CLI::App* below : command.get_subcommands(nullptr)) {
    below->fallthrough();
    validate_values(*below);
  }
}

std::vector<std::string> verb_names() {
  std::vector<std::string> names;
  for (const Verb& verb : verbs()) names.push_back(verb.name);
  return names;
}

/// Throws if the first argument is neither an option nor a verb.
void require_verb(const std::optional<std::string>& first) {
  const std::vector<std::string> names = verb_names();
  const std::string word = first.value_or("");
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw unknown_verb_error(word, names);
}

/// Names of the options of a command, of its groups and of its parent commands.
std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  const auto add = [&](const CLI::App& from) {
    for (const CLI::Option* option : from.get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  };
  for (const CLI::App* at = &command; at; at = at->get_parent()) {
    add(*at);
    for (const CLI::App* group : at->get_subcommands(nullptr))
      if (group->get_name().empty()) add(*group);
  }
  return names;
}

/// The error for arguments that the command does not take.
Error unexpected_argument_error(const CLI::App& app) {
  const CLI::App* command = &app;
  std::string called = app.get_name();
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    called += " " + command->get_name();
  }
  const std::vector<std::string> words = app.remaining(true);
  const auto option = std::find_if(words.begin(), words.end(),
                                   [](const std::string& word) { return word.starts_with('-'); });
  const std::string help = fmt::format("'{} --help' lists its options", called);
  if (option == words.end())
    return Error(ErrorCode::bad_input,
                 words.size() == 1
                     ? fmt::format("unexpected argument: '{}'", words.front())
                     : fmt::format("unexpected arguments: '{}'", fmt::join(words, "', '")),
                 {}, help);
  const std::string name = option->substr(0, option->find('='));
  return Error(ErrorCode::bad_input, fmt::format("unknown option '{}'", name), {},
               did_you_mean(name, option_names(*command), help));
}

/// Throws an Error for an option that has too many values or too few of them.
void require_value_counts(const CLI::ParseError& error) {
  const std::string text = error.what();
  if (const size_t name = text.find(": At Most 1 required"); name != std::string::npos)
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' is given several times", text.substr(0, name)), {},
                "it takes one value");
  const auto* mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error);
  if (const size_t name = text.find(':'); mismatch && text.ends_with(" missing"))
    throw Error(ErrorCode::bad_input, fmt::format("'{}' has no value", text.substr(0, name)), {},
                "write the value after the option");
}

/// The error for a command line whose verb is missing, or unknown and preceded by options.
Error missing_verb_error(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining();
  if (words.empty()) return unknown_verb_error("", verb_names());
  return words.front().starts_with('-') ? unexpected_argument_error(app)
                                        : unknown_verb_error(words.front(), verb_names());
}

/// Loads the plugins of $VUG_PLUGIN_PATH. One that cannot be loaded causes a warning only: a scene
/// that needs its kinds fails with an error of its own.
void load_plugins_in_path() {
  for (const auto& plugin : loading::plugins_in_path()) try {
      loading::load_plugin(plugin);
    } catch (const Error& error) {
      print_warning(error, "it is ignored, because it was only found through $VUG_PLUGIN_PATH");
    }
}

int run(int argc, char** argv) {
  require_verb(argc > 1 ? std::optional<std::string>(argv[1]) : std::nullopt);
  CLI::App app(
      "Grows film-grade caves from grammars: turns a scene text into VDB files, meshes and "
      "pictures.",
      "vug");
  app.set_version_flag("--version", "vug " VUG_VERSION);
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("error: {}\nhint: see 'vug --help' and 'vug VERB --help'\n", error.what());
  });
  app.footer(
      "'vug VERB --help' describes a verb. Exit codes: 0 done, 1 the answer is no, 2 unusable "
      "input, 3 failure.");
  std::vector<std::string> plugins;
  app.add_option("--plugin", plugins, "Plugin to load in addition to those in $VUG_PLUGIN_PATH")
      ->take_all()
      ->allow_extra_args(false);
  std::map<const CLI::App*, std::function<int()>> runs;
  for (const Verb& verb : verbs()) {
    CLI::App* command = app.add_subcommand(verb.name, verb.doc)->fallthrough();
    runs[command] = verb.setup(*command);
    validate_values(*command);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    throw unexpected_argument_error(app);
  } catch (const CLI::ParseError& error) {
    const bool lacks = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    if (lacks && app.get_subcommands().empty()) throw missing_verb_error(app);
    require_value_counts(error);
    return app.exit(error) == 0 ? kDone : kUnusable;
  }
  load_plugins_in_path();
  for (const std::string& plugin : plugins) loading::load_plugin(plugin);
  return runs.at(app.get_subcommands().at(0))();
}

/// Flushes the results and returns the exit code. A full disk may become visible only here.
int flush_results(int exit) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return exit;
  fmt::print(stderr, "error: cannot write to the standard output: {}\n", std::strerror(errno));
  return kFailed;
}

}  // namespace
}  // namespace vug::cli

int main(int argc, char** argv) {
  using namespace vug;
  cli::install_signal_handlers();
  try {
    return cli::flush_results(cli::run(argc, argv));
  } catch (const cli::ExitRequest& stop) {
    return cli::flush_results(stop.exit);
  } catch (const Error& error) {
    return cli::print_error(error);
  } catch (const std::bad_alloc&) {
    std::fputs("error: out of memory\nhint: use a larger voxel or fewer pixels\n", stderr);
    return cli::kFailed;
  } catch (const std::system_error& error) {  // thrown by fmt::print
    fmt::print(stderr, "error: cannot write to the standard output: {}\n", error.code().message());
    return cli::kFailed;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return cli::kFailed;
  }
}
