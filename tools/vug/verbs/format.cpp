#include "verb.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/scene/format.h>

namespace vug::cli {
namespace {

struct Options {
  std::vector<std::string> files;
  bool check = false;
  bool write = false;
};

int run(const Options& options) {
  int exit = kDone;
  for (const std::string& file : options.files) {
    const std::string text = read_text(file);
    const std::string formatted = scene::format(text);
    if (options.check && formatted != text) {
      fmt::print("{}: not formatted\n", file);
      exit = kAnswerNo;
    }
    if (options.write && formatted != text) write_text(file, formatted);
    if (!options.check && !options.write) fmt::print("{}", formatted);
  }
  return exit;
}

}  // namespace

Verb format_verb() {
  return {"format", "Puts a scene's spaces and columns in order.", [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            app.add_option("files", options->files, "scenes")->required();
            app.add_flag("--check", options->check, "only tell which files would change (exit 1)");
            app.add_flag("--write,-w", options->write, "change the files instead of printing");
            return [options] { return run(*options); };
          }};
}

}  // namespace vug::cli
