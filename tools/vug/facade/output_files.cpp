// SPDX-License-Identifier: Apache-2.0
#include "output_files.h"

#include "progress_bar.h"

#include <fmt/format.h>
#include <vug/delivery/write_products.h>
#include <vug/image/io.h>
#include <vug/scan/quality_warnings.h>
#include <vug/scene/check.h>

#include <cctype>
#include <cstdio>
#include <set>

namespace vug::cli {

namespace fs = std::filesystem;

std::string relative_path_from(const fs::path& folder, const fs::path& file) {
  return fs::absolute(file)
      .lexically_normal()
      .lexically_relative(fs::absolute(folder).lexically_normal())
      .generic_string();
}

std::string valid_grammar_name(const std::string& text) {
  static const std::set<std::string> taken = {"main", "even", "voxel", "stone", "panes"};
  std::string out;
  for (const char c : text) out += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  if (out.empty() || !std::isalpha(static_cast<unsigned char>(out[0])) || taken.count(out) ||
      !scene::may_name(out))
    out = "facade_" + out;
  return out;
}

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
