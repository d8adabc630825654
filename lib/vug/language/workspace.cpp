// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/language/workspace.h>

#include <fmt/format.h>

#include <set>

namespace vug::language {

namespace fs = std::filesystem;

namespace {

/// Limit of the scenes that are searched for uses of a name.
constexpr size_t kMaxFiles = 5000;

fs::path identity(const fs::path& path) {
  std::error_code failed;
  const fs::path whole = fs::weakly_canonical(path, failed);
  return failed ? path.lexically_normal() : whole;
}

void add_scenes_below(const fs::path& folder, std::set<fs::path>& files) {
  std::error_code failed;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied,
                                      failed);
  for (; !failed && at != fs::recursive_directory_iterator() && files.size() < kMaxFiles;
       at.increment(failed)) {
    if (at->path().filename().string().starts_with('.') && at->is_directory(failed))
      at.disable_recursion_pending();
    else if (at->path().extension() == ".vug" && at->is_regular_file(failed))
      files.insert(identity(at->path()));
  }
}

}  // namespace

bool is_same_file(const fs::path& a, const fs::path& b) {
  return a == b || identity(a) == identity(b);
}

void Workspace::open(const fs::path& file, std::string text) {
  open_[identity(file)] = {file, scene::normalise_text(std::move(text))};
  analyses_.clear();
}

void Workspace::close(const fs::path& file) {
  open_.erase(identity(file));
  analyses_.clear();
}

bool Workspace::is_open(const fs::path& file) const { return open_.count(identity(file)) > 0; }

std::optional<std::string> Workspace::read(const fs::path& file) const {
  if (const auto found = open_.find(identity(file)); found != open_.end())
    return found->second.text;
  std::error_code failed;
  if (!fs::is_regular_file(file, failed) || !unreadable_reason(file).empty()) return std::nullopt;
  return read_text(file);
}

scene::ParseOptions Workspace::parse_options() const {
  scene::ParseOptions options;
  options.include_folders = options_.include_folders;
  options.read = [this](const fs::path& path) { return read(path); };
  return options;
}

AnalysisPtr Workspace::analyse(const fs::path& file) const {
  const std::string name = file.generic_string();
  if (const auto found = analyses_.find(name); found != analyses_.end()) return found->second;
  std::optional<std::string> text = read(file);
  if (!text) throw Error(ErrorCode::bad_input, fmt::format("cannot read '{}'", name));
  const auto made = std::make_shared<Analysis>();
  made->file = name;
  made->text = scene::normalise_text(std::move(*text));
  Diagnostics ignored;
  made->tokens = scene::lex(made->text, name, ignored, true);
  made->document = scene::parse(made->text, name, made->diagnostics, parse_options());
  made->symbols = collect_symbols(made->document);
  if (made->diagnostics.has_errors()) add_uncertain_references(made->tokens, name, made->symbols);
  return analyses_[name] = made;
}

std::vector<fs::path> Workspace::files_with(const std::string& word) const {
  std::set<fs::path> candidates;
  for (const fs::path& folder : folders_) add_scenes_below(folder, candidates);
  std::vector<fs::path> files;
  for (const auto& [path, text] : open_) {
    files.push_back(text.file);
    candidates.erase(path);
  }
  for (const fs::path& path : candidates)
    if (const auto text = read(path); text && text->find(word) != std::string::npos)
      files.push_back(path);
  return files;
}

}  // namespace vug::language
