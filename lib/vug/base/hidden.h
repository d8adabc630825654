// What is written beside its target under a hidden name until it is whole, and what goes with it
// where that fails: names with the maker's process in them, and folders made on the way.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vug {

/// ".NAME.PROCESS.partEXTENSION", with the number of this process. The extension tells writers of
/// files the format.
std::string hidden_name(const std::string& name, const std::string& extension = "");

/// What the folder holds under such names whose process is gone, as seen from here: one of another
/// machine or outside a container may live. Nothing where the folder cannot be read.
std::vector<std::filesystem::path> left_by_the_dead(const std::filesystem::path& folder,
                                                    const std::string& name,
                                                    const std::string& extension = "");

/// Makes the folder and those above it that are not there, and returns these, the innermost first.
/// Error(io) where one cannot be made; none of them is left then. No folder is the one that the
/// program runs in.
std::vector<std::filesystem::path> make_folders(const std::filesystem::path& folder);

/// Removes those of the folders that are empty, in this order.
void remove_empty(const std::vector<std::filesystem::path>& folders);

}  // namespace vug
