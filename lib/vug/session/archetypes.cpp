// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/loading/data_folders.h>
#include <vug/scene/parser.h>
#include <vug/session/archetypes.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace vug::session {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The text of an expression that lies in one line.
std::string written(const scene::ExprPtr& expr, const std::vector<std::string>& lines) {
  if (!expr || expr->extent.line < 1 || expr->extent.end_line != expr->extent.line) return {};
  const std::string& line = lines.at(static_cast<size_t>(expr->extent.line - 1));
  return line.substr(static_cast<size_t>(expr->extent.column - 1),
                     static_cast<size_t>(expr->extent.end_column - expr->extent.column));
}

/// The first sentence of the comment that begins a text.
std::string first_sentence(const std::vector<std::string>& lines) {
  std::string comment;
  for (const std::string& line : lines) {
    if (line.rfind("# ", 0) != 0) break;
    comment += (comment.empty() ? "" : " ") + line.substr(2);
  }
  const size_t end = comment.find(". ");
  return end == std::string::npos ? comment : comment.substr(0, end + 1);
}

/// The document of the file alone, with its includes.
scene::Document parsed(const std::filesystem::path& file,
                       const std::vector<std::filesystem::path>& data_folders) {
  scene::ParseOptions options;
  options.include_folders = data_folders;
  Diagnostics diagnostics;
  scene::Document document = scene::parse_file(file, diagnostics, options);
  if (diagnostics.has_errors())
    throw Error(ErrorCode::bad_input, diagnostics.all().front().message,
                diagnostics.all().front().where, diagnostics.all().front().hint);
  return document;
}

Archetype read_archetype(const std::filesystem::path& file,
                         const std::vector<std::filesystem::path>& data_folders) {
  const scene::Document document = parsed(file, data_folders);
  const std::vector<std::string> lines = lines_of(document.sources.front()->text);
  Archetype out{file.stem().string(), file, first_sentence(lines), {}, {}, {}};
  for (const scene::Param& param : document.params)
    if (param.where.file == document.sources.front()->file)
      out.params.push_back({param.name, written(param.value, lines), written(param.low, lines),
                            written(param.high, lines), param.doc});
  for (const scene::Declaration& each : document.declarations)
    if (each.kind == "camera") out.cameras.push_back(each.name);
  for (const char* extension : {".jpg", ".png"}) {
    const std::filesystem::path picture = std::filesystem::path(file).replace_extension(extension);
    if (out.thumbnail.empty() && std::filesystem::is_regular_file(picture)) out.thumbnail = picture;
  }
  return out;
}

}  // namespace

std::vector<Archetype> archetypes(const std::vector<std::filesystem::path>& data_folders) {
  std::vector<Archetype> out;
  for (const auto& [name, file] : loading::scene_files(data_folders, "caves")) {
    Archetype one = read_archetype(file, data_folders);
    if (!one.cameras.empty()) out.push_back(std::move(one));
  }
  return out;
}

Archetype find_archetype(const std::vector<std::filesystem::path>& data_folders,
                         const std::string& name) {
  std::vector<std::string> names;
  for (Archetype& each : archetypes(data_folders)) {
    if (each.name == name) return std::move(each);
    names.push_back(each.name);
  }
  throw Error(ErrorCode::bad_input, fmt::format("no archetype has the name '{}'", name), {},
              did_you_mean(name, names, "'vug new' lists all of them"));
}

std::string new_scene(const Archetype& archetype, const std::string& file) {
  std::string text = fmt::format("# {}\n", archetype.doc);
  text += fmt::format("#   vug render {0}.vug -o {0}.exr            the picture\n", file);
  text += fmt::format("#   vug render {0}.vug -o {0}.exr --seed 2   another cave\n", file);
  text += "seed 1\n\n# The values are those of the archetype. Change any, or remove its line.\n";
  text += fmt::format("include \"caves/{}.vug\" as cave {{\n", archetype.name);
  size_t name_width = 0, value_width = 0;
  for (const ArchetypeParam& each : archetype.params) {
    name_width = std::max(name_width, each.name.size());
    value_width = std::max(value_width, each.value.size());
  }
  for (const ArchetypeParam& each : archetype.params)
    text += fmt::format("  {:<{}} {:<{}}  # {}{}\n", each.name, name_width, each.value, value_width,
                        each.doc,
                        each.low.empty() ? "" : fmt::format(", {} to {}", each.low, each.high));
  text += "}\n\n";
  text += fmt::format(
      "render main {{ camera cave.{}  size 480x270  quality draft }}  # then look, and final\n",
      archetype.cameras.front());
  for (size_t i = 1; i < archetype.cameras.size(); ++i)
    text += fmt::format("# Another view: --camera cave.{}\n", archetype.cameras[i]);
  return text;
}

}  // namespace vug::session
