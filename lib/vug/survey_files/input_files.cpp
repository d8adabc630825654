// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/survey_files/input_files.h>
#include <vug/survey_files/text_lines.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey {
namespace {

constexpr size_t kDeepest = 100;
constexpr int kMostFiles = 100'000;

std::filesystem::path resolved(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(
      path.empty() ? std::filesystem::current_path() : std::filesystem::absolute(path), ignored);
}

bool is_within(const std::filesystem::path& file, const std::filesystem::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

[[noreturn]] void refuse(const std::string& problem, const SourceLocation& where,
                         std::string hint) {
  throw Error(ErrorCode::bad_input, problem, where, std::move(hint));
}

}  // namespace

void require_size(size_t bytes, const ReadOptions& options, const SourceLocation& where) {
  if (bytes > options.max_bytes)
    refuse(fmt::format("the files of the survey exceed {} bytes", options.max_bytes), where,
           "read a part of the survey");
}

InputFiles::InputFiles(const std::filesystem::path& first, size_t bytes, const ReadOptions& options)
    : files_{first}, all_{first}, bytes_(bytes), options_(options) {
  require_size(bytes, options, {first.string(), 1, 1});
  if (!options.allow_outside)
    root_ = resolved(options.root.empty() ? first.parent_path() : options.root);
}

std::filesystem::path InputFiles::find(const std::string& name, const std::string& extension,
                                       const SourceLocation& where) const {
  std::string plain = name;
  std::replace(plain.begin(), plain.end(), '\\', '/');
  if (plain.empty() || plain.find('\0') != std::string::npos || plain.size() > 4000)
    refuse("the name of the file is empty or not usable", where, "write the path of a file");
  const std::filesystem::path folder = current().parent_path();
  for (const std::string& attempt :
       {plain, plain + extension, lower_case(plain), lower_case(plain) + extension}) {
    const std::filesystem::path path = folder / attempt;
    // The check comes first, so that the existence of files outside does not show.
    if (!root_.empty() && !is_within(resolved(path), root_))
      refuse(
          fmt::format("the file {} is outside of the survey's folder", quote_text(name)), where,
          "move it into the folder of the survey, or write one file with all of them: vug survey "
          "FILE --allow-outside -o ALL.svx");
    if (unreadable_reason(path).empty()) return path;
  }
  refuse(fmt::format("cannot read the file {}: {}", quote_text(name),
                     unreadable_reason(folder / plain)),
         where, "paths are relative to the folder of the file that names them");
}

std::string InputFiles::enter(const std::string& name, const std::string& extension,
                              const SourceLocation& where) {
  const std::filesystem::path path = find(name, extension, where);
  const std::filesystem::path same = resolved(path);
  for (const std::filesystem::path& file : files_)
    if (resolved(file) == same)
      refuse(fmt::format("the file {} includes itself", quote_text(name)), where,
             "remove one of the references");
  if (files_.size() >= kDeepest || ++count_ > kMostFiles)
    refuse(fmt::format("files are nested more than {} levels deep, or more than {}", kDeepest,
                       kMostFiles),
           where, "join some of the files");
  // The size is checked before the file is in memory, and again in case it has grown.
  std::error_code unknown;
  const auto size = std::filesystem::file_size(path, unknown);
  require_size(bytes_ + (unknown ? 0 : static_cast<size_t>(size)), options_, where);
  files_.push_back(path);
  all_.push_back(path);
  std::string text;
  try {
    text = read_text(path);
  } catch (const Error& failed) {
    throw failed.at(where);
  }
  bytes_ += text.size();
  require_size(bytes_, options_, where);
  return text;
}

}  // namespace vug::survey
