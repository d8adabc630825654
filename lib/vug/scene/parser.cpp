// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/utf8.h>
#include <vug/scene/check.h>
#include <vug/scene/include_search.h>
#include <vug/scene/parser.h>
#include <vug/scene/statement_parser.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

namespace vug::scene {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> read_disk(const fs::path& path) {
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) return std::nullopt;
  return read_text(path);
}

/// Follows includes: each file is read once, and cyclic includes are an error.
class Loader {
  using ModulePrefix = std::shared_ptr<const std::string>;

 public:
  Loader(Document& document, Diagnostics& diagnostics, const ParseOptions& options)
      : document_(document), diagnostics_(diagnostics), options_(options) {}

  /// `module` is the prefix of the names that the file declares; null: none.
  bool load(std::string text, const fs::path& path, const SourceLocation& from,
            const ModulePrefix& module = nullptr) {
    const std::string file = path.generic_string();
    bytes_ += text.size();
    if (text.size() > options_.max_bytes || bytes_ > options_.max_total_bytes) {
      const bool one = text.size() > options_.max_bytes;
      const size_t limit = one ? options_.max_bytes : options_.max_total_bytes;
      diagnostics_.error(from.known() ? from : SourceLocation{file, 1, 1},
                         one ? fmt::format("'{}' is larger than {} bytes", file, limit)
                             : fmt::format("all files together are larger than {} bytes", limit));
      return false;
    }
    if (is_binary(text)) {
      const bool included = from.known();
      diagnostics_.error(
          included ? from : SourceLocation{file, 0, 0},
          fmt::format("{} is not a text file", included ? "'" + file + "'" : "the file"),
          "scenes are UTF-8 text; 'vug info' describes grids, meshes and pictures");
      return false;
    }
    auto source =
        std::make_shared<const Source>(Source{file, normalise_text(std::move(text)), from});
    document_.sources.push_back(source);
    known_.emplace(identity(path), text_of(module));
    chain_.push_back(path);
    const std::vector<Token> tokens =
        lex(source->text, source->file, diagnostics_, false, options_.max_errors);
    Cursor cursor(tokens, source->file, diagnostics_, options_, module);
    parse_statements(cursor, document_, [&](const Include& wanted) {
      if (!wanted.name.empty()) {
        if (!import(wanted, path)) document_.skipped.file = true;
      } else if (!include(wanted.path, path, wanted.where, module)) {
        document_.skipped.file = true;
      }
    });
    chain_.pop_back();
    return true;
  }

 private:
  static fs::path identity(const fs::path& path) {
    std::error_code failed;
    const fs::path whole = fs::weakly_canonical(path, failed);
    return failed ? path.lexically_normal() : whole;
  }

  static std::string text_of(const ModulePrefix& module) { return module ? *module : ""; }

  /// Reads a file as a module and gives values to its parameters.
  bool import(const Include& wanted, const fs::path& from) {
    const std::string prefix = wanted.name + ".";
    document_.modules.push_back({wanted.name, wanted.name_where});
    const auto module = std::make_shared<const std::string>(prefix);
    if (!include(wanted.path, from, wanted.where, module)) return false;
    if (!options_.check_modules) return true;
    std::vector<std::string> names;
    for (const Param& param : document_.params)
      if (param.name.starts_with(prefix)) names.push_back(param.name.substr(prefix.size()));
    for (const Entry& entry : wanted.entries) {
      const auto param =
          std::find_if(document_.params.begin(), document_.params.end(),
                       [&](const Param& each) { return each.name == prefix + entry.key; });
      if (param == document_.params.end())
        diagnostics_.error(
            entry.where, fmt::format("'{}' has no parameter '{}'", wanted.path, entry.key),
            names.empty() ? "it declares no parameters" : suggestion(entry.key, names));
      else if (entry.values.size() > 1)
        diagnostics_.error(entry.extent, fmt::format("'{}' takes one value", entry.key),
                           "write a list as [a, b]");
      else
        param->given = entry.values[0];
    }
    return true;
  }

  /// Returns false if the content of the file is unknown.
  bool include(const std::string& wanted, const fs::path& from, const SourceLocation& where,
               const ModulePrefix& module) {
    std::vector<fs::path> places{from.parent_path()};
    std::string why;
    places.insert(places.end(), options_.include_folders.begin(), options_.include_folders.end());
    for (const fs::path& place : places)
      if (const auto known = try_include(place / wanted, where, module, why)) return *known;
    if (!why.empty()) {
      diagnostics_.error(where, fmt::format("cannot read the file '{}': {}", wanted, why));
      return false;
    }
    if (const auto known = include_below(wanted, where, module)) return *known;
    std::string looked;
    for (const fs::path& place : places)
      looked += (looked.empty() ? "" : ", ") + (place.empty() ? "." : place.generic_string());
    const std::string elsewhere = in_subfolder(fs::path(wanted).filename());
    diagnostics_.error(
        where, fmt::format("cannot find the file '{}'", wanted),
        elsewhere.empty() ? "looked in " + looked : fmt::format("did you mean '{}'?", elsewhere));
    return false;
  }

  /// Includes the file unless it has been included already: whether its content is known. Nothing
  /// if it cannot be read; `why` is then the reason for a file that exists.
  std::optional<bool> try_include(const fs::path& file, const SourceLocation& where,
                                  const ModulePrefix& module, std::string& why) {
    const fs::path path = file.lexically_normal();
    if (is_cyclic(path, where)) return true;
    if (known_.count({identity(path), text_of(module)})) return true;
    const auto text = options_.read ? options_.read(path) : read_disk(path);
    std::error_code failed;
    if (!text && !options_.read && why.empty() && fs::exists(path, failed))
      why = unreadable_reason(path);
    if (!text) return std::nullopt;
    if (chain_.size() >= kMaxChain) {
      diagnostics_.error(where,
                         fmt::format("files are included more than {} levels deep", kMaxChain));
      return false;
    }
    return load(*text, path, where, module);
  }

  /// Includes the only file of that name below the first folder that has one.
  std::optional<bool> include_below(const std::string& wanted, const SourceLocation& where,
                                    const ModulePrefix& module) {
    for (const fs::path& folder : options_.include_folders) {
      const std::vector<fs::path> found = files_below(folder, wanted);
      if (found.empty()) continue;
      std::string why;
      if (found.size() == 1) return try_include(folder / found[0], where, module, why);
      std::vector<std::string> names;
      for (const fs::path& each : found)
        names.push_back(fmt::format("\"{}\"", each.generic_string()));
      diagnostics_.error(where, fmt::format("'{}' is the name of {} files", wanted, found.size()),
                         fmt::format("include one of: {}", fmt::join(names, ", ")));
      return false;
    }
    return std::nullopt;
  }

  /// The path of a file with this name in a folder below those of includes, or an empty string.
  std::string in_subfolder(const fs::path& name) const {
    for (const fs::path& folder : options_.include_folders)
      if (const auto found = files_below(folder, name); !found.empty())
        return found[0].generic_string();
    return {};
  }

  bool is_cyclic(const fs::path& path, const SourceLocation& where) {
    const auto same = [&](const fs::path& other) { return identity(other) == identity(path); };
    const auto first = std::find_if(chain_.begin(), chain_.end(), same);
    if (first == chain_.end()) return false;
    std::string names;
    for (auto file = first; file != chain_.end(); ++file) names += file->generic_string() + " -> ";
    diagnostics_.error(where, "files include each other in a cycle", names + path.generic_string());
    return true;
  }

  static constexpr size_t kMaxChain = 64;

  Document& document_;
  Diagnostics& diagnostics_;
  const ParseOptions& options_;
  std::set<std::pair<fs::path, std::string>> known_;  ///< Files with the prefix of their names.
  std::vector<fs::path> chain_;
  size_t bytes_ = 0;
};

}  // namespace

Document parse(std::string text, const std::string& file, Diagnostics& diagnostics,
               const ParseOptions& options) {
  Document document;
  Loader loader(document, diagnostics, options);
  loader.load(std::move(text), file, {});
  const fs::path folder = fs::path(file).parent_path();
  for (size_t i = 0; i < options.appended.size(); ++i)
    loader.load(options.appended[i],
                folder / (i == 0 ? "appended" : fmt::format("appended {}", i + 1)), {});
  check_names(document, diagnostics);
  return document;
}

Document parse_file(const fs::path& file, Diagnostics& diagnostics, const ParseOptions& options) {
  auto text = options.read ? options.read(file) : read_disk(file);
  if (!text) {
    const std::string why = options.read ? "" : unreadable_reason(file);
    const fs::path longer = fs::path(file) += ".vug";
    std::error_code failed;
    throw Error(
        ErrorCode::bad_input,
        fmt::format("cannot read '{}'{}{}", file.generic_string(), why.empty() ? "" : ": ", why),
        {}, fs::exists(longer, failed) ? suggestion("", {longer.generic_string()}) : "");
  }
  return parse(std::move(*text), file.generic_string(), diagnostics, options);
}

ExprPtr parse_expression(const std::string& text, const std::string& file, Diagnostics& diagnostics,
                         const ParseOptions& options) {
  const size_t before = diagnostics.all().size();
  const std::vector<Token> tokens = lex(text, file, diagnostics);
  Cursor cursor(tokens, file, diagnostics, options);
  try {
    ExprPtr expr = ExprParser(cursor).whole();
    cursor.skip_newlines();
    if (!cursor.at_end()) cursor.unexpected("the end of the expression");
    return diagnostics.all().size() == before ? expr : nullptr;
  } catch (const SyntaxFault&) {
    return nullptr;
  }
}

}  // namespace vug::scene
