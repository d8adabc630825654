// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 in one binary file, by tinygltf.
#include <vug/base/atomic_file.h>
#include <vug/base/maths.h>
#include <vug/exchange/flat_mesh.h>
#include <vug/exchange/gltf_buffer.h>
#include <vug/exchange/gltf_extras.h>
#include <vug/exchange/gltf_material.h>
#include <vug/exchange/names.h>
#include <vug/exchange/sky.h>
#include <vug/exchange/trs.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>

namespace vug::exchange {
namespace {

using tinygltf::Value;

class GlbWriter {
 public:
  GlbWriter(const Assembly& assembly, const std::filesystem::path& file,
            const FormatOptions& options)
      : assembly_(assembly), file_(file), options_(options), buffer_(model_) {
    model_.scenes.resize(1);
    model_.scenes[0].name = assembly.name;
    model_.defaultScene = 0;
    const Provenance& from = assembly.provenance;
    model_.asset.version = "2.0";
    model_.asset.generator = "Vug " + from.version;
    model_.asset.extras = Value(Value::Object{{"vug:recipe", Value(from.recipe)},
                                              {"vug:seed", Value(std::to_string(from.seed))},
                                              {"vug:frame", Value(from.frame)},
                                              {"vug:version", Value(from.version)}});
  }

  void add_groups(Progress& progress) {
    progress.begin("glTF", assembly_.groups.size());
    for (const InstanceGroup& group : assembly_.groups) {
      progress.check();
      add_group(group);
      progress.advance();
    }
    progress.end();
  }
  void add_cameras() {
    for (const Camera& camera : assembly_.cameras) add_camera(camera);
  }
  void add_lights() {
    for (const Light& light : assembly_.lights) add_light(light);
  }

  void add_volumes() {
    for (const Volume& volume : assembly_.volumes) volumes_.push_back(gltf_volume(volume));
  }

  WriteReport save() {
    Value::Object extras;
    if (!skies_.empty()) extras.emplace("vug:skies", Value(skies_));
    if (!volumes_.empty()) extras.emplace("vug:volumes", Value(volumes_));
    if (!extras.empty()) model_.scenes[0].extras = Value(extras);
    if (model_.buffers[0].data.empty()) model_.buffers.clear();
    AtomicFile target(file_);
    std::ofstream out(target.path(), std::ios::binary);
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, out, false, true);
    out.close();
    if (!out)
      throw Error(ErrorCode::io,
                  fmt::format("cannot write '{}': {}", file_.string(), std::strerror(errno)));
    target.commit();
    files_.insert(files_.begin(), file_);
    return {files_, unsupported_, notes_};
  }

 private:
  void use(const std::string& extension) {
    auto& used = model_.extensionsUsed;
    if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
  }
  /// Reports data that glTF cannot express and that only Vug's add-on reads.
  void note_as_extras(const std::string& what) {
    notes_.push_back(what + ": glTF cannot express it, only Vug's add-on for Blender reads it");
  }
  void add_root_node(tinygltf::Node node) {
    model_.nodes.push_back(std::move(node));
    model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size()) - 1);
  }
  tinygltf::Node node(const std::string& name, const TrsTransform& at) const {
    tinygltf::Node node;
    node.name = name;
    if (at.translation != Vec3d(0.0))
      node.translation = {at.translation.x, at.translation.y, at.translation.z};
    if (at.rotation != TrsTransform().rotation)
      node.rotation = {at.rotation.begin(), at.rotation.end()};
    if (at.scale != Vec3d(1.0)) node.scale = {at.scale.x, at.scale.y, at.scale.z};
    return node;
  }

  int material_of(const Prototype& prototype) {
    tinygltf::Material made =
        gltf_material(prototype, options_.emission_scale.value_or(kLumenPerWatt));
    for (const auto& [name, value] : made.extensions) use(name);
    if (prototype.look.through != Vec3d(0.0))
      note_as_extras(fmt::format("the light transmitted by '{}'", prototype.name));
    const auto same = std::find(model_.materials.begin(), model_.materials.end(), made);
    if (same != model_.materials.end()) return static_cast<int>(same - model_.materials.begin());
    model_.materials.push_back(std::move(made));
    return static_cast<int>(model_.materials.size()) - 1;
  }
  int add_mesh(const Prototype& prototype) {
    model_.meshes.push_back(gltf_mesh(
        prototype, [&](const Prototype& look) { return material_of(look); }, buffer_,
        unsupported_));
    return static_cast<int>(model_.meshes.size()) - 1;
  }
  int mesh_of(size_t part) {
    const auto known = meshes_.find(part);
    if (known != meshes_.end()) return known->second;
    return meshes_[part] = add_mesh(assembly_.prototypes.at(part));
  }
  /// The prototype with a shearing transform applied, which glTF nodes cannot represent.
  int sheared_mesh(const Prototype& prototype, const Transform& place) {
    Prototype moved = prototype;
    moved.mesh = std::make_shared<const mesh::Mesh>(transformed(*prototype.mesh, place));
    return add_mesh(moved);
  }

  void add_group(const InstanceGroup& group) {
    const Prototype& prototype = assembly_.prototypes.at(group.prototype);
    if (prototype.mesh->triangles.empty()) {
      unsupported_.push_back(fmt::format("'{}', whose mesh is empty", group.name));
      return;
    }
    const bool many = group.places.size() > 1;
    std::vector<TrsTransform> together;
    for (size_t i = 0; i < group.places.size(); ++i) {
      const auto parts = decompose_trs(group.places[i]);
      if (parts && many && options_.instancing) {
        together.push_back(*parts);
        continue;
      }
      tinygltf::Node one = node(many ? fmt::format("{}.{}", group.name, i + 1) : group.name,
                                parts.value_or(TrsTransform()));
      one.mesh = parts ? mesh_of(group.prototype) : sheared_mesh(prototype, group.places[i]);
      add_root_node(std::move(one));
    }
    if (!together.empty()) add_instances(group, together);
  }
  void add_instances(const InstanceGroup& group, const std::vector<TrsTransform>& places) {
    std::vector<float> moves, turns, scales;
    for (const TrsTransform& each : places) {
      for (int i = 0; i < 3; ++i) moves.push_back(static_cast<float>(each.translation[i]));
      for (int i = 0; i < 3; ++i) scales.push_back(static_cast<float>(each.scale[i]));
      for (const double part : each.rotation) turns.push_back(static_cast<float>(part));
    }
    const auto accessor = [&](const std::vector<float>& values, int arity) {
      return Value(buffer_.floats(values.data(), places.size(), arity, false, 0));
    };
    tinygltf::Node all = node(group.name, {});
    all.mesh = mesh_of(group.prototype);
    all.extensions["EXT_mesh_gpu_instancing"] =
        Value(Value::Object{{"attributes", Value(Value::Object{{"TRANSLATION", accessor(moves, 3)},
                                                               {"ROTATION", accessor(turns, 4)},
                                                               {"SCALE", accessor(scales, 3)}})}});
    use("EXT_mesh_gpu_instancing");
    add_root_node(std::move(all));
  }

  void add_camera(const Camera& camera) {
    tinygltf::Camera made;
    made.name = camera.name;
    if (camera.orthographic) {
      made.type = "orthographic";
      made.orthographic.xmag = 0.5 * camera.span;
      made.orthographic.ymag = 0.5 * camera.span / camera.aspect;
      made.orthographic.znear = camera.near;
      made.orthographic.zfar = camera.far;
    } else {
      made.type = "perspective";
      made.perspective.aspectRatio = camera.aspect;
      made.perspective.yfov = 2 * maths::atan2(maths::tan(0.5 * camera.fov), camera.aspect);
      made.perspective.znear = camera.near;
      made.perspective.zfar = camera.far;
    }
    Value::Object extras;
    if (camera.size != Vec2i(0, 0))
      extras.emplace("vug:size", Value(Value::Array{Value(camera.size.x), Value(camera.size.y)}));
    if (camera.aperture > 0) {
      extras.emplace("vug:aperture", Value(camera.aperture));
      extras.emplace("vug:focus", Value(camera.focus));
      note_as_extras(fmt::format("the depth of field of the camera '{}'", camera.name));
    }
    if (!extras.empty()) made.extras = Value(extras);
    model_.cameras.push_back(std::move(made));
    tinygltf::Node at = node(camera.name, decompose_trs(camera.place).value_or(TrsTransform()));
    at.camera = static_cast<int>(model_.cameras.size()) - 1;
    add_root_node(std::move(at));
  }

  /// Environment maps are named after the file, so a second dome of a scene needs another name.
  void add_sky(const Light& dome) {
    const std::string name = names_.unique(dome.name);
    const bool there = !options_.pictures_of.empty();
    const auto picture =
        there ? sky_file(dome, options_.pictures_of, name) : write_sky(dome, file_, name);
    if (picture && !there) files_.push_back(*picture);
    skies_.push_back(gltf_sky(dome, picture ? picture->filename().string() : ""));
    note_as_extras(fmt::format("the sky '{}'", dome.name));
  }

  void add_light(const Light& light) {
    using Shape = Light::Shape;
    if (light.shape == Shape::dome) return add_sky(light);
    tinygltf::Light made;
    made.name = light.name;
    const Vec3d watts = peak_intensity(light);
    const double most = std::max({watts.x, watts.y, watts.z});
    made.intensity = most * kLumenPerWatt;
    const Vec3d color = most > 0 ? watts / most : Vec3d(1.0);
    made.color = {color.x, color.y, color.z};
    made.type = light.shape == Shape::sun      ? "directional"
                : light.shape == Shape::sphere ? "point"
                                               : "spot";
    Value::Object shape = {{"vug:radiance", gltf_value(light.radiance)}};
    if (light.shape == Shape::spot) {
      const double outer = std::min(0.5 * light.angle, 0.5 * kPi);
      made.spot.outerConeAngle = outer;
      made.spot.innerConeAngle = std::min(outer * (1 - light.edge), outer * (1 - 1e-6));
      if (light.angle > kPi)
        unsupported_.push_back(fmt::format(
            "the light of '{}' behind it: glTF limits a cone to 180 degrees", light.name));
    }
    if (light.shape == Shape::rectangle || light.shape == Shape::disk) {
      made.spot.outerConeAngle = 0.5 * kPi;
      made.spot.innerConeAngle = 0;
      note_as_extras(
          fmt::format("the size of the light '{}', which is a spot light in glTF", light.name));
    }
    if (light.shape == Shape::rectangle) {
      shape.emplace("vug:width", Value(light.width));
      shape.emplace("vug:height", Value(light.height));
    } else if (light.shape == Shape::sun) {
      shape.emplace("vug:angle", Value(light.angle));
    } else {
      shape.emplace("vug:radius", Value(light.radius));
    }
    if (!light.profile.empty())
      unsupported_.push_back(
          fmt::format("the measured profile of the light '{}', which becomes uniform", light.name));
    made.extras = Value(shape);
    model_.lights.push_back(std::move(made));
    use("KHR_lights_punctual");
    tinygltf::Node at = node(light.name, decompose_trs(light.place).value_or(TrsTransform()));
    at.extensions["KHR_lights_punctual"] =
        Value(Value::Object{{"light", Value(static_cast<int>(model_.lights.size()) - 1)}});
    add_root_node(std::move(at));
  }

  const Assembly& assembly_;
  const std::filesystem::path file_;
  const FormatOptions& options_;
  tinygltf::Model model_;
  GltfBuffer buffer_;
  std::map<size_t, int> meshes_;
  UniqueNames names_;  ///< Names of environment maps.
  Value::Array skies_, volumes_;
  std::vector<std::filesystem::path> files_;  ///< Additional files next to the scene's.
  std::vector<std::string> unsupported_, notes_;
};

WriteReport write_glb(const Assembly& assembly, const std::filesystem::path& file,
                      const FormatOptions& options, Progress& progress) {
  GlbWriter writer(assembly, file, options);
  writer.add_groups(progress);
  writer.add_cameras();
  writer.add_lights();
  writer.add_volumes();
  return writer.save();
}

/// The JSON text is in the first chunk, after five 32-bit numbers.
std::vector<std::pair<std::string, std::string>> read_glb(std::string_view bytes,
                                                          const std::string& file) {
  constexpr size_t kHeader = 20;
  const auto refuse = [&] {
    return Error(ErrorCode::bad_input, "the file is not a binary glTF, or it is truncated",
                 {file, 0, 0});
  };
  uint32_t words[5] = {};
  if (bytes.size() < kHeader || bytes.substr(0, 4) != "glTF") throw refuse();
  std::memcpy(words, bytes.data(), sizeof words);
  if (words[2] != bytes.size() || words[3] > bytes.size() - kHeader) throw refuse();
  const auto json = nlohmann::json::parse(bytes.substr(kHeader, words[3]), nullptr, false);
  if (!json.is_object()) throw refuse();
  std::vector<std::pair<std::string, std::string>> texts;
  const auto asset = json.find("asset");
  if (asset == json.end() || !asset->is_object() || !asset->contains("extras")) return texts;
  for (const auto& [name, value] : asset->at("extras").items())
    if (value.is_primitive())
      texts.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
  return texts;
}

}  // namespace
}  // namespace vug::exchange

VUG_EXCHANGE_FORMAT(glb) {
  return {{"glb",
           "exchange format",
           "glTF 2.0, always in metres with y up: meshes with colours and attributes, instances, "
           "cameras, small lights",
           "gltf2",
           {}},
          Space{UpAxis::y, 1},
          false,
          write_glb,
          read_glb};
}
