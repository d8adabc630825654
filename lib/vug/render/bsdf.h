// The seam of scattering: what a surface does with light at one place, seen from one side.
#pragma once

#include <vug/render/vectors.h>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace vug::render {

/// f(out, in) * |cos in| in 1/sr, by kind of lobe, and the density with which `sample` chooses
/// `in`, over solid angle. Where `in` lies below the surface, all of it is transmission.
struct Scattering {
  Rgb diffuse{0, 0, 0};
  Rgb specular{0, 0, 0};
  float pdf = 0;

  Rgb total() const { return diffuse + specular; }
};

class Bsdf;

struct BsdfSample {
  Vec3f direction;  ///< Local, unit; below the surface (z < 0) light is let through.
  Rgb weight;       ///< f |cos| / pdf, of all lobes together.
  Rgb diffuse;      ///< The part of `weight` that diffuse lobes have.
  float pdf = 0;    ///< Over solid angle; zero means: nothing was sampled.
  const Bsdf* body =
      nullptr;              ///< Whose `absorption` and `subsurface` hold; null: of the one asked.
  bool subsurface = false;  ///< Goes on beneath the surface, as Bsdf::beneath() tells, and comes
                            ///< out elsewhere: `direction` leads in; `evaluate` leaves it out.
};

/// Where light goes on beneath a surface: cloudy stone, ice, marble, scattering evenly.
struct SubsurfaceMedium {
  float mean_free_path = 0;  ///< Metres between two collisions.
  Rgb albedo{0, 0, 0};       ///< Share of the light that a collision scatters.
};

/// Made by a Material for one hit and one viewer, in a BsdfMemory. Directions are unit vectors in
/// the local frame of the shading normal (z), which is on the viewer's side, and point away from
/// the surface.
class Bsdf {
 public:
  virtual Scattering evaluate(const Vec3f& in) const = 0;
  /// `lobe` and `u`: uniform numbers in [0, 1).
  virtual BsdfSample sample(float lobe, const Vec2f& u) const = 0;
  /// Share of light that is reflected, about: the picture's albedo layer.
  virtual Rgb albedo() const = 0;
  /// How much of the sampling a guide to the light may take over: about half of the share that
  /// broad lobes have; 0 where `sample` finds lobes that `evaluate` cannot see.
  virtual float guided_fraction() const { return 0.5f; }

  /// What the clear body behind a face swallows, per metre.
  virtual Rgb absorption() const { return Rgb(0.0f); }
  virtual SubsurfaceMedium subsurface() const { return {}; }
  /// A sheet without a body: light from behind is scattered towards the viewer, too, and lights are
  /// looked for on both sides.
  virtual bool thin() const { return false; }
  /// Lights behind the surface can be chosen, too, not only found.
  virtual bool lit_from_behind() const { return thin(); }

 protected:
  ~Bsdf() = default;  // it is never destroyed, its memory is used again
};

/// Where the Bsdf of one hit stands: on the stack of the path.
class BsdfMemory {  // NOLINT: what is made in it sets its part
 public:
  static constexpr size_t kBytes = 4096;

  /// What `make` takes of the memory for a T; a material's are counted when it is made.
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
