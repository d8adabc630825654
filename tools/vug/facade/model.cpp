// SPDX-License-Identifier: Apache-2.0
// vug facade model: interactive modelling sessions on the command line. A graphical user interface
// would use the module modeller in the same way.
#include "arguments.h"
#include "model_list.h"
#include "output_files.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/base/pluralize.h>
#include <vug/facade/grammar_output.h>
#include <vug/facade/tree_output.h>
#include <vug/image/io.h>
#include <vug/loading/load.h>
#include <vug/modeller/tree_to_edits.h>
#include <vug/session/facade_model.h>

namespace vug::cli {
namespace {

namespace fs = std::filesystem;

struct FacadeModelOptions {
  std::string session, output;
  std::string grammar, facade, photo, from;
  double width = 0, height = 0;
  std::vector<std::string> edits, applied, acts;
  std::vector<std::pair<std::string, std::string>>
      in_order;  ///< Kind and text of each edit, in command-line order.
  int undo = 0, redo = 0;
  std::string to, checkpoint;
  bool tree = false, theta = false, json = false;
  std::optional<std::string> list;
  std::string svg, overlay, scene, carve;
  session::CarvingOptions carving;
  WorkOptions work;

  bool edited() const {
    return undo || redo || !to.empty() || !checkpoint.empty() || !in_order.empty();
  }
  /// The first given option that applies to new sessions only; empty if none is given.
  std::string first_creation_option() const {
    if (!grammar.empty()) return "--grammar";
    if (!from.empty()) return "--from";
    if (!facade.empty()) return "--facade";
    if (width > 0) return "--width";
    if (height > 0) return "--height";
    return photo.empty() ? "" : "--photo";
  }
  bool prints() const { return tree || theta || json || list; }
  bool writes() const { return !(svg + scene + carve).empty(); }
};

fs::path folder_of(const std::string& file) { return fs::absolute(file).parent_path(); }

/// A new session without edits. If only the width or the height is given, the other follows from
/// the proportions of the photo.
modeller::Session create_session(const FacadeModelOptions& options) {
  const fs::path folder = options.output.empty() ? fs::current_path() : folder_of(options.output);
  modeller::SessionHeader header{.grammar = options.grammar, .facade = options.facade};
  // Paths in a session are relative to its folder.
  if (fs::exists(options.grammar)) header.grammar = relative_path_from(folder, options.grammar);
  if (options.width > 0) header.width = options.width;
  if (options.height > 0) header.height = options.height;
  if (!options.photo.empty()) {
    const image::FileInfo info = image::read_info(options.photo);
    modeller::Photo photo{relative_path_from(folder, options.photo), info.width, info.height};
    if (header.width && !header.height) header.height = *header.width * info.height / info.width;
    if (header.height && !header.width) header.width = *header.height * info.width / info.height;
    header.photo = photo;
  }
  return modeller::new_session(std::move(header), session::facade_style_loader(folder));
}

/// Reports how far the session deviates from the tree.
void print_deviation(const modeller::TreeEdits& way) {
  const std::string text = modeller::deviation_text(way);
  if (text.empty()) return;
  clear_progress_bar();
  fmt::print(stderr, "{}\n", text);
}

/// The grammar file that has the tree's name, which a session finds by itself.
std::string grammar_file_of(const facade::Tree& tree, const FacadeModelOptions& options) {
  std::string file = tree.name + ".vug";
  const fs::path folder = options.output.empty() ? fs::current_path() : folder_of(options.output);
  try {
    session::find_grammar_file(folder, file);
  } catch (const Error& error) {
    throw Error(
        error.code(), error.what(), {},
        fmt::format("'{}' was derived from a grammar '{}': name its file, as in --grammar out/{}",
                    options.from, tree.name, file));
  }
  return file;
}

/// A session whose edits reproduce the tree of a file.
modeller::Session session_from_tree(FacadeModelOptions options) {
  if (options.width > 0 || options.height > 0)
    throw Error(ErrorCode::bad_input,
                "--width and --height do not apply to a tree, which has a size", {},
                "remove --width and --height");
  const facade::Tree tree = modeller::read_tree(read_text(options.from), options.from);
  if (options.grammar.empty()) options.grammar = grammar_file_of(tree, options);
  options.width = tree.width, options.height = tree.height;
  modeller::Session out = create_session(options);
  const modeller::TreeEdits way = modeller::tree_to_edits(out.current(), tree);
  for (const modeller::Edit& edit : way.edits) out.history.apply(edit);
  if (!options.work.quiet) print_deviation(way);
  return out;
}

modeller::Session read(const FacadeModelOptions& options) {
  if (options.session.empty() && options.grammar.empty() && options.from.empty())
    throw Error(ErrorCode::bad_input, "no session given", {},
                "pass a session, or create one with --grammar or --from");
  if (options.session.empty())
    return options.from.empty() ? create_session(options) : session_from_tree(options);
  if (const std::string told = options.first_creation_option(); !told.empty())
    throw Error(
        ErrorCode::bad_input,
        fmt::format("{} applies to new sessions only, but '{}' exists", told, options.session), {},
        "remove it, or create a new session with --grammar");
  return modeller::read_session(read_text(options.session), options.session,
                                session::facade_style_loader(folder_of(options.session)));
}

/// Sets the checkpoint and reports the position of an earlier one of that name.
void set_checkpoint(const FacadeModelOptions& options, modeller::History& history) {
  const auto had = history.checkpoints().find(options.checkpoint);
  if (had != history.checkpoints().end() && had->second != history.done() && !options.work.quiet)
    fmt::print(stderr, "the checkpoint '{}' was after {} and is now after {}\n", options.checkpoint,
               pluralize(had->second, "edit"), history.done());
  history.set_checkpoint(options.checkpoint);
}

void edit(const FacadeModelOptions& options, modeller::Session& session) {
  modeller::History& history = session.history;
  const auto want = [](int steps, size_t had, const char* what) {
    if (had < static_cast<size_t>(steps))
      throw Error(ErrorCode::bad_input, fmt::format("the session has {} to {}, not {}",
                                                    pluralize(had, "edit"), what, steps));
  };
  if (!options.to.empty()) history.restore(options.to);
  if (options.undo) want(options.undo, history.undo(static_cast<size_t>(options.undo)), "undo");
  if (options.redo) want(options.redo, history.redo(static_cast<size_t>(options.redo)), "redo");
  for (const auto& [kind, text] : options.in_order) {
    try {
      history.apply(modeller::parse_edit(text, kind, session.metres_per_pixel()));
    } catch (Error& error) {
      error.within(fmt::format("doing '{}{}{}'", kind, kind.empty() ? "" : " ", text));
      throw;
    }
  }
  if (!options.checkpoint.empty()) set_checkpoint(options, history);
}

/// Writes the session to the output file, with paths relative to its folder.
void save(const FacadeModelOptions& options, modeller::Session session) {
  if (!options.session.empty())
    session.header = session::moved_header(std::move(session.header), folder_of(options.session),
                                           folder_of(options.output));
  write_text(options.output, modeller::session_text(session));
}

void draw(const FacadeModelOptions& options, const modeller::Session& session) {
  const fs::path to = folder_of(options.svg);
  facade::SvgOptions drawing;
  if (!options.overlay.empty())
    drawing.picture = relative_path_from(to, options.overlay);
  else if (session.header.photo && !options.session.empty())
    drawing.picture =
        relative_path_from(to, folder_of(options.session) / session.header.photo->file);
  else if (!options.photo.empty())
    drawing.picture = relative_path_from(to, options.photo);
  write_text(options.svg, facade::elevation_svg(session.current().tree(), drawing));
}

/// Files that the session depends on.
std::vector<fs::path> dependencies_of(const FacadeModelOptions& options,
                                      const modeller::Session& session) {
  const fs::path folder =
      options.session.empty() && options.output.empty()
          ? fs::current_path()
          : folder_of(options.session.empty() ? options.output : options.session);
  std::vector<fs::path> out;
  const fs::path grammar = (folder / session.header.grammar).lexically_normal();
  if (fs::exists(grammar)) out.push_back(grammar);
  if (session.header.photo) out.push_back((folder / session.header.photo->file).lexically_normal());
  return out;
}

/// Warns of a wall that is too thin for its voxels.
void warn_of_thin_wall(const session::CarvingOptions& carving) {
  if (carving.thickness >= 2 * carving.voxel) return;
  const auto length = [](double metres) { return quantity_text(metres, Dimension::length); };
  fmt::print(stderr,
             "warning: a wall of {} is thinner than two voxels of {} and may have holes\n"
             "hint: --voxel {}, or --thickness {}\n",
             length(carving.thickness), length(carving.voxel), length(carving.thickness / 2),
             length(2 * carving.voxel));
}

int run_facade_model(FacadeModelOptions options) {
  if (!options.carve.empty() && extension_of(options.carve) != ".vdb")
    throw Error(ErrorCode::bad_input, fmt::format("'{}' does not end in .vdb", options.carve), {},
                "for meshes, write a scene with --scene and run 'vug build'");
  std::vector<fs::path> outputs, inputs;
  for (const std::string& file : {options.svg, options.scene, options.carve})
    if (!file.empty()) outputs.emplace_back(file);
  // A session may overwrite itself.
  if (!options.output.empty() && options.output != options.session)
    outputs.emplace_back(options.output);
  for (const std::string& file :
       {options.session, options.photo, options.overlay, options.grammar, options.from})
    if (!file.empty()) inputs.emplace_back(file);
  require_outputs(outputs, inputs);
  modeller::Session session = read(options);
  require_outputs(outputs, dependencies_of(options, session));
  edit(options, session);
  // Faults of the edits themselves are reported first.
  if (options.edited() && options.output.empty() && !options.prints() && !options.writes())
    throw Error(ErrorCode::bad_input, "the edits would be lost", {},
                "write -o SESSION.json to keep them");
  const modeller::FacadeState& state = session.current();
  if (!options.svg.empty()) draw(options, session);
  if (!options.scene.empty())
    write_text(options.scene,
               facade::grammar_text(state.tree(),
                                    {.name = valid_grammar_name(fs::path(options.scene).stem())}));
  if (!options.carve.empty()) {
    warn_of_thin_wall(options.carving);
    const fs::path scene = fs::path(options.carve).replace_extension(".vug");
    options.carving.name = valid_grammar_name(state.tree().name);
    write_carving(
        loading::load_text(session::carving_scene(state.tree(), options.carving), scene.string()),
        options.work, options.carve);
    clear_progress_bar();
  }
  if (!options.output.empty()) save(options, session);
  if (options.list) fmt::print("{}", list_text(state, *options.list));
  if (options.theta) fmt::print("{}\n", facade::theta(state.tree()));
  if (options.json) fmt::print("{}", facade::tree_json(state.tree()));
  if (options.tree || !(options.prints() || options.writes() || !options.output.empty()))
    fmt::print("{}", tree_text(state));
  return kDone;
}

void add_edits(CLI::App& app, FacadeModelOptions& options) {
  const auto add = [&](const char* name, std::vector<std::string>& to, const char* doc) {
    app.add_option(name, to, doc)->take_all()->allow_extra_args(false);
  };
  add("--apply", options.applied, "Apply one rule to an open node: 'NODE RULE name=value ...'");
  add("--act", options.acts, "Apply a rule and its consequences: 'NODE ACTION name=value ...'");
  std::string kinds;
  for (const modeller::EditKind* kind : modeller::edit_kinds())
    kinds += (kinds.empty() ? "" : ", ") + kind->name;
  app.add_option("--edit", options.edits,
                 fmt::format("Apply an edit: 'KIND NODE ...', where KIND is one of {}", kinds))
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--undo", options.undo, "Number of edits to undo before other edits are applied")
      ->transform(integer_in(1, 1000000000));
  app.add_option("--redo", options.redo, "Number of undone edits to redo")
      ->transform(integer_in(1, 1000000000));
  app.add_option("--to", options.to, "Restore this checkpoint before all other edits");
  app.add_option("--checkpoint", options.checkpoint,
                 "Name of a checkpoint that is set after all edits");
}

/// Collects the edits of all options in the order of the command line.
void order_edits(const CLI::App& app, FacadeModelOptions& options) {
  size_t edit = 0, apply = 0, act = 0;
  for (const CLI::Option* each : app.parse_order()) {
    const std::string name = each->get_name();
    if (name == "--edit") options.in_order.emplace_back("", options.edits.at(edit++));
    if (name == "--apply") options.in_order.emplace_back("apply", options.applied.at(apply++));
    if (name == "--act") options.in_order.emplace_back("act", options.acts.at(act++));
  }
}

}  // namespace

Verb facade_model_verb() {
  return {
      "model", "Models a facade interactively: a session applies and retracts rules.",
      [](CLI::App& app) {
        auto options = std::make_shared<FacadeModelOptions>();
        app.add_option("session", options->session, "Session to continue");
        app.add_option("-o,--output", options->output, "Output file of the session");
        auto* fresh = app.add_option_group("begin", "New session");
        fresh->add_option("--grammar", options->grammar,
                          "Grammar of kind facade, e.g. ripperda.vug");
        fresh->add_option("--from", options->from,
                          "Initial tree, as written by vug facade fit or vug tree --json");
        fresh->add_option("--facade", options->facade, "Name of the grammar in the file");
        fresh->add_option("--width", options->width, "Width of the facade")
            ->transform(number_in(Dimension::length, 0.01, 1e5));
        fresh
            ->add_option("--height", options->height,
                         "Height of the facade; default from the proportions of the photo")
            ->transform(number_in(Dimension::length, 0.01, 1e5));
        fresh->add_option("--photo", options->photo, "Upright picture of the modelled facade");
        add_edits(app, *options);
        app.add_option_function<std::string>(
               "--list", [options](const std::string& node) { options->list = node; },
               "List the rules of one node or of all: those that can be applied, and why "
               "others cannot")
            ->expected(0, 1)
            ->default_str(".");
        app.add_flag("--tree", options->tree, "Print the tree as text; this is the default");
        app.add_flag("--theta", options->theta,
                     "Print the tree in the notation of Ripperda and Brenner");
        app.add_flag("--json", options->json, "Print the tree as JSON");
        app.add_option("--svg", options->svg,
                       "Write a drawing of the rectangles, over the photo if the session has one");
        app.add_option("--overlay", options->overlay,
                       "Picture that replaces the photo in the drawing");
        app.add_option(
            "--scene", options->scene,
            "Write a grammar with all sizes to this .vug, whose name is that of the grammar");
        app.add_option("--carve", options->carve,
                       "Write a wall with the carved facade to this .vdb");
        app.add_option("--voxel", options->carving.voxel,
                       "Voxel size of the carved wall; default 4cm")
            ->transform(number_in(Dimension::length, 1e-4, 10));
        app.add_option("--thickness", options->carving.thickness,
                       "Thickness of the wall; default 60cm")
            ->transform(number_in(Dimension::length, 1e-3, 100));
        options->work.add_to(app);
        return [options, &app] {
          order_edits(app, *options);
          return with_threads(options->work.threads, [&] { return run_facade_model(*options); });
        };
      }};
}

}  // namespace vug::cli
