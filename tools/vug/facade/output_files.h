// What verbs of facades write and say beside their results.
#pragma once

#include "scene_options.h"

#include <vug/image/image.h>
#include <vug/scan/range_image.h>

#include <filesystem>
#include <string>

namespace vug::cli {

/// How a file is named from another folder, as in a drawing over a picture.
std::string relative_path_from(const std::filesystem::path& folder,
                               const std::filesystem::path& file);

/// A name that the texts of scenes can use for a grammar, of what people call files.
std::string valid_grammar_name(const std::string& text);

/// Builds and writes the volumes of a facade that is carved, with its recipe. Error(bad_input)
/// where its scene cannot be used, after that was told.
void write_carving(const loading::Loaded& loaded, const WorkOptions& work,
                   const std::filesystem::path& vdb);

/// What speaks against a facade in a scan, on stderr.
void print_quality_warnings(const scan::PointCloud& cloud, const scan::PlaneFit& plane,
                            const scan::RangeImage& range);

}  // namespace vug::cli
