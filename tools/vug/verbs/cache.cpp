// SPDX-License-Identifier: Apache-2.0
// vug cache: the store of finished products that builds and pictures share.
#include "arguments.h"
#include "print.h"
#include "product_report.h"
#include "scene_options.h"
#include "verb_group.h"

#include <fmt/format.h>
#include <vug/base/memory.h>
#include <vug/building/explain_products.h>
#include <vug/store/maintenance.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace vug::cli {
namespace {

using Json = nlohmann::ordered_json;

struct CacheOptions {
  bool json = false;
  std::string size;
  SceneOptions scene;
};

std::filesystem::path folder() {
  const std::filesystem::path out = store::default_folder();
  if (out.empty())
    throw Error(ErrorCode::bad_input, "the store is off: VUG_CACHE is 'off', or HOME is not set",
                {}, "set VUG_CACHE to a folder");
  return out;
}

int print_statistics(const CacheOptions& options) {
  const store::Store store({folder(), store::default_max_bytes()});
  const store::StoreStatistics statistics = store::statistics(store.folder());
  Json kinds = Json::object();
  for (const auto& [name, kind] : statistics.kinds)
    kinds[name] = {{"products", kind.products},
                   {"size", bytes_text(static_cast<double>(kind.bytes))},
                   {"bytes", kind.bytes},
                   {"seconds_to_make", kind.seconds}};
  print_report({{"folder", store.folder().string()},
                {"writable", store.is_writable()},
                {"size", bytes_text(static_cast<double>(statistics.bytes))},
                {"bytes", statistics.bytes},
                {"max_bytes", store.max_bytes()},
                {"files", statistics.files},
                {"kinds", std::move(kinds)}},
               options.json);
  return kDone;
}

int trim(const CacheOptions& options) {
  const store::Store store(
      {folder(), options.size.empty() ? store::default_max_bytes() : parse_bytes(options.size)});
  const store::TrimReport report = store::trim(store.folder(), store.max_bytes());
  print_report({{"removed_files", report.files}, {"removed_bytes", report.bytes}}, options.json);
  return kDone;
}

int verify(const CacheOptions& options) {
  const store::VerifyReport report = store::verify(folder());
  print_report({{"intact_files", report.intact}, {"removed_damaged_files", report.damaged}},
               options.json);
  return report.damaged == 0 ? kDone : kAnswerNo;
}

int print_reasons(const CacheOptions& options) {
  const loading::Loaded loaded = options.scene.load();
  for (const building::ProductReport& each :
       building::explain_products(loaded.shot, store_use(loaded)))
    fmt::print("{}\n", to_text(each));
  return kDone;
}

/// A verb that runs a function with the options that `add` declares.
Verb cache_command(const char* name, const char* doc, int (*run)(const CacheOptions&),
                   void (*add)(CLI::App&, CacheOptions&)) {
  return {name, doc, [run, add](CLI::App& app) {
            auto options = std::make_shared<CacheOptions>();
            add(app, *options);
            return [options, run] { return run(*options); };
          }};
}

void add_json(CLI::App& app, CacheOptions& options) {
  app.add_flag("--json", options.json, "JSON output");
}

void add_size(CLI::App& app, CacheOptions& options) {
  app.add_option("--size", options.size, "Size to keep, e.g. 5G; default: the limit of the store");
  add_json(app, options);
}

void add_scene(CLI::App& app, CacheOptions& options) { options.scene.add_to(app); }

}  // namespace

Verb cache_verb() {
  return verb_group(
      "cache", "Reports on the store of finished products, trims and verifies it.",
      {cache_command("stats", "Folder, size and kinds of the products", print_statistics, add_json),
       cache_command("trim", "Removes the products that were not used for the longest time", trim,
                     add_size),
       cache_command("verify",
                     "Reads all products and removes damaged ones; exit code 1 if there were",
                     verify, add_json),
       cache_command("why", "Lists the products of a scene that would be reused or built, and why",
                     print_reasons, add_scene)});
}

}  // namespace vug::cli
