// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/scene/text_at.h>
#include <vug/workbench/saved_file.h>

#include <fmt/format.h>

#include <utility>

namespace vug::workbench {
namespace {

bool is_present(const std::filesystem::path& path) {
  std::error_code missing;
  return std::filesystem::is_regular_file(path, missing);
}

}  // namespace

SavedFile::SavedFile(std::filesystem::path path) : path_(std::move(path)) {
  const std::string bytes = is_present(path_) ? read_text(path_) : "";
  text_ = std::make_shared<const std::string>(scene::normalise_text(bytes));
  conventions_ = conventions_of(bytes);
}

SceneText SavedFile::changed_by_others() const {
  // A removed file holds no work that a save could destroy.
  if (!is_present(path_)) return nullptr;
  const SceneText now = SavedFile(path_).text();
  return *now == *text_ ? nullptr : now;
}

void SavedFile::reload() {
  if (!is_present(path_))
    throw Error(ErrorCode::bad_input,
                fmt::format("cannot reload '{}': the file was removed", path_.string()), {},
                "save the text to write the file again");
  *this = SavedFile(path_);
}

void SavedFile::write(const SceneText& text, bool replace) {
  const SceneText others = replace ? nullptr : changed_by_others();
  if (others && *others != *text)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("another program has changed {} of '{}' since it was opened",
                    changed_lines(*text_, *others), path_.string()),
        {},
        "'reload' takes the text of the file, and undo returns to yours; 'overwrite' saves yours");
  write_as(path_, text);
}

void SavedFile::write_as(const std::filesystem::path& path, const SceneText& text) {
  write_text(path, with_conventions(*text, conventions_));
  path_ = path;
  text_ = text;
}

}  // namespace vug::workbench
