// SPDX-License-Identifier: Apache-2.0
// vug facade rectify: removes the perspective from an oblique photo of a facade.
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

struct FacadeRectifyOptions {
  std::string photo, output, size, onto;
  std::vector<std::string> corners, at;
  scan::RectifyOptions rectify;
  WorkOptions work;
};

constexpr const char* kInPhoto = "position in the photo; expected X,Y in pixels without a unit";

/// Units of a pair of numbers.
enum class Unit { pixels, lengths };

/// Parses a number and ignores blanks around it.
std::optional<Number> number_of(std::string_view text) {
  const size_t first = text.find_first_not_of(' ');
  if (first == text.npos) return std::nullopt;
  return scene::read_number(text.substr(first, text.find_last_not_of(' ') + 1 - first));
}

/// Parses two numbers separated by `between`: plain ones, or lengths if `in` permits them.
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
  throw Error(ErrorCode::bad_input, fmt::format("'{}' is not a {}", text, what));
}

scan::FourPoints parse_points(const std::vector<std::string>& texts, Unit in, const char* what) {
  scan::FourPoints out;
  if (texts.size() != out.size())
    throw Error(ErrorCode::bad_input,
                fmt::format("a rectangle has four corners, but {} given: '{}'",
                            texts.size() == 1 ? "one is" : fmt::format("{} are", texts.size()),
                            fmt::join(texts, " ")),
                {}, "write four pairs X,Y separated by blanks, e.g. 0,0 90,0 90,120 0,120");
  for (size_t i = 0; i < 4; ++i) {
    const auto [x, y] = parse_pair(texts[i], ',', in, what);
    out[i] = {x.value, y.value};
  }
  return out;
}

/// Writes the picture. An EXR contains the size of the facade if that is known.
void write_rectified(const std::string& file, const scan::RectifiedPhoto& out, bool metres) {
  if (extension_of(file) != ".exr") return image::write_png(file, out.picture, image::plain_view());
  image::ExrOptions options;
  if (metres) options.metadata = scan::pixel_metadata(out.width / out.picture.width);
  image::write_exr(file, out.picture, options);
}

image::Image laid_over(const scan::RangeImage& range, const FacadeRectifyOptions& options,
                       const image::Image& photo) {
  if (options.corners.empty()) return scan::overlay_photo(range, photo, options.rectify.memory);
  const scan::FourPoints corners = parse_points(options.corners, Unit::pixels, kInPhoto);
  if (!options.at.empty())
    return scan::overlay_photo(
        range, photo, corners,
        parse_points(options.at, Unit::lengths, "position; expected X,Y in metres"),
        options.rectify.memory);
  const double wide = range.metres_wide(), high = range.metres_high();
  return scan::overlay_photo(range, photo, corners,
                             {Vec2d(0, high), Vec2d(wide, high), Vec2d(wide, 0), Vec2d(0, 0)},
                             options.rectify.memory);
}

/// Sets the size of the rectangle. Returns whether it is in metres rather than a ratio or missing.
bool set_size(const std::string& text, scan::RectifyOptions& to) {
  if (text.empty()) return false;
  const auto [wide, high] =
      parse_pair(text, 'x', Unit::lengths, "size; expected e.g. 12mx9m or 4x3");
  if (!(wide.value > 0 && high.value > 0))
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid size '{}': width and height must be above 0", text), {},
                "write, for instance, 12mx9m or 4x3");
  if (wide.dimension != high.dimension)
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid size '{}': only one number has a unit", text), {},
                "write metres as in 12mx9m, or a ratio as in 4x3");
  to.width = wide.value, to.height = high.value;
  return wide.dimension == Dimension::length;
}

/// Error(bad_input) for options that do not go together: a range image already has a size, and the
/// position of the photo on it is given by points.
void require_consistent(const FacadeRectifyOptions& options) {
  if (options.onto.empty()) return;
  for (const auto& [name, told] :
       {std::pair("--size", !options.size.empty()), {"--pixel", options.rectify.pixel > 0}})
    if (told)
      throw Error(ErrorCode::bad_input,
                  fmt::format("{} does not apply with --onto, which uses the size and the "
                              "pixels of the range image",
                              name),
                  {}, "remove it; --at gives the positions of --corners on the range image");
  if (!options.at.empty() && options.corners.empty())
    throw Error(ErrorCode::bad_input, "--at requires --corners", {},
                "write --corners in pixels of the photo");
}

int run_facade_rectify(FacadeRectifyOptions options) {
  const bool exr = extension_of(options.output) == ".exr";
  if (!exr) require_extension(options.output, ".png", "the output is an .exr or a .png");
  if (!options.onto.empty() && !exr)
    throw Error(ErrorCode::bad_input, "the output of --onto has depths and must be an EXR", {},
                "name an .exr with -o");
  if (options.onto.empty() && options.corners.empty())
    throw Error(ErrorCode::bad_input, "the corners of the facade are missing", {},
                "write --corners: upper left, upper right, lower right, lower left");
  require_consistent(options);
  std::vector<std::filesystem::path> inputs = {options.photo};
  if (!options.onto.empty()) inputs.emplace_back(options.onto);
  require_outputs({options.output}, inputs);
  options.rectify.memory = options.work.memory_limit();
  const bool metres = set_size(options.size, options.rectify);
  if (options.rectify.pixel > 0 && !metres)
    throw Error(ErrorCode::bad_input, "--pixel is a length, but the size of the facade is unknown",
                {}, "write --size in metres, e.g. 12mx9m");
  const image::Image photo = fit::read_with_limit(options.photo, image::read_info(options.photo),
                                                  options.work.memory_limit());
  if (!options.onto.empty()) {
    const scan::RangeImage range = scan::read_range(options.onto, 0, options.rectify.memory);
    image::ExrOptions exr_options;
    exr_options.metadata = scan::range_metadata(range);
    image::write_exr(options.output, laid_over(range, options, photo), exr_options);
    return kDone;
  }
  const scan::RectifiedPhoto out =
      scan::rectify(photo, parse_points(options.corners, Unit::pixels, kInPhoto), options.rectify);
  write_rectified(options.output, out, metres);
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
      "rectify", "Removes the perspective from a photo of a facade.", [](CLI::App& app) {
        auto o = std::make_shared<FacadeRectifyOptions>();
        app.add_option("photo", o->photo, "Photo in any format")->required();
        app.add_option("-o,--output", o->output, "Output file, an .exr or .png")->required();
        app.add_option(
               "--corners", o->corners,
               "Corners of a rectangle on the facade, X,Y X,Y X,Y X,Y: in pixels from the "
               "photo's upper left corner, clockwise from the rectangle's upper left corner")
            ->expected(1, 4);
        app.add_option(
            "--size", o->size,
            "Size of that rectangle, 12mx9m, or the ratio of its sides, 4x3; default: the "
            "ratio follows from the perspective");
        app.add_option(
               "--pixel", o->rectify.pixel,
               "Pixel size of the output if --size is in metres; default: the resolution of the "
               "photo")
            ->transform(number_in(Dimension::length, 1e-6, 1e3));
        auto* onto = app.add_option("--onto", o->onto,
                                    "Range image of vug facade scan, onto which the photo is "
                                    "projected; the output also contains the depths");
        app.add_option(
               "--at", o->at,
               "Positions of the corners on the range image, X,Y X,Y X,Y X,Y: in metres from "
               "its lower left corner; default: its corners")
            ->expected(1, 4)
            ->needs(onto);
        o->work.add_to(app);
        return
            [o] { return with_threads(o->work.threads, [&] { return run_facade_rectify(*o); }); };
      }};
}

}  // namespace vug::cli
