// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/diagnostics.h>
#include <vug/facade/grammar_output.h>
#include <vug/facade/tree_output.h>
#include <vug/image/io.h>
#include <vug/session/facade_model.h>
#include <vug/workbench/export_facade.h>
#include <vug/workbench/facade_bench.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

namespace fs = std::filesystem;

void write_svg(const FacadeBench& bench, const fs::path& file) {
  facade::SvgOptions drawing;
  if (!bench.photo().empty())
    drawing.picture = session::relative_path_from(fs::absolute(file).parent_path(), bench.photo());
  write_text(file, facade::elevation_svg(bench.document().state().tree(), drawing));
}

void write_picture(const FacadeBench& bench, const fs::path& file) {
  image::write_png(file, overlay_picture(bench), image::plain_view());
}

void write_json(const FacadeBench& bench, const fs::path& file) {
  write_text(file, facade::tree_json(bench.document().state().tree()));
}

void write_theta(const FacadeBench& bench, const fs::path& file) {
  write_text(file, facade::theta(bench.document().state().tree()) + "\n");
}

void write_scene(const FacadeBench& bench, const fs::path& file) {
  write_text(file, facade::grammar_text(bench.document().state().tree(),
                                        {.name = session::valid_grammar_name(file.stem())}));
}

void write_carving(const FacadeBench& bench, const fs::path& file) {
  session::FacadeFit carved;
  carved.tree = bench.document().state().tree();
  write_text(file, session::facade_scene(carved, session::valid_grammar_name(file.stem()), ""));
}

void write_session(const FacadeBench& bench, const fs::path& file) {
  write_text(file, modeller::session_text(bench.session_for(file)));
}

}  // namespace

const std::vector<ExportKind>& export_kinds() {
  static const std::vector<ExportKind> all = {
      {"svg", ".svg", "a drawing over the photo", write_svg},
      {"png", ".png", "the photo with the elements, as pixels", write_picture},
      {"json", ".json", "the derivation tree with all rectangles", write_json},
      {"theta", ".txt", "the derivation tree in the notation of the paper", write_theta},
      {"scene", ".vug", "a grammar with all sizes", write_scene},
      {"carve", ".vug", "a rock scene with the facade carved into a wall", write_carving},
      {"session", ".json", "a copy of the session", write_session}};
  return all;
}

void export_facade(const FacadeBench& bench, const std::string& kind, const fs::path& file) {
  std::vector<std::string> names;
  for (const ExportKind& each : export_kinds()) {
    names.push_back(each.name);
    if (each.name != kind) continue;
    if (extension_of(file) != each.extension)
      throw Error(ErrorCode::bad_input,
                  fmt::format("'{}' does not end in {}", file.string(), each.extension), {},
                  fmt::format("'{}' is {}", each.name, each.doc));
    std::vector<fs::path> inputs;
    for (const fs::path& input : {bench.photo(), bench.file()})
      if (!input.empty()) inputs.push_back(input);
    require_outputs({file}, inputs);
    each.write(bench, file);
    return;
  }
  throw Error(ErrorCode::bad_input, fmt::format("unknown kind of file '{}'", kind), {},
              suggestion(kind, names));
}

}  // namespace vug::workbench
