#include "arguments.h"
#include "bar.h"
#include "load.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/facade/tree_output.h>
#include <vug/session/data_folders.h>
#include <vug/session/facade_fit.h>
#include <vug/session/write.h>

#include <cctype>
#include <cstdio>

namespace vug::cli {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string photo, folder, name, width;
  std::string grammar;
  session::FacadePictureOptions picture;
  session::FacadeFitOptions fit;
  WorkOptions work;
  double metres = 12;
  bool no_carving = false;
};

/// A name that scenes can use, of a file's.
std::string name_of(const fs::path& file) {
  std::string out;
  for (const char c : file.stem().string())
    out += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  if (out.empty() || !std::isalpha(static_cast<unsigned char>(out[0]))) out = "facade_" + out;
  return out;
}

fs::path default_grammar() {
  for (const fs::path& folder : session::data_folders())
    if (fs::exists(folder / "facades/ripperda.vug")) return folder / "facades/ripperda.vug";
  throw Error(ErrorCode::bad_input, "data/facades/ripperda.vug is nowhere to be found", {},
              "name a grammar with --grammar, or set VUG_DATA");
}

/// As the drawing in `folder` names the file.
std::string seen_from(const fs::path& folder, const fs::path& file) {
  return fs::absolute(file)
      .lexically_normal()
      .lexically_relative(fs::absolute(folder).lexically_normal())
      .generic_string();
}

void carve(const std::string& scene, const fs::path& vug, const fs::path& vdb,
           const Options& options, Progress& progress) {
  const session::Loaded loaded = session::load_text(scene, vug.string());
  if (!loaded.usable())
    throw Error(ErrorCode::bad_input, "what was found cannot be carved:\n" + loaded.report());
  session::Builder builder(loaded.shot, options.work.build_options(loaded), progress);
  session::write_volumes(builder, vdb);
}

int run(Options options) {
  const ThreadLimit threads(options.work.threads);
  Progress& progress = terminal_progress(options.work.bar());
  const fs::path folder = options.folder;
  if (options.name.empty()) options.name = name_of(options.photo);
  const auto file = [&](const char* ending) { return folder / (options.name + ending); };
  std::vector<fs::path> outputs = {file(".vug"), file(".json"), file(".svg")};
  if (!options.no_carving) outputs.push_back(file(".vdb"));
  std::vector<fs::path> inputs = {options.photo};
  if (!options.picture.depth.empty()) inputs.push_back(options.picture.depth);
  require_outputs(outputs, inputs);

  options.fit.grammar = options.grammar.empty() ? default_grammar() : fs::path(options.grammar);
  options.fit.width = options.metres;
  const session::FacadePicture picture =
      session::read_facade_picture(options.photo, options.picture);
  const session::FacadeFit fit = session::fit_facade(picture, options.fit, progress);
  const std::string scene = session::facade_scene(
      fit, options.name, "Read from " + fs::path(options.photo).filename().string() + ".");
  write_text(outputs[0], scene);
  write_text(outputs[1], facade::tree_json(fit.tree));
  write_text(outputs[2],
             facade::elevation_svg(fit.tree, {.picture = seen_from(folder, options.photo)}));
  if (!options.no_carving && !fit.reading.sampled.stopped)
    carve(scene, outputs[0], outputs[3], options, progress);
  clear_bar();
  if (fit.reading.sampled.stopped) fmt::print(stderr, "stopped: this is the best tree so far\n");
  fmt::print("{}", facade::theta(fit.tree) + "\n");
  return kDone;
}

}  // namespace

Verb facade_fit_verb() {
  return {
      "fit", "Finds the tree of a facade grammar that a picture is most likely of.",
      [](CLI::App& app) {
        auto options = std::make_shared<Options>();
        app.add_option("photo", options->photo,
                       "an upright view without perspective: any picture, an EXR with a layer "
                       "of depth")
            ->required();
        app.add_option("-o,--output", options->folder, "the folder to write into")->required();
        app.add_option("--name", options->name, "of the files and the grammar; else the photo's");
        app.add_option("--depth", options->picture.depth,
                       "an EXR whose layer depth, or Z, tells how far the wall's parts stand out");
        app.add_option("--width", options->metres, "of the facade, 12m without it")
            ->transform(number_in(Dimension::length, 0.1, 1e4));
        app.add_option("--rows", options->picture.limits.height,
                       "of pixels that the picture is shrunk to")
            ->transform(whole_number_in(1, 4096));
        app.add_option("--grammar", options->grammar,
                       "a file with a grammar whose sizes are free, in place of ripperda.vug");
        app.add_option("--likelihood", options->fit.likelihood, "kt or paper")
            ->check(CLI::IsMember({"kt", "paper"}));
        app.add_option("--steps", options->fit.sampler.steps, "of each chain")
            ->transform(whole_number_in(1, 1000000000));
        app.add_option("--chains", options->fit.sampler.chains, "at different temperatures")
            ->transform(whole_number_in(1, 64));
        app.add_option("--seed", options->fit.seed, "of the chains")->transform(seed_number());
        app.add_flag("--no-carving", options->no_carving, "no .vdb");
        options->work.add_to(app);
        return [options] { return run(*options); };
      }};
}

}  // namespace vug::cli
