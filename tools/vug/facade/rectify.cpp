// vug facade rectify: a photo taken at a slant becomes a view without perspective.
#include "arguments.h"
#include "bar.h"
#include "files.h"
#include "load.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/fit/working_size.h>
#include <vug/image/io.h>
#include <vug/scan/rectify.h>
#include <vug/scene/lexer.h>

namespace vug::cli {
namespace {

struct Options {
  std::string photo, output, size, onto;
  std::vector<std::string> corners, at;
  scan::RectifyOptions rectify;
  WorkOptions work;
};

/// Two numbers around `between`, of lengths or of none.
std::pair<Number, Number> pair_of(const std::string& text, char between, const char* what) {
  const size_t cut = text.find(between);
  if (cut != std::string::npos) {
    const auto a = scene::read_number(text.substr(0, cut));
    const auto b = scene::read_number(text.substr(cut + 1));
    const auto sound = [](const std::optional<Number>& n) {
      return n && (n->dimension == Dimension::none || n->dimension == Dimension::length);
    };
    if (sound(a) && sound(b)) return {*a, *b};
  }
  throw Error(ErrorCode::bad_input, fmt::format("'{}' is no {}", text, what));
}

scan::FourPoints points_of(const std::vector<std::string>& texts, const char* what) {
  scan::FourPoints out;
  if (texts.size() != out.size())
    throw Error(ErrorCode::bad_input,
                fmt::format("a rectangle has four corners, and {} told: '{}'",
                            texts.size() == 1 ? "one is" : fmt::format("{} are", texts.size()),
                            fmt::join(texts, " ")),
                {}, "four of X,Y with blanks between them, as 0,0 90,0 90,120 0,120");
  for (size_t i = 0; i < 4; ++i) {
    const auto [x, y] = pair_of(texts[i], ',', what);
    out[i] = {x.value, y.value};
  }
  return out;
}

/// An EXR tells how large the facade is, if that is known.
void write(const std::string& file, const scan::Rectified& out, bool metres) {
  if (extension_of(file) != ".exr") return write_plain_png(file, out.picture);
  image::ExrOptions options;
  if (metres) options.metadata = scan::metadata_of_pixel(out.width / out.picture.width);
  image::write_exr(file, out.picture, options);
}

image::Image laid_over(const scan::RangeImage& range, const Options& options,
                       const image::Image& photo) {
  if (options.corners.empty()) return scan::laid_over(range, photo, options.rectify.memory);
  const scan::FourPoints corners = points_of(options.corners, "place in the photo, X,Y");
  if (!options.at.empty())
    return scan::laid_over(range, photo, corners, points_of(options.at, "place in metres, X,Y"),
                           options.rectify.memory);
  const double wide = range.metres_wide(), high = range.metres_high();
  return scan::laid_over(range, photo, corners,
                         {Vec2d(0, high), Vec2d(wide, high), Vec2d(wide, 0), Vec2d(0, 0)},
                         options.rectify.memory);
}

int run(Options options) {
  const ThreadLimit threads(options.work.threads);
  const bool exr = extension_of(options.output) == ".exr";
  if (!exr) require_ending(options.output, ".png", "the output is a .exr or a .png");
  if (!options.onto.empty() && !exr)
    throw Error(ErrorCode::bad_input, "what is laid over a range image has depths", {},
                "write an .exr");
  if (options.onto.empty() && options.corners.empty())
    throw Error(ErrorCode::bad_input, "the corners of the facade are missing", {},
                "name them with --corners: upper left, upper right, lower right, lower left");
  std::vector<std::filesystem::path> inputs = {options.photo};
  if (!options.onto.empty()) inputs.emplace_back(options.onto);
  require_outputs({options.output}, inputs);
  options.rectify.memory = options.work.memory_limit();
  bool metres = false;
  if (!options.size.empty()) {
    const auto [wide, high] = pair_of(options.size, 'x', "size, as 12mx9m or 4x3");
    if (!(wide.value > 0 && high.value > 0))
      throw Error(ErrorCode::bad_input, fmt::format("'{}' is no size", options.size), {},
                  "width and height are above 0, as in 12mx9m or 4x3");
    options.rectify.width = wide.value, options.rectify.height = high.value;
    metres = wide.dimension == Dimension::length || high.dimension == Dimension::length;
  }
  const image::Image photo =
      fit::read_within(options.photo, image::read_info(options.photo), options.work.memory_limit());
  if (!options.onto.empty()) {
    const scan::RangeImage range = scan::read_range(options.onto, 0, options.rectify.memory);
    image::ExrOptions exr_options;
    exr_options.metadata = scan::metadata_of(range);
    image::write_exr(options.output, laid_over(range, options, photo), exr_options);
    return kDone;
  }
  const scan::Rectified out = scan::rectified(
      photo, points_of(options.corners, "place in the photo, X,Y"), options.rectify);
  write(options.output, out, metres);
  fmt::print("{} x {} pixels, {:.4g} x {:.4g}{}\n", out.picture.width, out.picture.height,
             out.width, out.height, options.size.empty() ? " (from the perspective)" : "");
  return kDone;
}

}  // namespace

Verb facade_rectify_verb() {
  return {
      "rectify", "Makes a view without perspective of a photo of a facade.", [](CLI::App& app) {
        auto o = std::make_shared<Options>();
        app.add_option("photo", o->photo, "any picture")->required();
        app.add_option("-o,--output", o->output, ".exr or .png")->required();
        app.add_option("--corners", o->corners,
                       "X,Y X,Y X,Y X,Y: of a rectangle on the facade, in pixels from the photo's "
                       "upper left corner, clockwise from the rectangle's")
            ->expected(1, 4);
        app.add_option("--size", o->size,
                       "of that rectangle, 12mx9m, or only the ratio of its sides, 4x3; without it "
                       "the ratio follows from the perspective");
        app.add_option("--pixel", o->rectify.pixel,
                       "size of the picture's pixels; without it as fine as the photo")
            ->transform(number_in(Dimension::length, 1e-6, 1e3));
        auto* onto = app.add_option("--onto", o->onto,
                                    "a range image of vug facade scan: the photo is laid over it, "
                                    "and depths are written too");
        app.add_option("--at", o->at,
                       "X,Y X,Y X,Y X,Y: where the corners lie on the range image, in metres from "
                       "its lower left corner; without it they are its corners")
            ->expected(1, 4)
            ->needs(onto);
        o->work.add_to(app);
        return [o] { return run(*o); };
      }};
}

}  // namespace vug::cli
