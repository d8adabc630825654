// SPDX-License-Identifier: Apache-2.0
#include "output_files.h"

#include "progress_bar.h"

#include <fmt/format.h>
#include <vug/delivery/write_products.h>
#include <vug/image/io.h>
#include <vug/scan/quality_warnings.h>

#include <cstdio>

namespace vug::cli {

namespace fs = std::filesystem;

void write_carving(const loading::Loaded& loaded, const WorkOptions& work, const fs::path& vdb) {
  if (!loaded.usable()) {
    fmt::print(stderr, "{}", loaded.report());
    throw Error(ErrorCode::bad_input, "the facade cannot be carved");
  }
  building::Builder builder(loaded.shot, work.build_options(loaded),
                            terminal_progress(work.bar_mode()));
  delivery::write_volumes(builder, vdb);
}

void print_quality_warnings(const scan::PointCloud& cloud, const scan::PlaneFit& plane,
                            const scan::RangeImage& range) {
  for (const scan::QualityWarning& doubt : scan::quality_warnings(cloud, plane, range)) {
    clear_progress_bar();
    fmt::print(stderr, "warning: {}\nhint: {}\n", doubt.message, doubt.hint);
  }
}

}  // namespace vug::cli
