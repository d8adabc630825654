// SPDX-License-Identifier: Apache-2.0
// A case of an image test: a folder with case.json, a reference picture and an optional mask.
// docs/guides/image_tests.md describes the format.
#pragma once

#include <vug/image/diff.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::cli {

struct ImageCase {
  std::string name;  ///< Path of its folder, relative to the folder that was searched.
  std::filesystem::path folder;
  std::filesystem::path scene;       ///< Empty if a command creates the picture.
  std::vector<std::string> render;   ///< Options of `vug render`.
  std::vector<std::string> command;  ///< May contain {output}, {seed} and {vug}.
  std::filesystem::path reference;
  std::filesystem::path mask;  ///< Empty: all pixels count.
  image::DiffOptions diff;
  double timeout = 600;  ///< Seconds.

  /// The command that creates the picture `output`, with other samples if a seed is given.
  std::vector<std::string> render_command(const std::filesystem::path& output, int threads,
                                          std::optional<uint64_t> seed) const;
  /// Whether the samples of its picture depend on a seed.
  bool can_be_reseeded() const;
};

/// Reads folder/case.json. Error(bad_input) for an unknown key, with the nearest known key, and for
/// a value of the wrong type.
ImageCase read_case(const std::filesystem::path& folder, const std::string& name);

/// A folder with a case.json, and its name relative to the folder that was searched.
struct CaseFolder {
  std::filesystem::path folder;
  std::string name;
};
/// Folders at and below `root` that hold a case.json and whose name contains `filter`, in the order
/// of their names. Error(bad_input) if `root` is not a folder.
std::vector<CaseFolder> find_cases(const std::filesystem::path& root, const std::string& filter);

/// The history of a reference, a text file next to it (reference.exr: reference.history) with one
/// line per version of the picture: program version, content hash and reason. It holds no dates.
std::filesystem::path history_of(const std::filesystem::path& reference);
/// Error(bad_input) if a history exists and its last line does not match the reference's content.
void require_recorded(const std::filesystem::path& reference);
/// Replaces the reference by `picture`, reduced to the compared layers and their noise estimates,
/// and adds a line to its history.
void replace_reference(const ImageCase& image_case, const std::filesystem::path& picture,
                       const std::string& reason);

}  // namespace vug::cli
