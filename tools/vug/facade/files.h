// What verbs of facades write beside their results.
#pragma once

#include <vug/image/image.h>

#include <filesystem>
#include <string>

namespace vug::cli {

/// How a file is named from another folder, as in a drawing over a picture.
std::string seen_from(const std::filesystem::path& folder, const std::filesystem::path& file);

/// A PNG of the picture as it is: no view transform but sRGB, no dither.
void write_plain_png(const std::filesystem::path& file, const image::Image& picture);

}  // namespace vug::cli
