// SPDX-License-Identifier: Apache-2.0
// The type of noises and their look-up by name; the formulas are in noise/.
#pragma once

#include <vug/field/kind.h>

#include <span>

namespace vug::field {

constexpr const char* kDefaultNoise = "fbm";

/// Dimensionless values of about -1..1. `field` evaluates them (points in metres) and knows their
/// Lipschitz constant per metre. The default is fbm with its default parameters.
struct Noise {
  Noise();
  Noise(Field values, Interval bounds) : field(std::move(values)), range(bounds) {}

  Digest digest() const { return field.digest(); }

  Field field;
  Interval range;           ///< Bounds of all values.
  bool is_default = false;  ///< Whether this is the default noise.
};

using NoiseKind = Kind<Noise>;

/// The noise kinds: perlin, fbm, worley, ...
const Kinds<Noise>& noises();
/// Creates a noise from a kind name and named values; throws Error(bad_input) as make() for fields.
Noise make_noise(const std::string& kind, const NamedValues& params = {});
/// The noise of this kind with default parameters; nothing if there is no such kind.
std::optional<Noise> default_noise(const std::string& kind);

/// Values at points, e.g. to colour the vertices of a mesh; evaluated in parallel, 8 at a time.
std::vector<float> sample(const Field& field, const std::vector<Vec3f>& points);
/// The same on the calling thread and without allocations. `out` has the size of `points`.
void sample(const Field& field, std::span<const Vec3f> points, std::span<float> out);

inline Value as_value(const Noise& noise);

}  // namespace vug::field

/// Opens the one definition exported by a file in noise/; see VUG_FIELD_KIND.
#define VUG_NOISE_KIND(name) VUG_EXPORT_KIND(vug::field, NoiseKind, name##_kind)

namespace vug {

/// A noise, or the name of a kind for its defaults: `noise: ridged`.
template <>
struct ValueTraits<field::Noise> : ObjectTraits<field::Noise> {
  static constexpr const char* kWord = "noise";
  static std::optional<field::Noise> read(const Value& v) {
    if (const auto* n = v.object<field::Noise>()) return *n;
    const auto* name = v.get<Value::Name>();
    return name ? field::default_noise(name->text) : std::nullopt;
  }
  static Value write(const field::Noise& noise) {
    if (noise.is_default) return Value::Name{field::kDefaultNoise};
    return ObjectTraits::write(noise);
  }
};

inline Value field::as_value(const Noise& noise) { return ValueTraits<Noise>::write(noise); }

}  // namespace vug
