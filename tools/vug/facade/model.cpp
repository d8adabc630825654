// vug facade model: sessions of modelling by hand, from the command line. A window would do the
// same with the module modeller.
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

struct Options {
  std::string session, output;
  std::string grammar, facade, photo, from;
  double width = 0, height = 0;
  std::vector<std::string> edits, applied, acts;
  std::vector<std::pair<std::string, std::string>> in_order;  ///< Kind and text of each edit.
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
  /// The first option that only a session takes that begins; empty: none is told.
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

/// A session of nothing yet. A photo tells the height, or the width, that is not given.
modeller::Session create_session(const Options& options) {
  const fs::path folder = options.output.empty() ? fs::current_path() : folder_of(options.output);
  modeller::SessionHeader header{.grammar = options.grammar, .facade = options.facade};
  // A file that is named from here is named from the session's folder.
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

/// What the session cannot say as the tree did.
void print_deviation(const modeller::TreeEdits& way) {
  if (way.missing + way.displaced == 0) return;
  clear_progress_bar();
  fmt::print(stderr,
             "the rules come near to the tree, as they leave less free: of {} {} up to {:.2f} m "
             "off and {} left out\n",
             pluralize(way.elements, "element"), way.displaced, way.max_distance, way.missing);
}

/// The file of the tree's name, which a session finds without being told.
std::string grammar_file_of(const facade::Tree& tree, const Options& options) {
  std::string file = tree.name + ".vug";
  const fs::path folder = options.output.empty() ? fs::current_path() : folder_of(options.output);
  try {
    session::find_grammar_file(folder, file);
  } catch (const Error& error) {
    throw Error(
        error.code(), error.what(), {},
        fmt::format("'{}' is of a grammar '{}': name its file with --grammar, as in --grammar "
                    "out/{}",
                    options.from, tree.name, file));
  }
  return file;
}

/// A session that has come to what a file's tree is.
modeller::Session session_from_tree(Options options) {
  if (options.width > 0 || options.height > 0)
    throw Error(ErrorCode::bad_input, "a tree tells by itself how large the facade is", {},
                "leave --width and --height out");
  const facade::Tree tree = modeller::read_tree(read_text(options.from), options.from);
  if (options.grammar.empty()) options.grammar = grammar_file_of(tree, options);
  options.width = tree.width, options.height = tree.height;
  modeller::Session out = create_session(options);
  const modeller::TreeEdits way = modeller::tree_to_edits(out.now(), tree);
  for (const modeller::Edit& edit : way.edits) out.history.apply(edit);
  if (!options.work.quiet) print_deviation(way);
  return out;
}

modeller::Session read(const Options& options) {
  if (options.session.empty() && options.grammar.empty() && options.from.empty())
    throw Error(ErrorCode::bad_input, "there is no session", {},
                "name a session, or begin one with --grammar or --from");
  if (options.session.empty())
    return options.from.empty() ? create_session(options) : session_from_tree(options);
  if (const std::string told = options.first_creation_option(); !told.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("{} is for a session that begins, and '{}' has create_session", told,
                            options.session),
                {}, "leave it out, or begin another session with --grammar");
  return modeller::read_session(read_text(options.session), options.session,
                                session::facade_style_loader(folder_of(options.session)));
}

/// Tells where an earlier one of that name was.
void set_checkpoint(const Options& options, modeller::History& history) {
  const auto had = history.checkpoints().find(options.checkpoint);
  if (had != history.checkpoints().end() && had->second != history.done() && !options.work.quiet)
    fmt::print(stderr, "the checkpoint '{}' was after {} and is now after {}\n", options.checkpoint,
               pluralize(had->second, "edit"), history.done());
  history.set_checkpoint(options.checkpoint);
}

void edit(const Options& options, modeller::Session& session) {
  modeller::History& history = session.history;
  const auto want = [](int steps, size_t had, const char* what) {
    if (had < static_cast<size_t>(steps))
      throw Error(ErrorCode::bad_input, fmt::format("the session has {} to {}, not {}",
                                                    pluralize(had, "edit"), what, steps));
  };
  if (!options.to.empty()) history.restore(options.to);
  if (options.undo) want(options.undo, history.undo(static_cast<size_t>(options.undo)), "undo");
  if (options.redo) want(options.redo, history.redo(static_cast<size_t>(options.redo)), "do again");
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

/// Writes the session where it is asked for; names in it are seen from there.
void save(const Options& options, modeller::Session session) {
  const fs::path to = folder_of(options.output);
  if (!options.session.empty() && to != folder_of(options.session)) {
    const fs::path from = folder_of(options.session);
    if (fs::exists(from / session.header.grammar))
      session.header.grammar = relative_path_from(to, from / session.header.grammar);
    if (session.header.photo)
      session.header.photo->file = relative_path_from(to, from / session.header.photo->file);
  }
  write_text(options.output, modeller::session_text(session));
}

void draw(const Options& options, const modeller::Session& session) {
  const fs::path to = folder_of(options.svg);
  facade::SvgOptions drawing;
  if (!options.overlay.empty())
    drawing.picture = relative_path_from(to, options.overlay);
  else if (session.header.photo && !options.session.empty())
    drawing.picture =
        relative_path_from(to, folder_of(options.session) / session.header.photo->file);
  else if (!options.photo.empty())
    drawing.picture = relative_path_from(to, options.photo);
  write_text(options.svg, facade::elevation_svg(session.now().tree(), drawing));
}

/// Files that the session stands on.
std::vector<fs::path> dependencies_of(const Options& options, const modeller::Session& session) {
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

/// Of a wall too thin for its voxels, which hold it here and there.
void warn_of_thin_wall(const session::CarvingOptions& carving) {
  if (carving.thickness >= 2 * carving.voxel) return;
  const auto length = [](double metres) { return quantity_text(metres, Dimension::length); };
  fmt::print(stderr,
             "warning: a wall of {} is thinner than two voxels of {}, and may come out in shreds\n"
             "hint: --voxel {}, or --thickness {}\n",
             length(carving.thickness), length(carving.voxel), length(carving.thickness / 2),
             length(2 * carving.voxel));
}

int run(Options options) {
  const ThreadLimit threads(options.work.threads);
  if (!options.carve.empty() && extension_of(options.carve) != ".vdb")
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is no .vdb", options.carve), {},
                "--scene and 'vug build' make meshes of it");
  std::vector<fs::path> outputs, inputs;
  for (const std::string& file : {options.svg, options.scene, options.carve})
    if (!file.empty()) outputs.emplace_back(file);
  // A session may be written over itself.
  if (!options.output.empty() && options.output != options.session)
    outputs.emplace_back(options.output);
  for (const std::string& file :
       {options.session, options.photo, options.overlay, options.grammar, options.from})
    if (!file.empty()) inputs.emplace_back(file);
  require_outputs(outputs, inputs);
  modeller::Session session = read(options);
  require_outputs(outputs, dependencies_of(options, session));
  edit(options, session);
  // After what is wrong with the edits themselves.
  if (options.edited() && options.output.empty() && !options.prints() && !options.writes())
    throw Error(ErrorCode::bad_input, "what is done would be lost", {}, "-o SESSION.json keeps it");
  const modeller::FacadeState& state = session.now();
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

void add_edits(CLI::App& app, Options& options) {
  const auto add = [&](const char* name, std::vector<std::string>& to, const char* doc) {
    app.add_option(name, to, doc)->take_all()->allow_extra_args(false);
  };
  add("--apply", options.applied, "'NODE RULE name=value ...': divides an open node by one rule");
  add("--act", options.acts, "'NODE ACTION name=value ...': a rule, and what follows from it");
  std::string kinds;
  for (const modeller::EditKind* kind : modeller::edit_kinds())
    kinds += (kinds.empty() ? "" : ", ") + kind->name;
  app.add_option("--edit", options.edits,
                 fmt::format("'KIND NODE ...', where KIND is one of {}", kinds))
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--undo", options.undo, "edits, before others are done")
      ->transform(integer_in(1, 1000000000));
  app.add_option("--redo", options.redo, "of those that were undone")
      ->transform(integer_in(1, 1000000000));
  app.add_option("--to", options.to, "a checkpoint to go to, before all others");
  app.add_option("--checkpoint", options.checkpoint, "a name for what it is like at the end");
}

/// Edits of all options as they stand on the command line.
void order_edits(const CLI::App& app, Options& options) {
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
      "model", "Models a facade by hand: sessions of rules that are applied and retracted.",
      [](CLI::App& app) {
        auto options = std::make_shared<Options>();
        app.add_option("session", options->session, "a session to go on from");
        app.add_option("-o,--output", options->output, "where the session is written");
        auto* fresh = app.add_option_group("begin", "A session that begins");
        fresh->add_option("--grammar", options->grammar,
                          "a grammar of kind facade, as ripperda.vug");
        fresh->add_option("--from", options->from,
                          "a tree to begin with, as vug facade fit or vug tree --json write it");
        fresh->add_option("--facade", options->facade, "which grammar of the file");
        fresh->add_option("--width", options->width, "of the facade")
            ->transform(number_in(Dimension::length, 0.01, 1e5));
        fresh->add_option("--height", options->height, "of the facade; else as the photo's")
            ->transform(number_in(Dimension::length, 0.01, 1e5));
        fresh->add_option("--photo", options->photo,
                          "an upright picture that it is modelled after");
        add_edits(app, *options);
        app.add_option_function<std::string>(
               "--list", [options](const std::string& node) { options->list = node; },
               "rules of every node, or of one: which can be applied, and why others cannot")
            ->expected(0, 1)
            ->default_str(".");
        app.add_flag("--tree", options->tree, "prints the tree as text; so do no options at all");
        app.add_flag("--theta", options->theta,
                     "prints it in the notation of Ripperda and Brenner");
        app.add_flag("--json", options->json, "prints it as JSON");
        app.add_option("--svg", options->svg,
                       "draws the rectangles, over the photo if there is one");
        app.add_option("--overlay", options->overlay, "another picture to draw over");
        app.add_option("--scene", options->scene,
                       "writes it as a grammar with all sizes, a .vug, named as the file");
        app.add_option("--carve", options->carve, "writes a wall with the facade carved, a .vdb");
        app.add_option("--voxel", options->carving.voxel, "of the carved wall, 4cm without it")
            ->transform(number_in(Dimension::length, 1e-4, 10));
        app.add_option("--thickness", options->carving.thickness, "of the wall, 60cm without it")
            ->transform(number_in(Dimension::length, 1e-3, 100));
        options->work.add_to(app);
        return [options, &app] {
          order_edits(app, *options);
          return run(*options);
        };
      }};
}

}  // namespace vug::cli
