// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "print.h"
#include "verb.h"

#include <vug/delivery/describe_file.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

struct InfoOptions {
  std::string file;
  bool json = false;
};

}  // namespace

Verb info_verb() {
  return {"info", "Describes a .vdb, picture, mesh, table, partial render or checkpoint.",
          [](CLI::App& app) {
            auto options = std::make_shared<InfoOptions>();
            app.add_option("file", options->file, "File to describe")->required();
            app.add_flag("--json", options->json, "Machine-readable output with complete strings");
            return [options] {
              require_no_scene(options->file);
              print_report(delivery::describe_file(options->file), options->json);
              return kDone;
            };
          }};
}

}  // namespace vug::cli
