// SPDX-License-Identifier: Apache-2.0
// Views of OpenColorIO configurations as tables of values.
#include <vug/base/atomic_file.h>
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/image/backend.h>

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace vug::image::oiio {
namespace {
namespace ocio = OCIO_NAMESPACE;

/// A configuration from OpenColorIO's built-in transforms: our spaces, and ACES on an sRGB
/// display. The interchange space of colours is ACES2065-1, that of displays is CIE XYZ with a
/// white point of D65.
constexpr const char* kBuiltIn = R"(ocio_profile_version: 2
roles: {aces_interchange: ACES2065-1, cie_xyz_d65_interchange: XYZ, scene_linear: ACEScg}
file_rules: [!<Rule> {name: Default, colorspace: ACES2065-1}]
displays:
  sRGB: [!<View> {name: aces, view_transform: aces, display_colorspace: sRGB}]
active_displays: [sRGB]
view_transforms:
  - !<ViewTransform>
    name: aces
    from_scene_reference: !<BuiltinTransform>
      style: "ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0"
display_colorspaces:
  - !<ColorSpace> {name: XYZ}
  - !<ColorSpace>
    name: sRGB
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_sRGB}
colorspaces:
  - !<ColorSpace> {name: ACES2065-1}
  - !<ColorSpace>
    name: ACEScg
    to_scene_reference: !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
)";

/// ACES2065-1: AP0 of SMPTE ST 2065-1.
constexpr Chromaticities kAp0 = {0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.0770, 0.32168, 0.33767};

class ProcessorView final : public OcioView {
 public:
  ProcessorView(const ColourMatrix& to_source, ocio::ConstCPUProcessorRcPtr processor, bool srgb)
      : to_source_(to_source), processor_(std::move(processor)), srgb_(srgb) {}

  void apply(float* rgb, size_t pixels) const override {
    if (!to_source_.is_identity())
      for (size_t p = 0; p < pixels; ++p) {
        const Vec3d c = to_source_(Vec3d(Vec3f(rgb[3 * p], rgb[3 * p + 1], rgb[3 * p + 2])));
        for (size_t i = 0; i < 3; ++i) rgb[3 * p + i] = static_cast<float>(c[static_cast<int>(i)]);
      }
    ocio::PackedImageDesc picture(rgb, static_cast<long>(pixels), 1, 3);
    processor_->apply(picture);
  }
  bool srgb() const override { return srgb_; }

 private:
  ColourMatrix to_source_;  ///< To the source space of the processor.
  ocio::ConstCPUProcessorRcPtr processor_;
  bool srgb_;
};

struct Config {
  ocio::ConstConfigRcPtr ocio;
  std::string name;  ///< For messages.
};

/// The first of several lines.
std::string line_of(const char* text) {
  const std::string all = text;
  return all.substr(0, all.find('\n'));
}

Config open(const std::filesystem::path& file) {
  if (file.empty()) {
    std::istringstream text(kBuiltIn);
    return {ocio::Config::CreateFromStream(text), "without a configuration"};
  }
  const auto refuse = [&](const std::string& why) {
    return Error(
        ErrorCode::bad_input,
        fmt::format("the colour configuration '{}' cannot be used: {}", file.string(), why));
  };
  if (const std::string why = unreadable_reason(file); !why.empty()) throw refuse(why);
  try {
    const ocio::ConstConfigRcPtr config = ocio::Config::CreateFromFile(file.string().c_str());
    config->validate();
    return {config, fmt::format("in '{}'", file.string())};
  } catch (const ocio::Exception& error) {
    throw refuse(line_of(error.what()));
  }
}

std::vector<std::string> displays(const Config& config) {
  std::vector<std::string> names;
  for (int i = 0; i < config.ocio->getNumDisplays(); ++i)
    names.emplace_back(config.ocio->getDisplay(i));
  return names;
}

std::vector<std::string> views(const Config& config, const std::string& display) {
  std::vector<std::string> names;
  for (int i = 0; i < config.ocio->getNumViews(display.c_str()); ++i)
    names.emplace_back(config.ocio->getView(display.c_str(), i));
  return names;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The colour space of the configuration in which colours enter, and the matrix to it.
std::pair<std::string, ColourMatrix> input_space(const Config& config, WorkingSpace space) {
  for (const std::string& name : info(space).aliases)
    if (const auto found = config.ocio->getColorSpace(name.c_str())) return {found->getName(), {}};
  if (config.ocio->hasRole("aces_interchange"))
    return {"aces_interchange", {info(space).chromaticities, kAp0}};
  std::vector<std::string> names;
  for (int i = 0; i < config.ocio->getNumColorSpaces(); ++i)
    names.emplace_back(config.ocio->getColorSpaceNameByIndex(i));
  throw Error(ErrorCode::bad_input,
              fmt::format("no linear colour space {} has the primaries of {}", config.name,
                          info(space).name),
              {},
              fmt::format("give one of them the alias '{}', or the role aces_interchange: {}",
                          info(space).public_name, fmt::join(names, ", ")));
}

}  // namespace

ViewOptions ocio_view(const ViewSelection& choice, WorkingSpace space,
                      std::optional<ViewTransform> builtin) {
  ViewOptions options;
  options.space = space;
  const Config config = open(choice.config);
  const auto refuse = [&](const char* what, const std::string& name,
                          const std::vector<std::string>& there) {
    const std::string near = did_you_mean(name, there);
    return Error(
        ErrorCode::bad_input, fmt::format("unknown {} '{}' {}", what, name, config.name), {},
        fmt::format("{}{}known: {}", near, near.empty() ? "" : " ", fmt::join(there, ", ")));
  };
  const std::vector<std::string> screens = displays(config);
  const std::string display =
      choice.display.empty() ? config.ocio->getDefaultDisplay() : choice.display;
  if (!holds(screens, display)) throw refuse("display", display, screens);
  std::vector<std::string> names = views(config, display);
  const std::string view =
      choice.view.empty() ? config.ocio->getDefaultView(display.c_str()) : choice.view;
  if (!holds(names, view)) {
    if (builtin) {
      options.transform = *builtin;
      return options;
    }
    for (const char* name : {"filmic", "standard"})
      if (!holds(names, name)) names.emplace_back(name);
    throw refuse("view", view, names);
  }
  const auto [source, to_source] = input_space(config, space);
  try {
    const auto transform = ocio::DisplayViewTransform::Create();
    transform->setSrc(source.c_str());
    transform->setDisplay(display.c_str());
    transform->setView(view.c_str());
    const bool srgb = display.find("sRGB") != std::string::npos;
    options.ocio = std::make_shared<const ProcessorView>(
        to_source, config.ocio->getProcessor(transform)->getDefaultCPUProcessor(), srgb);
  } catch (const ocio::Exception& error) {
    throw Error(ErrorCode::bad_input, fmt::format("the view '{}' {} cannot be used: {}", view,
                                                  config.name, line_of(error.what())));
  }
  return options;
}

}  // namespace vug::image::oiio
