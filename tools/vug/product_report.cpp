// SPDX-License-Identifier: Apache-2.0
#include "product_report.h"

#include "progress_bar.h"

#include <fmt/format.h>
#include <vug/loading/plugin.h>

namespace vug::cli {

building::StoreUse store_use(const loading::Loaded& loaded) {
  return building::user_store(loaded.sources.empty() ? "" : loaded.sources.front()->file,
                              loading::digest_of_plugins(), [](const std::string& why) {
                                clear_progress_bar();
                                fmt::print(
                                    stderr,
                                    "warning: the results cannot be stored for the next run: {}\n"
                                    "  hint: set VUG_CACHE to another folder, or use --no-cache\n",
                                    why);
                              });
}

std::string to_text(const building::ProductReport& report) {
  const std::string product = fmt::format("{} '{}'", report.kind, report.name);
  if (report.reused) return fmt::format("{}: reused, saves {:.1f} s", product, report.seconds);
  const std::string why = !report.changed ? "it was not built before"
                          : report.changed->empty()
                              ? "it took too little time to be stored, or has been removed"
                              : fmt::format("changed: {}", fmt::join(*report.changed, ", "));
  if (report.seconds > 0)
    return fmt::format("{}: built in {:.1f} s; {}", product, report.seconds, why);
  return fmt::format("{}: not in the store; {}", product, why);
}

}  // namespace vug::cli
