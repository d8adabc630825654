// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/svx/files.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxDepth = 100;

std::vector<fs::path> candidates(const IncludeRequest& request) {
  std::string mapped = request.name;
  std::replace(mapped.begin(), mapped.end(), '\\', '/');
  std::string lower = mapped;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  std::vector<fs::path> all;
  for (const std::string& name : {request.name, mapped, lower})
    for (const char* extension : {"", ".svx"})
      all.push_back(request.files.back().parent_path() / (name + extension));
  return all;
}

bool is_inside(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

fs::path without_links(const fs::path& file) {
  std::error_code failed;
  fs::path out = fs::weakly_canonical(fs::absolute(file), failed);
  return failed ? fs::absolute(file).lexically_normal() : out;
}

}  // namespace

fs::path canonical_folder(const fs::path& folder) {
  const fs::path out = without_links(folder.empty() ? fs::path(".") : folder);
  return out.has_filename() ? out : out.parent_path();
}

fs::path find_included(const IncludeRequest& request) {
  if (request.files.size() > kMaxDepth)
    throw Error(ErrorCode::bad_input, fmt::format("more than {} nested *include", kMaxDepth),
                request.where, "include the files from fewer levels");
  bool refused = false;
  for (const fs::path& file : candidates(request)) {
    if (!request.allow_outside && !is_inside(without_links(file), request.root)) {
      refused = true;
      continue;
    }
    std::error_code missing;
    if (!fs::is_regular_file(file, missing)) continue;
    for (const fs::path& open : request.files)
      if (fs::equivalent(open, file, missing))
        throw Error(ErrorCode::bad_input,
                    fmt::format("the file '{}' includes itself", request.name), request.where,
                    "remove this *include");
    return file;
  }
  if (refused)
    throw Error(ErrorCode::bad_input,
                fmt::format("the file '{}' is outside of the survey's folder", request.name),
                request.where, "move it into the folder, or allow files outside of it");
  throw Error(ErrorCode::bad_input, fmt::format("the file '{}' does not exist", request.name),
              request.where, "names are relative to the folder of the including file");
}

}  // namespace vug::survey
