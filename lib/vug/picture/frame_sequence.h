// SPDX-License-Identifier: Apache-2.0
// Frame ranges and file names of image sequences, and the frames that are already finished.
#pragma once

#include <vug/picture/picture_plan.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::picture {

/// Parses "7", "1..24" (24 included), "1..24x2" (every second frame), or several of these separated
/// by commas, in this order. Error(bad_input) for other texts, repeated frames, and more than
/// 100,000 frames.
std::vector<int> parse_frames(const std::string& text);

/// The path with the frame number in place of a run of # (the minimum number of digits), %d or
/// %04d. Error(bad_input) unless the file name contains exactly one of these.
std::filesystem::path frame_path(const std::filesystem::path& pattern, int frame);
/// Whether the path has a place for the frame number; else all frames share the file.
bool has_frame_number(const std::filesystem::path& pattern);

/// Whether `exr` and the PNG next to it are, according to their header, the picture of the shot and
/// the plan: the same texts, settings and version. False for missing files and for other files.
bool is_finished(const std::filesystem::path& exr, const shot::Shot& shot, const PicturePlan& plan);

}  // namespace vug::picture
