// SPDX-License-Identifier: Apache-2.0
// Interface of BSDFs: how a surface scatters light at one point, seen from one side.
#pragma once

#include <vug/render/vectors.h>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace vug::render {

/// f(out, in) * |cos in| in 1/sr, split by kind of lobe, and the density per solid angle with which
/// `sample` chooses `in`. If `in` is below the surface, all of it is transmission.
struct Scattering {
  Rgb diffuse{0, 0, 0};
  Rgb specular{0, 0, 0};
  float pdf = 0;

  Rgb total() const { return diffuse + specular; }
};

class Bsdf;

struct BsdfSample {
  Vec3f direction{0, 0, 0};  ///< Local, unit; below the surface (z < 0) for transmission.
  Rgb weight{0, 0, 0};       ///< f |cos| / pdf, summed over all lobes.
  Rgb diffuse{0, 0, 0};      ///< The contribution of diffuse lobes to `weight`.
  float pdf = 0;             ///< Per solid angle; 0: nothing was sampled.
  const Bsdf* body =
      nullptr;  ///< Provides `absorption` and `subsurface`; null: the BSDF that was sampled.
  bool subsurface =
      false;  ///< The path continues below the surface, see Bsdf::subsurface(), and leaves it
              ///< elsewhere: `direction` points inwards. `evaluate` excludes this lobe.
};

/// The medium of random-walk subsurface scattering: cloudy stone, ice or marble. It scatters
/// isotropically.
struct SubsurfaceMedium {
  float mean_free_path = 0;  ///< Mean distance between two collisions in metres.
  Rgb albedo{0, 0, 0};       ///< Fraction of the light that a collision scatters.
};

/// Created by a Material for one hit and one viewer, in a BsdfMemory. Directions are unit vectors
/// in the local frame of the shading normal (z), which is on the viewer's side, and point away from
/// the surface.
class Bsdf {
 public:
  virtual Scattering evaluate(const Vec3f& in) const = 0;
  /// `lobe` and `u`: uniform numbers in [0, 1). Samples below the surface have the largest values
  /// of `lobe`: see subsurface_fraction().
  virtual BsdfSample sample(float lobe, const Vec2f& u) const = 0;
  /// Approximate fraction of reflected light: the AOV `albedo`.
  virtual Rgb albedo() const = 0;
  /// The fraction of samples that path guiding may replace: about half of the share of broad lobes.
  virtual float guided_fraction() const { return 0.5f; }
  /// The fraction of samples that continue below the surface (BsdfSample::subsurface): those with
  /// `lobe` >= 1 - subsurface_fraction(). Path guiding does not replace them.
  virtual float subsurface_fraction() const { return 0; }

  /// True if light from a small part of all directions matters most: an interface of low roughness.
  virtual bool glossy() const { return false; }

  /// Absorption coefficient of the clear medium behind the surface, per metre.
  virtual Rgb absorption() const { return Rgb(0.0f); }
  virtual SubsurfaceMedium subsurface() const { return {}; }
  /// True for a sheet without a volume: light from behind is also scattered towards the viewer, and
  /// lights are sampled on both sides.
  virtual bool thin() const { return false; }
  /// True if lights behind the surface can also be sampled, not only hit.
  virtual bool lit_from_behind() const { return thin(); }

 protected:
  ~Bsdf() = default;  // never destroyed; its memory is reused
};

/// Storage for the Bsdf of one hit, on the stack of the path.
class BsdfMemory {  // NOLINT: objects made in it initialise their own bytes
 public:
  static constexpr size_t kBytes = 8192;

  /// Bytes that `make` takes for a T; Material::memory_bytes adds these up.
  template <class T>
  static constexpr size_t bytes() {
    return (sizeof(T) + alignof(std::max_align_t) - 1) & ~(alignof(std::max_align_t) - 1);
  }
  template <class T, class... Arguments>
  T& make(Arguments&&... arguments) {
    static_assert(std::is_trivially_destructible_v<T> && bytes<T>() <= kBytes);
    T* made = new (data_ + used_) T(std::forward<Arguments>(arguments)...);
    used_ += bytes<T>();
    return *made;
  }

 private:
  size_t used_ = 0;
  alignas(std::max_align_t) std::byte data_[kBytes];
};

}  // namespace vug::render
