// SPDX-License-Identifier: Apache-2.0
// The file of a document, which other programs may change.
#pragma once

#include <vug/workbench/scene_text.h>

#include <filesystem>

namespace vug::workbench {

/// A text and the file in which it was last read or written. Another program, or another window,
/// can change the file at any time: its text is never replaced unless the caller asks for it.
class SavedFile {
 public:
  SavedFile() = default;
  /// Reads the file; the text of a missing one is empty. Error(io).
  explicit SavedFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  /// The text when this object last read or wrote the file.
  const SceneText& text() const { return text_; }
  /// The text that another program has written since; null if there is none. Reads the file.
  SceneText changed_by_others() const;
  /// Reads the file again. Error(bad_input) if it is missing, Error(io).
  void reload();
  /// Keeps the line ends of the file. Error(bad_input) if another program has changed it, unless
  /// `replace` is true. Error(io).
  void write(const SceneText& text, bool replace = false);
  /// Continues with another file, which is replaced. Error(io).
  void write_as(const std::filesystem::path& path, const SceneText& text);

 private:
  std::filesystem::path path_;
  SceneText text_;
  FileConventions conventions_;
};

}  // namespace vug::workbench
