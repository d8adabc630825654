// SPDX-License-Identifier: Apache-2.0
#include "verb.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/scene/format.h>
#include <vug/scene/parser.h>
#include <vug/scene/report.h>

namespace vug::cli {
namespace {

struct FormatOptions {
  std::vector<std::string> files;
  bool check = false;
  bool write = false;
};

/// Whether the text parses. A text with faults is not formatted; included files are not read, so
/// that their parameters are unknown.
bool parses(const std::string& text, const std::string& file) {
  Diagnostics diagnostics;
  scene::ParseOptions options;
  options.read = [](const std::filesystem::path&) { return std::optional<std::string>(""); };
  options.check_modules = false;
  const scene::Document document = scene::parse(text, file, diagnostics, options);
  fmt::print(stderr, "{}", scene::report(diagnostics, document.sources));
  return !diagnostics.has_errors();
}

int run_format(const FormatOptions& options) {
  int exit = kDone;
  for (const std::string& file : options.files) {
    const std::string text = read_text(file);
    if (!parses(text, file)) {
      exit = kUnusable;
      continue;
    }
    const std::string formatted = scene::format(text);
    if (options.check && formatted != text) {
      fmt::print("{}: not formatted\n", file);
      if (exit == kDone) exit = kAnswerNo;
    }
    if (options.write && formatted != text) write_text(file, formatted);
    if (!options.check && !options.write) fmt::print("{}", formatted);
  }
  return exit;
}

}  // namespace

Verb format_verb() {
  return {"format", "Formats the white space and columns of scene files.", [](CLI::App& app) {
            auto options = std::make_shared<FormatOptions>();
            app.add_option("files", options->files, "Scene files")->required();
            app.add_flag("--check", options->check,
                         "Only list the files that would change (exit code 1)");
            app.add_flag("--write,-w", options->write,
                         "Overwrite the files instead of printing them");
            return [options] { return run_format(*options); };
          }};
}

}  // namespace vug::cli
