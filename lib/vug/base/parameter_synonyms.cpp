// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parameter_synonyms.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace vug {
namespace {

/// Words with about the same meaning; of several in one kind, the first is suggested. The words are
/// those of pbrt, Mitsuba, Cycles, Arnold, Houdini and USD.
using Meaning = std::initializer_list<std::string_view>;
const std::initializer_list<Meaning> kMeanings = {
    // pictures
    {"size", "resolution", "dimensions", "res"},
    {"spp", "samples", "sample_count", "pixel_samples", "samples_per_pixel"},
    {"max_bounces", "max_depth", "bounces", "depth", "ray_depth"},
    {"denoise", "denoiser", "denoising"},
    {"exposure", "ev", "brightness"},
    {"crop", "crop_window", "border", "region"},
    {"camera", "sensor"},
    // cameras
    {"eye", "center", "position", "origin", "location", "from", "pos", "centre"},
    {"target", "look_at", "lookat", "aim", "interest", "to"},
    {"fov", "field_of_view", "angle_of_view", "focal_length", "lens"},
    {"aperture", "lens_radius", "aperture_radius", "fstop", "f_stop"},
    {"focus", "focus_distance", "focal_distance"},
    {"shutter", "motion_blur", "shutter_close"},
    // lights
    {"radiance", "irradiance", "lumen", "power", "emission", "intensity", "color", "colour",
     "strength", "energy", "emit", "watt", "watts", "L"},
    {"temperature", "kelvin", "blackbody"},
    {"normal", "direction", "dir", "orientation"},
    // materials
    {"color", "albedo", "base_color", "diffuse", "colour", "reflectance", "base_colour"},
    {"roughness", "alpha", "glossiness", "shininess"},
    {"metal", "metalness", "metallic"},
    {"ior", "eta", "index_of_refraction"},
    {"transmission", "refraction", "transparency"},
    {"coat", "clearcoat"},
    {"fuzz", "sheen"},
    {"bump", "bump_map", "normal_map"},
    {"mean_free_path", "subsurface_radius", "sss_radius"},
    {"extinction", "density", "sigma_t"},
    // shapes
    {"radius", "r", "rad"},
    {"diameter", "d"},
    {"size", "dimensions", "extent", "extents", "length", "scale", "side"},
    {"height", "h", "tall"},
    {"width", "w"},
    {"length", "l"},
    {"center", "centre", "position", "origin", "location"},
    {"rounding", "bevel", "round", "fillet", "corner_radius"},
    {"by", "factor", "offset", "vector", "amount"},
    {"angle", "degrees", "rotation"},
    // noises and detail
    {"scale", "frequency", "freq", "size", "wavelength", "period"},
    {"amount", "strength", "amplitude", "height", "intensity", "displacement"},
    {"octaves", "levels", "detail", "iterations"},
    {"gain", "persistence"},
    {"spacing", "distance", "step", "separation"},
    {"count", "number", "n", "num"},
    {"counts", "number", "n", "count"},
    {"voxel", "voxel_size", "resolution", "cell_size"},
    {"half_width", "band", "band_width", "narrow_band"},
    {"of", "network", "input", "source"},
    {"file", "path", "filename", "file_name"},
    {"seed", "random_seed", "rng"},
};

}  // namespace

std::string parameter_for(const std::string& name, const std::vector<std::string>& candidates) {
  for (const Meaning& meaning : kMeanings) {
    if (std::find(meaning.begin(), meaning.end(), name) == meaning.end()) continue;
    for (const std::string_view word : meaning)
      if (std::find(candidates.begin(), candidates.end(), word) != candidates.end())
        return std::string(word);
  }
  return "";
}

}  // namespace vug
