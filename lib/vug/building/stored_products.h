// SPDX-License-Identifier: Apache-2.0
// The products that a Builder takes from a store or adds to it.
#pragma once

#include <vug/building/apply_cells.h>
#include <vug/building/make_mesh.h>
#include <vug/store/store.h>
#include <vug/volume/level_set.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vug::building {

/// The way in which a product was obtained.
struct ProductReport {
  std::string kind, name;
  bool reused = false;
  double seconds = 0;  ///< The time that it took, or that the reuse saved.
  /// The parts of the key that differ from those of the last time; nothing: there was none.
  std::optional<std::vector<std::string>> changed;
};

struct StoreUse {
  store::StorePtr store = nullptr;  ///< Null: nothing is stored.
  std::string scene;                ///< Distinguishes the products of a scene from others.
  Digest plugins = {};  ///< Identifies code that epochs do not cover; a part of all keys.
  std::function<void(const ProductReport&)> on_product = nullptr;
  /// Products that took fewer seconds are not stored: reading them would not save time.
  double least_seconds = 0.2;

  /// The name of a product in the store's list of last keys.
  std::string product_name(const std::string& name) const { return scene + "\n" + name; }
  /// The key with the parts that all products have.
  store::Key complete(store::Key key) const { return key.add("plugins", plugins); }
};

/// The store of the user, store::default_folder, for the products of a scene file; without a store
/// if it is off. `plugins`: see StoreUse. `on_warning` receives a sentence if a product cannot be
/// stored.
StoreUse user_store(const std::string& scene_file, Digest plugins,
                    std::function<void(const std::string&)> on_warning);

/// The files of T in a store, with the members
///   static constexpr const char* kExtension;
///   static void write(const std::filesystem::path&, const T&);
///   static T read(const std::filesystem::path&);
template <class T>
struct ProductFile;

template <>
struct ProductFile<volume::LevelSet> {
  static constexpr const char* kExtension = ".vdb";
  static void write(const std::filesystem::path& target, const volume::LevelSet& level_set);
  static volume::LevelSet read(const std::filesystem::path& source);
};
template <>
struct ProductFile<SurfaceMesh> {
  static constexpr const char* kExtension = ".mesh";
  static void write(const std::filesystem::path& target, const SurfaceMesh& mesh);
  static SurfaceMesh read(const std::filesystem::path& source);
};

template <>
struct ProductFile<MeshWithCells> {
  static constexpr const char* kExtension = ".mesh";
  static void write(const std::filesystem::path& target, const MeshWithCells& mesh);
  static MeshWithCells read(const std::filesystem::path& source);
};

class StoredProducts {
 public:
  explicit StoredProducts(StoreUse use) : use_(std::move(use)) {}

  bool contains(const store::Key& key) const {
    return use_.store && use_.store->contains(use_.complete(key));
  }

  /// The product of the key, from the store or else from `make(seconds)`, which adds the time that
  /// it took; `total` increases by as much.
  template <class T, class Make>
  T obtain(const store::Key& inputs, const std::string& name, const Make& make, double& total) {
    const store::Key key = use_.complete(inputs);
    if (use_.store)
      if (const auto entry = use_.store->find(key)) {
        try {
          T out = ProductFile<T>::read(entry->object);
          report(key, name, true, entry->seconds);
          return out;
        } catch (const Error&) {
          // Another process removed the file meanwhile.
        }
      }
    double seconds = 0;
    T out = make(seconds);
    total += seconds;
    if (use_.store && seconds >= use_.least_seconds)
      use_.store->keep(
          key, seconds, ProductFile<T>::kExtension,
          [&](const std::filesystem::path& target) { ProductFile<T>::write(target, out); });
    report(key, name, false, seconds);
    return out;
  }

 private:
  void report(const store::Key& key, const std::string& name, bool reused, double seconds);

  StoreUse use_;
};

}  // namespace vug::building
