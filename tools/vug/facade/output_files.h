// SPDX-License-Identifier: Apache-2.0
// Output files and warnings shared by the verbs of `vug facade`.
#pragma once

#include "scene_options.h"

#include <vug/image/image.h>
#include <vug/scan/range_image.h>
#include <vug/session/facade_model.h>

#include <filesystem>
#include <string>

namespace vug::cli {

using session::relative_path_from;
using session::valid_grammar_name;

/// Builds and writes the volumes of a carved facade, with their recipe. Error(bad_input) if its
/// scene has errors, which are printed first.
void write_carving(const loading::Loaded& loaded, const WorkOptions& work,
                   const std::filesystem::path& vdb);

/// Prints warnings to stderr if a scan is unsuitable for a facade.
void print_quality_warnings(const scan::PointCloud& cloud, const scan::PlaneFit& plane,
                            const scan::RangeImage& range);

}  // namespace vug::cli
