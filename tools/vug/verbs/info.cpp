#include "print.h"
#include "verb.h"

#include <vug/delivery/describe_file.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

struct Options {
  std::string file;
  bool json = false;
};

}  // namespace

Verb info_verb() {
  return {"info", "Tells what is in a .vdb, picture, mesh, table, part of a picture or checkpoint.",
          [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            app.add_option("file", options->file, "the file")->required();
            app.add_flag("--json", options->json, "for programs, with whole texts");
            return [options] {
              print_report(delivery::describe_file(options->file), options->json);
              return kDone;
            };
          }};
}

}  // namespace vug::cli
