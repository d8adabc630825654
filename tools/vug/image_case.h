// A case of an image test: a folder with case.json, a reference picture and perhaps a mask.
// docs/guides/image_tests.md describes it for its writers.
#pragma once

#include <vug/image/diff.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::cli {

struct ImageCase {
  std::string name;  ///< Its folder, seen from where the search began.
  std::filesystem::path folder;
  std::filesystem::path scene;       ///< Empty where a command makes the picture.
  std::vector<std::string> render;   ///< Options of `vug render`.
  std::vector<std::string> command;  ///< With {output}, {seed} and {vug} in its words.
  std::filesystem::path reference;
  std::filesystem::path mask;  ///< Empty: all pixels.
  image::DiffOptions diff;
  double timeout = 600;  ///< Seconds.

  /// What makes the picture `output`, drawing other samples where a seed is given.
  std::vector<std::string> render_command(const std::filesystem::path& output, int threads,
                                          std::optional<uint64_t> seed) const;
  bool can_be_reseeded() const;
};

/// Reads folder/case.json. Error(bad_input) for a key that is not known, with the nearest that is,
/// and for a value of the wrong kind.
ImageCase read_case(const std::filesystem::path& folder, const std::string& name);

/// Folders at and below `root` that hold a case.json, in the order of their names; those in whose
/// name `filter` occurs. Error(bad_input) where `root` is no folder.
struct CaseFolder {
  std::filesystem::path folder;
  std::string name;
};
std::vector<CaseFolder> find_cases(const std::filesystem::path& root, const std::string& filter);

/// The history of a reference, a text beside it (reference.exr: reference.history), one line for
/// each picture it has been: version, content hash and reason. No dates.
std::filesystem::path history_of(const std::filesystem::path& reference);
/// Error(bad_input) when a history is there whose last line is not about the file as it is.
void require_recorded(const std::filesystem::path& reference);
/// Puts `picture` in the reference's place, the layers that are compared and what is known of their
/// noise, and adds a line to its history.
void replace_reference(const ImageCase& image_case, const std::filesystem::path& picture,
                       const std::string& reason);

}  // namespace vug::cli
