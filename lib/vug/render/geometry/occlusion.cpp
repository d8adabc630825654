// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/render/geometry/occlusion.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampling.h>

#include <bit>
#include <cmath>

namespace vug::render {
namespace {

Scene scene_of(const std::vector<mesh::MeshPtr>& meshes) {
  Scene scene;
  for (const mesh::MeshPtr& mesh : meshes) {
    Object object;
    object.name = "surface";
    object.mesh = mesh;
    scene.objects.push_back(object);
  }
  return scene;
}

/// Offset of a point's pattern of directions, which decorrelates the errors of neighbours.
Vec2d shift(const Vec3f& point) {
  RandomKey key(0x6f70656e);
  for (int c = 0; c < 3; ++c) key = key.at(uint64_t{std::bit_cast<uint32_t>(point[c])});
  RandomStream random(key);
  const double first = random.uniform();
  return {first, random.uniform()};
}

}  // namespace

struct Openness::Surroundings {
  PreparedScene world;
};

Openness::Openness(const std::vector<mesh::MeshPtr>& meshes)
    : surroundings_(new Surroundings{PreparedScene(scene_of(meshes))}) {}
Openness::~Openness() = default;

std::vector<float> Openness::compute(const std::vector<Vec3f>& points,
                                     const std::vector<Vec3f>& normals,
                                     const OpennessOptions& options, Progress& progress) const {
  constexpr size_t kBlock = 1024;
  constexpr double kGolden = 0.6180339887498949;
  std::vector<float> shares(points.size());
  const size_t blocks = (points.size() + kBlock - 1) / kBlock;
  const auto offset = static_cast<float>(options.offset),
             max_distance = static_cast<float>(options.max_distance);
  progress.begin("computing openness", blocks);
  parallel_for(blocks, [&](size_t block) {
    progress.check();
    const size_t end = std::min(points.size(), (block + 1) * kBlock);
    for (size_t i = block * kBlock; i < end; ++i) {
      const Frame frame(normals[i]);
      const Vec2d start = shift(points[i]);
      int open = 0;
      // The golden ratio between azimuths distributes directions evenly over the projected disk.
      for (int ray = 0; ray < options.rays; ++ray) {
        const double out = (ray + start.x) / options.rays, turn = start.y + kGolden * ray;
        const Vec2f u(static_cast<float>(out), static_cast<float>(turn - std::floor(turn)));
        const Vec3f direction = frame.to_world(sample_cosine_hemisphere(u));
        if (options.sky && direction.y <= 0) continue;
        open += !surroundings_->world.occluded(Ray{points[i] + normals[i] * offset, direction},
                                               max_distance);
      }
      shares[i] = static_cast<float>(open) / static_cast<float>(options.rays);
    }
    progress.advance();
  });
  progress.end();
  return shares;
}

}  // namespace vug::render
