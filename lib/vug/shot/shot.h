// What a scene asks for, evaluated but not yet computed: plain data between text and products.
#pragma once

#include <vug/base/hash.h>
#include <vug/base/rng.h>
#include <vug/base/schema.h>
#include <vug/field/field.h>
#include <vug/grammar/tree.h>
#include <vug/image/colour_space.h>
#include <vug/lsystem/system.h>
#include <vug/mesh/mesh.h>
#include <vug/paint/paint.h>
#include <vug/render/integrator.h>
#include <vug/render/sampler.h>
#include <vug/render/scene.h>

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

/// `volume NAME = level_set(...)` or `fog(...)`, or `volume NAME on MESH { ... }`.
struct VolumePlan {
  std::string name;  ///< Also the grid's name in the file.
  field::Field field;
  std::shared_ptr<const MeshPlan>
      source_mesh;  ///< The mesh that it is made of in place of the field.
  bool fog = false;
  double voxel = 0.1;         ///< Metres.
  double half_width = 3;      ///< Of the narrow band, voxels.
  bool repair = true;         ///< Make band values distances where the field's are not.
  bool half = false;          ///< Store 16-bit floats.
  std::optional<Vec3d> from;  ///< With `to`: cut to this box; needed by fields without bounds.
  std::optional<Vec3d> to;
  SourceLocation where;  ///< Its name in the text.

  std::string fault() const;  ///< A sentence on `from` and `to` that are no box; else empty.
};
using VolumePtr = std::shared_ptr<const VolumePlan>;

struct CellsPlan;  ///< See cells_plan.h.
using CellsPtr = std::shared_ptr<const CellsPlan>;

/// `mesh NAME on VOLUME { ... }` or `mesh NAME { file ... }`, such a mesh wearing cells, or several
/// in one.
struct MeshPlan {
  std::string name;
  VolumePtr volume;            ///< Null for several and for one from a file.
  mesh::MeshPtr file_mesh;     ///< What the file holds, in metres and with normals.
  double adaptivity = 0;       ///< 0 keeps every quad, 1 merges what is flat.
  bool polish = true;          ///< Move vertices onto the exact field.
  double smallest_piece = 0;   ///< Metres; pieces whose box has a shorter diagonal are left out.
  std::string format = "ply";  ///< A kind of mesh::formats().
  paint::Paint paint;          ///< Vertex colours (attribute Cd); null: none.
  /// Facades whose nodes the vertices tell apart; see add_semantics.
  std::vector<std::shared_ptr<const facade::FacadeInstance>> elements;
  CellsPtr cells;      ///< That it wears on one of what they stand on; null: none.
  size_t support = 0;  ///< On which.
  std::vector<std::shared_ptr<const MeshPlan>> parts;  ///< All that it is in one; none: itself.

  bool operator==(const MeshPlan&) const = default;
};
using MeshPtr = std::shared_ptr<const MeshPlan>;

/// A mesh of the level set that nobody has asked for otherwise, of the same name.
MeshPtr plain_mesh(const VolumePtr& volume);

/// `object NAME on MESH { ... }`: a mesh with what it is made of, for pictures.
struct ObjectPlan {
  std::string name;
  MeshPtr mesh;
  render::MaterialPtr material;  ///< Null: grey.
  bool flat = false;
  bool direct = false;      ///< Trace the level set itself; no mesh is made.
  Vec3d emission{0, 0, 0};  ///< W/sr/m^2.
  std::string light_group;
};

struct Shot;
/// See places.h.
using InstanceSource = std::shared_ptr<
    const std::function<std::vector<building::Instance>(building::Builder&, RandomKey)>>;

/// What can be placed: an object of the shot, or else a mesh in grey, or a whole scene.
struct Model {
  std::string name;
  MeshPtr mesh;
  std::filesystem::path file;  ///< Of a scene; then also:
  std::optional<int> seed;
  std::vector<std::string> with;  ///< "NAME=VALUE" of its parameters.
  std::shared_ptr<const Shot> scene;
};

/// `place NAME { of ... at ... }`.
struct PointInstancer {
  std::string name;
  std::vector<Model> of;
  std::vector<InstanceSource> at;
  std::vector<double> shares;    ///< Of each model; empty: the same.
  render::MaterialPtr material;  ///< Null: their own.
  bool apart = false;            ///< Each has a name of its own.
  RandomKey key{0};
  SourceLocation where;  ///< Its name in the text.
};

/// `camera NAME { ... }`.
struct CameraPlan {
  std::string name;
  render::CameraPtr camera;
  SourceLocation where;  ///< Its name in the text.
};

/// `render NAME { ... }`.
struct RenderPlan {
  std::string name = "main";
  std::vector<int> size = {960, 540};  ///< Pixels: width, height.
  int spp = 64;
  double exposure = 0;           ///< Stops; for the PNG only.
  bool openings = true;          ///< See render::Options.
  bool half = true;              ///< 16-bit colour channels in the EXR.
  bool multi_part = false;       ///< A part of the EXR for each layer.
  bool tiled = false;            ///< Tiles in the EXR instead of lines.
  bool deep = false;             ///< Also a deep EXR.
  double deep_tolerance = 0.01;  ///< See render::DeepOptions.
  double noise = 0;              ///< See render::Options.
  image::WorkingSpace working_space = image::WorkingSpace::rec709;
  std::string view, display;        ///< Of the PNG; see image::ViewSelection.
  std::vector<std::string> layers;  ///< As render::plan_aovs takes them.
  std::vector<int> crop;            ///< Left, top, right, bottom in pixels; empty: all.
  render::CameraPtr camera;         ///< Null: the camera named like the plan, else the first.
  render::SamplerPtr sampler;
  render::IntegratorPtr integrator;
  SourceLocation where;  ///< Its name in the text.
};

/// A grammar's derivation, kept for `vug tree` and for counting productions.
struct Derivation {
  std::string name;
  grammar::Tree tree;
  int64_t productions = 0;
  std::shared_ptr<const facade::Tree> facade = nullptr;  ///< Of a grammar of kind facade.
};

class LSystemPlan;  ///< See lsystem_plan.h.
using LSystemPtr = std::shared_ptr<const LSystemPlan>;

struct Shot {
  std::string name;  ///< The scene file's stem.
  uint64_t seed = 0;
  double frame = 1;       ///< The moment that it shows.
  bool animated = false;  ///< Something in it depends on the frame.
  std::string recipe;     ///< The scene text with its overrides: what rebuilds all of this.
  Digest text_digest;     ///< Of the scene text and all that it includes.
  std::vector<VolumePtr> volumes;
  std::vector<MeshPtr> meshes;
  std::vector<ObjectPlan> objects;
  std::vector<PointInstancer> instancers;
  std::vector<CameraPlan> cameras;
  std::vector<std::pair<std::string, render::LightPtr>> lights;  ///< Lamps and skies.
  render::MediumPtr medium;
  std::string medium_name;
  std::vector<std::pair<std::string, render::MaterialPtr>> materials;  ///< Those with names.
  VolumePtr medium_volume;  ///< Whose density the medium has, if it needs one.
  std::vector<RenderPlan> renders;
  std::vector<Derivation> derivations;
  std::vector<LSystemPtr> lsystems;

  /// Where its lists end, to tell later what has been added to them.
  struct Snapshot {
    std::vector<size_t> lists;
    bool medium = false;
  };
  Snapshot snapshot() const;
  /// What has been added since, in a shot of its own.
  Shot delta(const Snapshot& snapshot) const;
  /// Takes in what another shot declares: all its lists, and its medium if it has one.
  void add(const Shot& more);
};

}  // namespace vug::shot
