// vug facade rectify: a photo taken at a slant becomes a view without perspective.
#include "arguments.h"
#include "output_files.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/fit/evidence/working_size.h>
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

constexpr const char* kInPhoto = "place in the photo, X,Y in pixels without a unit";

/// What two numbers may be told in.
enum class Unit { pixels, lengths };

/// A number without blanks around it.
std::optional<Number> number_of(std::string_view text) {
  const size_t first = text.find_first_not_of(' ');
  if (first == text.npos) return std::nullopt;
  return scene::read_number(text.substr(first, text.find_last_not_of(' ') + 1 - first));
}

/// Two numbers around `between`: plain ones, or lengths where these are taken.
std::pair<Number, Number> parse_pair(const std::string& text, char between, Unit in,
                                     const char* what) {
  const size_t cut = text.find(between);
  if (cut != std::string::npos) {
    const auto a = number_of(std::string_view(text).substr(0, cut));
    const auto b = number_of(std::string_view(text).substr(cut + 1));
    const auto is_valid = [in](const std::optional<Number>& n) {
      return n && (n->dimension == Dimension::none ||
                   (in == Unit::lengths && n->dimension == Dimension::length));
    };
    if (is_valid(a) && is_valid(b)) return {*a, *b};
  }
  throw Error(ErrorCode::bad_input, fmt::format("'{}' is no {}", text, what));
}

scan::FourPoints parse_points(const std::vector<std::string>& texts, Unit in, const char* what) {
  scan::FourPoints out;
  if (texts.size() != out.size())
    throw Error(ErrorCode::bad_input,
                fmt::format("a rectangle has four corners, and {} told: '{}'",
                            texts.size() == 1 ? "one is" : fmt::format("{} are", texts.size()),
                            fmt::join(texts, " ")),
                {}, "four of X,Y with blanks between them, as 0,0 90,0 90,120 0,120");
  for (size_t i = 0; i < 4; ++i) {
    const auto [x, y] = parse_pair(texts[i], ',', in, what);
    out[i] = {x.value, y.value};
  }
  return out;
}

/// An EXR tells how large the facade is, if that is known.
void write(const std::string& file, const scan::RectifiedPhoto& out, bool metres) {
  if (extension_of(file) != ".exr") return image::write_png(file, out.picture, image::plain_view());
  image::ExrOptions options;
  if (metres) options.metadata = scan::pixel_metadata(out.width / out.picture.width);
  image::write_exr(file, out.picture, options);
}

image::Image laid_over(const scan::RangeImage& range, const Options& options,
                       const image::Image& photo) {
  if (options.corners.empty()) return scan::overlay_photo(range, photo, options.rectify.memory);
  const scan::FourPoints corners = parse_points(options.corners, Unit::pixels, kInPhoto);
  if (!options.at.empty())
    return scan::overlay_photo(range, photo, corners,
                           parse_points(options.at, Unit::lengths, "place in metres, X,Y"),
                           options.rectify.memory);
  const double wide = range.metres_wide(), high = range.metres_high();
  return scan::overlay_photo(range, photo, corners,
                         {Vec2d(0, high), Vec2d(wide, high), Vec2d(wide, 0), Vec2d(0, 0)},
                         options.rectify.memory);
}

/// True where the size is in metres, not only a ratio, or nothing.
bool set_size(const std::string& text, scan::RectifyOptions& to) {
  if (text.empty()) return false;
  const auto [wide, high] = parse_pair(text, 'x', Unit::lengths, "size, as 12mx9m or 4x3");
  if (!(wide.value > 0 && high.value > 0))
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is no size", text), {},
                "width and height are above 0, as in 12mx9m or 4x3");
  if (wide.dimension != high.dimension)
    throw Error(ErrorCode::bad_input, fmt::format("'{}' has a unit at one side only", text), {},
                "12mx9m are metres, 4x3 is the ratio of the sides");
  to.width = wide.value, to.height = high.value;
  return wide.dimension == Dimension::length;
}

/// A range image has a size, and where the photo lies on it is told by places.
void require_consistent(const Options& options) {
  if (options.onto.empty()) return;
  for (const auto& [name, told] :
       {std::pair("--size", !options.size.empty()), {"--pixel", options.rectify.pixel > 0}})
    if (told)
      throw Error(ErrorCode::bad_input,
                  fmt::format("{} is for a picture of its own: --onto gives it the size and the "
                              "pixels of the range image",
                              name),
                  {}, "leave it out; --at tells where --corners lie on the range image");
  if (!options.at.empty() && options.corners.empty())
    throw Error(ErrorCode::bad_input, "--at tells where corners lie, and none are named", {},
                "name them with --corners, in pixels of the photo");
}

int run(Options options) {
  const ThreadLimit threads(options.work.threads);
  const bool exr = extension_of(options.output) == ".exr";
  if (!exr) require_extension(options.output, ".png", "the output is a .exr or a .png");
  if (!options.onto.empty() && !exr)
    throw Error(ErrorCode::bad_input, "what is laid over a range image has depths", {},
                "write an .exr");
  if (options.onto.empty() && options.corners.empty())
    throw Error(ErrorCode::bad_input, "the corners of the facade are missing", {},
                "name them with --corners: upper left, upper right, lower right, lower left");
  require_consistent(options);
  std::vector<std::filesystem::path> inputs = {options.photo};
  if (!options.onto.empty()) inputs.emplace_back(options.onto);
  require_outputs({options.output}, inputs);
  options.rectify.memory = options.work.memory_limit();
  const bool metres = set_size(options.size, options.rectify);
  if (options.rectify.pixel > 0 && !metres)
    throw Error(ErrorCode::bad_input,
                "--pixel is a length, and nothing tells how large the facade is", {},
                "--size does, in metres: 12mx9m");
  const image::Image photo = fit::read_with_limit(options.photo, image::read_info(options.photo),
                                                  options.work.memory_limit());
  if (!options.onto.empty()) {
    const scan::RangeImage range = scan::read_range(options.onto, 0, options.rectify.memory);
    image::ExrOptions exr_options;
    exr_options.metadata = scan::range_metadata(range);
    image::write_exr(options.output, laid_over(range, options, photo), exr_options);
    return kDone;
  }
  const scan::RectifiedPhoto out = scan::rectify(
      photo, parse_points(options.corners, Unit::pixels, kInPhoto), options.rectify);
  write(options.output, out, metres);
  fmt::print("{} x {} pixels, {:.4g} x {:.4g}{}\n", out.picture.width, out.picture.height,
             out.width, out.height,
             options.size.empty() ? " (the ratio, from the perspective)"
             : metres             ? " m"
                                  : " (the ratio)");
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
        app.add_option(
               "--pixel", o->rectify.pixel,
               "size of the picture's pixels, where --size is in metres; without it as fine as the "
               "photo")
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
