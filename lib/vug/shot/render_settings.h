// SPDX-License-Identifier: Apache-2.0
// The settings of a picture: each is a member and a row of one table, to which the `render` block,
// the options of the command, the arguments of Python and partial renders bind.
#pragma once

#include <vug/base/kind.h>
#include <vug/image/colour_space.h>
#include <vug/render/integrator.h>
#include <vug/render/sampler.h>
#include <vug/render/scene.h>
#include <vug/shot/exposure.h>
#include <vug/shot/quality.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug::shot {

/// The names of the working spaces, for the table.
std::vector<std::pair<std::string, image::WorkingSpace>> working_space_names();

/// Encoding and display of a picture. Partial renders contain these settings, because merging
/// writes the picture.
struct OutputSettings {
  Exposure exposure;        ///< Exposure of the PNG.
  double compensation = 0;  ///< Stops added to an exposure that is not a number of stops.
  double iso = PhysicalExposure{}.iso, f_number = PhysicalExposure{}.f_number,
         exposure_time = PhysicalExposure{}.time;  ///< See PhysicalExposure.
  bool half = true;                                ///< 16-bit colour channels in the EXR.
  bool multi_part = false;                         ///< One part of the EXR per AOV.
  bool tiled = false;                              ///< Tiles instead of scan lines.
  bool denoise = false;  ///< Add a denoised AOV, which the PNG shows; see image::denoise.
  image::WorkingSpace working_space = image::WorkingSpace::rec709;
  std::string view, display;  ///< Display transform of the PNG; see image::ViewSelection.

  /// Adds the rows to a table: a Schema, or another class with its functions.
  template <class Table>
  static void describe(Table& table) {
    table
        .number_or_name("exposure", &OutputSettings::exposure, exposure_names(),
                        {.doc = "exposure of the PNG in stops; auto: metered from the picture; "
                                "locked: from the first frame of a sequence; physical: that of a "
                                "camera with 'iso', 'f_number' and 'exposure_time'",
                         .min = -30,
                         .max = 30})
        .param("compensation", &OutputSettings::compensation,
               {.doc = "stops added to the exposures auto, locked and physical",
                .min = -30,
                .max = 30})
        .param("iso", &OutputSettings::iso,
               {.doc = "film speed of the physical exposure", .min = 1, .max = 10'000'000})
        .param("f_number", &OutputSettings::f_number,
               {.doc = "f-number of the physical exposure, such as 2.8", .min = 0.5, .max = 128})
        .param("exposure_time", &OutputSettings::exposure_time,
               {.doc = "exposure time of the physical exposure, such as 20ms",
                .dimension = Dimension::time,
                .min = 1e-6,
                .max = 1e5})
        .param("half", &OutputSettings::half, {.doc = "store colours as 16-bit floats"})
        .param("multi_part", &OutputSettings::multi_part,
               {.doc = "one part of the EXR per AOV, instead of a single part"})
        .param("tiled", &OutputSettings::tiled, {.doc = "write a tiled EXR instead of scan lines"})
        .param("denoise", &OutputSettings::denoise,
               {.doc = "denoise the PNG; the EXR gets an additional layer 'denoised'"})
        .template choice<image::WorkingSpace>(
            "working_space", &OutputSettings::working_space, working_space_names(),
            "primaries of the light computation and of the EXR: those of linear Rec.709 or of "
            "ACEScg; colours in the text are always Rec.709")
        .param("view", &OutputSettings::view,
               {.doc = "display transform of the PNG: filmic, standard, aces, or a view of the "
                       "OpenColorIO configuration; default: filmic, or that of the configuration"})
        .param("display", &OutputSettings::display,
               {.doc = "a display of the OpenColorIO configuration; default: its default display"});
  }
};

/// All settings of a `render` block.
struct RenderSettings : OutputSettings {
  std::vector<int> size = {960, 540};  ///< Width and height in pixels.
  int spp = 64;
  /// See apply_quality.
  Quality quality = Quality::unstated;
  bool deep = false;                ///< Write a deep EXR in addition.
  double deep_tolerance = 0.01;     ///< See render::DeepOptions.
  double noise = 0;                 ///< See render::Options.
  bool openings = true;             ///< See render::Options.
  std::vector<std::string> layers;  ///< Names of AOVs, as in render::plan_aovs.
  std::vector<int> crop;            ///< Left, top, right and bottom in pixels; empty: no crop.
  render::CameraPtr camera;         ///< Null: the camera with the name of the plan, else the first.
  render::SamplerPtr sampler;
  render::IntegratorPtr integrator;
  /// Names of the lights, and of the objects and places, that take part; nothing: all of them.
  std::optional<std::vector<std::string>> lights, objects;
  std::string air;  ///< Name of the medium, or "none"; empty: the only medium of the scene.

  template <class Table>
  static void describe(Table& table) {
    table.doc("The settings of a picture: render NAME { size 1920x1080  spp 256 }.")
        .param("size", &RenderSettings::size,
               {.doc = "width and height in pixels, as 1920x1080", .min = 1, .max = 65535})
        .param("spp", &RenderSettings::spp, {.doc = "samples per pixel", .min = 1, .max = 1 << 20})
        .template choice<Quality>(
            "quality", &RenderSettings::quality, quality_names(),
            "values of spp, noise and denoise: draft 16 samples, denoised; look: at most 128 "
            "samples, noise 8%, denoised; final: at most 4096 samples, noise 2%; default: look, if "
            "neither spp nor noise is given");
    OutputSettings::describe(table);
    table
        .param("deep", &RenderSettings::deep,
               {.doc = "write a deep EXR in addition, named .deep.exr"})
        .param("deep_tolerance", &RenderSettings::deep_tolerance,
               {.doc = "merge surfaces of a pixel whose relative difference in depth is below this",
                .min = 0,
                .max = 1})
        .param("noise", &RenderSettings::noise,
               {.doc = "stop sampling where the relative error is below this, such as 5%; 0: never",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("openings", &RenderSettings::openings,
               {.doc = "sample the openings through which the sky shines in, if no portal is "
                       "declared; affects only the noise"})
        .param("layers", &RenderSettings::layers,
               {.doc = "names of AOVs, such as [\"beauty\", \"Z\"], or \"all\"; default: the usual "
                       "AOVs"})
        .param("crop", &RenderSettings::crop,
               {.doc = "left, top, right and bottom in pixels of the part to render",
                .min = 0,
                .max = 65535})
        .param("camera", &RenderSettings::camera,
               {.doc = "a declared camera; default: the camera with the name of the render, else "
                       "the first"})
        .param("sampler", &RenderSettings::sampler,
               {.doc = "sampler of random numbers; default: sobol"})
        .param("integrator", &RenderSettings::integrator,
               {.doc = "integrator, such as path(max_bounces: 6); default: path()"})
        .param("lights", &RenderSettings::lights,
               {.doc = "names of the lights that take part, such as [key, fill]; default: all"})
        .param("objects", &RenderSettings::objects,
               {.doc = "names of the objects and places that take part; default: all"})
        .param("air", &RenderSettings::air,
               {.doc = "name of the medium that fills the scene, or none; default: the only one"});
  }
};

/// The table as a schema.
const Schema<RenderSettings>& render_schema();

/// A setting whose value has a valid type but not the required form.
struct SettingFault {
  std::string setting, message, hint;
};
std::optional<SettingFault> find_fault(const RenderSettings& settings);

/// The settings with some of them replaced, such as {{"spp", 16}, {"tiled", true}}; the last of
/// several values of a setting counts. Error(bad_input) for unknown names and invalid values.
RenderSettings with_overrides(const RenderSettings& settings, const NamedValues& overrides);

/// The values as text by name, in the order of the table, and back. Unknown names are ignored.
/// Error(bad_input) for invalid values.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;
NamedTexts to_texts(const OutputSettings& settings);
OutputSettings from_texts(const NamedTexts& texts);

}  // namespace vug::shot
