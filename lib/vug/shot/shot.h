// SPDX-License-Identifier: Apache-2.0
// The evaluated scene before anything is built: plain data between the scene text and its products.
#pragma once

#include <vug/base/hash.h>
#include <vug/base/rng.h>
#include <vug/base/schema.h>
#include <vug/field/field.h>
#include <vug/grammar/tree.h>
#include <vug/lsystem/system.h>
#include <vug/mesh/mesh.h>
#include <vug/paint/paint.h>
#include <vug/render/scene.h>
#include <vug/shot/caps.h>
#include <vug/shot/dicing.h>
#include <vug/shot/labels.h>
#include <vug/shot/networks.h>
#include <vug/shot/render_settings.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::facade {
struct FacadeInstance;
struct Tree;
}  // namespace vug::facade
namespace vug::building {
class Builder;
struct Instance;
}  // namespace vug::building

namespace vug::shot {

struct MeshPlan;

/// The values that files contain in the band of a level set.
enum class DistanceValues {
  automatic,  ///< `exact` in exports, `bound` in other files.
  bound,      ///< The values of the field, or its first-order distances.
  exact,      ///< Euclidean distances.
};

/// `volume NAME = level_set(...)` or `fog(...)`, or `volume NAME on MESH { ... }`.
struct VolumePlan {
  std::string name;  ///< Also the name of the grid in the .vdb file.
  field::Field field;
  std::shared_ptr<const MeshPlan>
      source_mesh;  ///< Mesh to voxelise instead of the field; null: the field.
  bool fog = false;
  double voxel = 0.1;     ///< Voxel edge in metres.
  double half_width = 3;  ///< Half width of the narrow band in voxels.
  bool repair = true;     ///< Convert band values into distances if the field is not one.
  DistanceValues distance = DistanceValues::automatic;
  bool half = false;          ///< Store 16-bit floats.
  std::optional<Vec3d> from;  ///< With `to`: the box to clip to; required for unbounded fields.
  std::optional<Vec3d> to;
  Caps caps;                     ///< Faces of that box that `field` closes with rock.
  mutable SourceLocation where;  ///< Location of the name in the text; see move_lines.

  std::string fault() const;  ///< Describes an invalid box of `from` and `to`; else empty.
};
using VolumePtr = std::shared_ptr<const VolumePlan>;

struct CellsPlan;  ///< See cells_plan.h.
using CellsPtr = std::shared_ptr<const CellsPlan>;

/// The treatment of bubbles and handles of a mesh that are smaller than two voxels.
enum class SmallTopology { clean, keep };

/// `mesh NAME on VOLUME { ... }` or `mesh NAME { file ... }`, such a mesh with a cell layer, or
/// several meshes combined into one.
struct MeshPlan {
  std::string name;
  VolumePtr volume;         ///< Null for a combined mesh and for a mesh from a file.
  mesh::MeshPtr file_mesh;  ///< The mesh of the file, in metres and with normals.
  bool drawn = false;       ///< `file_mesh` consists of stems, polygons or leaves, not of a file.
  double adaptivity = 0;    ///< 0 keeps every quad, 1 merges flat regions.
  bool polish = true;       ///< Move vertices onto the exact field.
  SmallTopology topology = SmallTopology::clean;
  double smallest_piece = 0;   ///< Metres; components with a shorter box diagonal are removed.
  std::string format = "ply";  ///< A kind of mesh::formats().
  paint::Paint paint;          ///< Vertex colours (attribute Cd); null: none.
  /// Facades whose node and element kind are stored per vertex; see facade::add_semantics.
  std::vector<std::shared_ptr<const facade::FacadeInstance>> elements;
  std::vector<SurfaceLabel> labels;  ///< Stored per vertex; see building::add_labels.
  CellsPtr cells;                    ///< Cells applied to the mesh; null: none.
  size_t support = 0;                ///< Index in `cells->on` of the mesh below the cells.
  std::vector<std::shared_ptr<const MeshPlan>>
      parts;  ///< The meshes combined into this one; empty: a single mesh.

  bool operator==(const MeshPlan&) const = default;
};
using MeshPtr = std::shared_ptr<const MeshPlan>;

/// The mesh of a level set without a mesh declaration: default settings, same name.
MeshPtr plain_mesh(const VolumePtr& volume);

/// `object NAME on MESH { ... }`: a mesh with a material, for rendering.
struct ObjectPlan {
  std::string name;
  MeshPtr mesh;
  render::MaterialPtr material;  ///< Null: grey.
  bool flat = false;
  bool direct = false;      ///< Trace the level set itself instead of a mesh.
  bool floating = false;    ///< Hangs in mid-air on purpose.
  Vec3d emission{0, 0, 0};  ///< W/sr/m^2.
  std::string light_group;
  std::optional<Dicing> detail;  ///< Micro-displacement; none: the mesh as it is.
  SourceLocation where;          ///< Location of the name in the text.
};

struct Shot;
/// Yields the instances of a point instancer; see building/instance_source.h.
using InstanceSource = std::shared_ptr<
    const std::function<std::vector<building::Instance>(building::Builder&, RandomKey)>>;

/// The prototype of an instance: an object of the shot, else a mesh with the default grey material,
/// or a whole scene.
struct Model {
  std::string name;
  MeshPtr mesh;
  std::filesystem::path file;  ///< Scene file; empty: an object or a mesh. For scenes also:
  std::optional<int> seed;
  std::vector<std::string> with;  ///< Parameters of that scene as "NAME=VALUE".
  std::shared_ptr<const Shot> scene;
};

/// `place NAME { of ... at ... }`: instances of models.
struct PointInstancer {
  std::string name;
  std::vector<Model> of;
  std::vector<InstanceSource> at;
  std::vector<double> shares;    ///< Relative frequency of each model; empty: equal.
  render::MaterialPtr material;  ///< Null: the materials of the models.
  bool apart = false;            ///< Each instance has a name of its own.
  bool floating = false;         ///< Instances hang in mid-air on purpose.
  RandomKey key{0};
  SourceLocation where;  ///< Location of the name in the text.
};

/// `medium NAME = ...`: a participating medium. The air of a picture is one of them.
struct MediumPlan {
  std::string name;
  render::MediumPtr medium;
  VolumePtr volume;      ///< Its density, if it needs one.
  SourceLocation where;  ///< Location of the name in the text.
};

/// `network NAME = ...`: the plan of a cave.
struct NetworkPlan {
  std::string name;
  NetworkPtr network;
};

class DripsPlan;  ///< See drips_plan.h.

/// `drips NAME = ...`: the drips of a cave.
struct NamedDrips {
  std::string name;
  std::shared_ptr<const DripsPlan> drips;
};

/// `camera NAME { ... }`: a camera.
struct CameraPlan {
  std::string name;
  render::CameraPtr camera;
  SourceLocation where;  ///< Location of the name in the text.
};

/// `render NAME { ... }`: the settings of a picture.
struct RenderPlan {
  std::string name = "main";
  RenderSettings settings;
  SourceLocation where;             ///< Location of the name in the text.
  bool included = false;            ///< Declared in an included file.
  std::vector<std::string> stated;  ///< Names of the settings that the block contains.
};

/// The derivation of a grammar, kept for `vug tree` and for production counts.
struct Derivation {
  std::string name;
  grammar::Tree tree;
  int64_t productions = 0;
  std::shared_ptr<const facade::Tree> facade = nullptr;  ///< For grammars of kind facade.
};

class LSystemPlan;  ///< See lsystem_plan.h.
using LSystemPtr = std::shared_ptr<const LSystemPlan>;

/// All declarations of a scene at one frame.
struct Shot {
  std::string name;  ///< Stem of the scene file.
  uint64_t seed = 0;
  double frame = 1;       ///< Frame number; frames may be fractional.
  bool animated = false;  ///< Part of the scene depends on the frame.
  bool draft = false;     ///< Meshes are not polished.
  std::string recipe;  ///< The scene text with its overrides, from which the shot can be rebuilt.
  /// Digest of the scene text, of all included texts and of `draft`.
  Digest text_digest;
  std::vector<NetworkPlan> networks;
  std::vector<NamedDrips> drips;
  std::vector<VolumePtr> volumes;
  std::vector<MeshPtr> meshes;
  std::vector<ObjectPlan> objects;
  std::vector<PointInstancer> instancers;
  std::vector<CameraPlan> cameras;
  std::vector<std::pair<std::string, render::LightPtr>> lights;  ///< Lights with their names.
  std::vector<MediumPlan> media;
  std::vector<std::pair<std::string, render::MaterialPtr>> materials;  ///< Named materials.
  std::vector<RenderPlan> renders;
  std::vector<Derivation> derivations;
  std::vector<LSystemPtr> lsystems;

  /// The sizes of all lists, from which `delta` finds later additions.
  struct Snapshot {
    std::vector<size_t> lists;
  };
  Snapshot snapshot() const;
  /// A shot with the additions since the snapshot.
  Shot delta(const Snapshot& snapshot) const;
  /// Appends all lists of another shot.
  void add(const Shot& more);
};

}  // namespace vug::shot
