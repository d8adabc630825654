// SPDX-License-Identifier: Apache-2.0
// Lamps for a shot: places that a photographer would try, and the best few of them.
#pragma once

#include <vug/scout/illumination.h>
#include <vug/scout/location.h>
#include <vug/scout/pose.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::scout {

/// What a lamp does in the picture.
enum class LampRole {
  key,     ///< A panel outside the picture, 35 to 60 degrees from the view axis, on the subject.
  rim,     ///< A panel behind the subject, hidden from the eye.
  glow,    ///< A cold lamp beyond the middle of the picture, hidden from the eye.
  lantern  ///< A warm lantern near the floor, behind an edge or at the side.
};

/// A lamp of data/kit/lamps.vug.
struct Lamp {
  LampRole role = LampRole::key;
  Vec3d at{0.0}, towards{0.0};
  double lumen = 1000;
};

/// The name in texts: "key".
std::string role_name(LampRole role);

/// Lumens of the strongest usual lamp for a role.
double most_lumens(LampRole role);

/// The call of the kit's lamp: lamps.led_panel((1, 2, 3), towards: (4, 1, 2), level: 5000).
/// `module`: the name under which kit/lamps.vug is included.
std::string lamp_call(const Lamp& lamp, const std::string& module);

/// The lights that the calls make, as any scene gets them. `data_folders`: where kit/lamps.vug is
/// searched. Error(bad_input) if it is not found.
std::vector<render::LightPtr> lights_of(const std::vector<Lamp>& lamps,
                                        const std::vector<std::filesystem::path>& data_folders);

/// Lamps in the air, at least 0.15 m from any surface, at most six of each role: at the places that
/// photographers use, and where rays from visible surfaces end behind an edge or outside the
/// picture. A lamp that the eye would see in the picture is left out.
std::vector<Lamp> lamp_places(const Location& location, const render::Camera& camera,
                              const View& view, const Landmarks& landmarks, RandomKey key);

/// Key to fill, as photographers light caves.
inline constexpr double kKeyRatio = 8;

/// The parts of a view that get different amounts of light.
enum class Part { subject, walls, foreground, deepest, none };

/// The part of each pixel. The foreground is the nearest and the deepest part the farthest class of
/// the distances. The subject is the largest landmark, or what is near the middle of the
/// rest; the walls are all others.
std::vector<Part> parts_of(const View& view, const Landmarks& landmarks);

/// At most four of the lamps, with the powers that bring the mean luminances of the parts closest
/// to 0.18, 0.06, 0.015 and 0.2. Light is linear: each lamp is one picture at its own power, and
/// the choice is a greedy search with non-negative least squares on the means, each divided by the
/// root of its target. The powers are those of products: 1, 1.5, 2, 3, 5 and 8 times a power of
/// ten. The exposure takes up a common factor; under a sky, lamps add what is missing relative to
/// its light.
///
/// `key_ratio`: the lamp that lights the subject most, the key, gives it at least this many times
/// the light of all other lamps (but for the rounding of the powers). Where the sky shines in, it
/// is the key, and the part that it lights best takes the place of the subject.
std::vector<Lamp> choose_lamps(const Location& location, const render::Camera& camera,
                               const std::vector<std::filesystem::path>& data_folders,
                               const Landmarks& landmarks, RandomKey key,
                               double key_ratio = kKeyRatio);

}  // namespace vug::scout
