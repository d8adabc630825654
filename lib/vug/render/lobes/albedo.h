// SPDX-License-Identifier: Apache-2.0
// Directional albedo of single scattering on microfacets, tabulated on first use. The missing
// energy is returned as multiple scattering (Kulla and Conty 2017, "Revisiting physically based
// shading at Imageworks", cite kulla2017compensation). The tables are sums in a fixed order, with
// the same bits on every machine.
#pragma once

#include <vug/render/vectors.h>

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace vug::render {

/// Values by cosine and roughness, with cosine-weighted means by roughness.
class AlbedoTable {
 public:
  static constexpr size_t kCosines = 32, kRoughnesses = 28;

  float at(float cosine, float roughness) const;
  float mean(float roughness) const;

  std::array<std::array<float, kCosines>, kRoughnesses> values{};
  std::array<float, kRoughnesses> means{};
};

/// Directional albedo of single scattering for perfectly reflecting facets.
const AlbedoTable& facet_albedo();

/// A value that is computed on first use; thread-safe. Materials refer to tables that take a tenth
/// of a second, and most commands do not evaluate any.
template <class T>
class Lazy {
 public:
  explicit Lazy(std::function<T()> make) : make_(std::move(make)) {}

  const T& operator*() const {
    const T* value = value_.load(std::memory_order_acquire);
    return value ? *value : make();
  }
  const T* operator->() const { return &**this; }

 private:
  const T& make() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!owned_) {
      owned_ = std::make_unique<const T>(make_());
      value_.store(owned_.get(), std::memory_order_release);
    }
    return *owned_;
  }

  std::function<T()> make_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<const T> owned_;
  mutable std::atomic<const T*> value_ = nullptr;
};

/// Single-scattering reflection of a rough dielectric interface of one index.
class InterfaceTable {
 public:
  /// One table for each index; thread-safe.
  static const InterfaceTable& of(float ior);

  float albedo(float cosine, float roughness) const;
  float mean(float roughness) const { return tables_->whole.mean(roughness); }
  float ior() const { return ior_; }
  float mean_fresnel() const { return mean_fresnel_; }

 private:
  struct Tables {
    AlbedoTable more;  ///< Excess over the smooth reflectance times facet_albedo(): small, smooth.
    AlbedoTable whole;
    float albedo(float ior, float cosine, float roughness) const;
  };
  explicit InterfaceTable(float ior);
  static Tables make_tables(float ior);

  float ior_, mean_fresnel_;
  Lazy<Tables> tables_;
};

/// Fraction of light that a rough dielectric interface neither reflects nor transmits in single
/// scattering, from both sides.
class DielectricTable {
 public:
  /// One table for each index; thread-safe.
  static const DielectricTable& of(float ior);

  const AlbedoTable& outside() const { return *outside_; }
  const AlbedoTable& inside() const { return *inside_; }

 private:
  explicit DielectricTable(float ior);
  Lazy<AlbedoTable> outside_, inside_;
};

/// Albedo of multiple scattering: the fraction of diffuse light between facets that finally leaves,
/// if a facet reflects `mean_reflectance` and a fraction `mean_albedo` leaves in each scattering.
inline float rescattered(float mean_reflectance, float mean_albedo) {
  return mean_reflectance * mean_reflectance * mean_albedo /
         (1 - mean_reflectance * (1 - mean_albedo));
}

}  // namespace vug::render
