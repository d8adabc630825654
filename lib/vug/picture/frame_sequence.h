// Pictures of a scene that moves: which frames, and under which names.
#pragma once

#include <vug/picture/picture.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::picture {

/// The frames of "7", "1..24" (24 included), "1..24x2" (every second) or several of these with
/// commas, in this order, each once. Error(bad_input) for anything else and beyond 100,000 frames.
std::vector<int> parse_frames(const std::string& text);

/// The path with the frame's number in place of a row of # (as many digits at least) or of %d or
/// %04d, of which its file name has exactly one; Error(bad_input) otherwise.
std::filesystem::path frame_path(const std::filesystem::path& pattern, int frame);
/// Whether the path says where the frame's number goes; else all frames share the file.
bool has_frame_number(const std::filesystem::path& pattern);

/// Whether `exr` and the PNG beside it are the picture that the shot and the options would give,
/// as far as its header tells: made of the same texts with the same settings by this version. False
/// for what is missing or no picture.
bool is_finished(const std::filesystem::path& exr, const shot::Shot& shot,
                 const PictureOptions& options);

}  // namespace vug::picture
