// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/render/lighting/light_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vug::render {
namespace {

/// Fraction of the samples distributed uniformly over the branches: for branches of single lights,
/// for branches of many lights, where less can be missed, and if visibility is known.
constexpr double kEvenFew = 0.5, kEvenMany = 0.25, kEvenKnown = 0.05;

/// A sky that samples no directions.
bool is_plain(const Light& sky) { return !(sky.importance({Vec3f(0.0f)}) > 0); }

}  // namespace

/// Importance at a point: skies and finite lights evaluate their own, triangles and branches use
/// their bounds.
struct LightSet::AtPoint {
  const LightSet& set;
  const LightSampleContext& point;
  const float* visibility;

  bool has_visibility() const { return visibility; }
  float branch_visibility(size_t branch) const { return visibility ? visibility[branch] : 1; }
  float light(LightId id) const {
    return set.reaches(id, point.object) ? set.lights_[id]->importance(point) : 0;
  }
  LightTree::Weights node_importances(const LightTree& tree, const LightTree::Node& node) const {
    if (&tree != &set.light_tree_) return LightTree::importance(node, point);
    LightTree::Weights weights{};
    if (!node.has_only_leaves()) weights = LightTree::importance(node, point);
    for (size_t lane = 0; lane < LightTree::kWidth; ++lane)
      if (node.is_leaf(lane)) weights[lane] = light(node.light(lane));
    return weights;
  }
};

struct LightSet::AlongRay {
  const LightSet& set;
  const Ray& ray;
  const Segment& segment;
  const VisibilityCache& visibility;

  bool has_visibility() const { return !visibility.empty(); }
  /// Visibility at the nearest point on the ray, where most of the branch's light arrives.
  float branch_visibility(size_t branch) const {
    if (visibility.empty()) return 1;
    const float nearest = dot(set.branches_[branch].center - ray.origin, ray.direction);
    return visibility.at(ray.at(std::clamp(nearest, segment.begin, segment.end)))[branch];
  }
  float light(LightId id) const {
    return set.lights_[id]->importance_along(ray, segment.begin, segment.end);
  }
  LightTree::Weights node_importances(const LightTree& tree, const LightTree::Node& node) const {
    const float begin = segment.begin, end = segment.end;
    if (&tree != &set.light_tree_) return LightTree::importance_along(node, ray, begin, end);
    LightTree::Weights weights{};
    if (!node.has_only_leaves()) weights = LightTree::importance_along(node, ray, begin, end);
    for (size_t lane = 0; lane < LightTree::kWidth; ++lane)
      if (node.is_leaf(lane)) weights[lane] = light(node.light(lane));
    return weights;
  }
};

LightSet::LightSet(std::vector<LightPtr> lights, const std::vector<Object>& objects,
                   const std::vector<std::string>& omitted)
    : lights_(std::move(lights)), emitters_(objects) {
  lights_.erase(std::remove(lights_.begin(), lights_.end(), nullptr), lights_.end());
  for (LightId id = 0; id < scene_light_count(); ++id) {
    const Light& light = *lights_[id];
    has_portals_ |= light.is_portal();
    if (!light.is_infinite() || light.is_portal()) continue;
    skies_.push_back(id);
    if (!light.sampled_with_portals()) sky_scale_ += light.mean_luminance();
  }
  for (LightId id = 0; id < scene_light_count(); ++id) {
    const Light& light = *lights_[id];
    // Portals find a uniform sky; other skies know where they are bright.
    if (!light.is_infinite() ||
        (light.is_portal() ? !(sky_scale_ > 0) : has_portals_ && is_plain(light)))
      continue;
    sampled_skies_.push_back(id);
    branches_.push_back({nullptr, 0, id, light.is_portal() ? sky_scale_ : 1, light.center()});
  }
  light_tree_ = LightTree(lights_.size(), 0, [&](size_t i) {
    return lights_[i]->is_infinite() ? LightBounds{} : lights_[i]->bounds();
  });
  emitter_tree_ = LightTree(emitters_.size(), scene_light_count(),
                            [&](size_t i) { return emitters_.bounds(static_cast<uint32_t>(i)); });
  for (const LightTree* tree : {&light_tree_, &emitter_tree_})
    for (uint32_t i = 0; i < tree->branches(); ++i) {
      const LightTree::Node& node = tree->node(i / LightTree::kWidth);
      const size_t lane = i % LightTree::kWidth;
      const bool single = tree == &light_tree_ && node.has_only_leaves();
      branches_.push_back({tree, i, single ? node.light(lane) : kNoLight, 1, node.center(lane)});
    }
  for (const LightId sky : sampled_skies_)
    if (lights_[sky]->is_portal() || !is_plain(*lights_[sky])) all_.push_back(sky);
  for (const LightTree* tree : {&light_tree_, &emitter_tree_})
    for (LightId id = 0; id < scene_light_count() + emitters_.size(); ++id)
      if (tree->contains(id)) all_.push_back(id);
  link(objects, omitted);
  size_ = sampled_skies_.size() + light_tree_.size() + emitter_tree_.size();
}

void LightSet::link(const std::vector<Object>& objects, const std::vector<std::string>& omitted) {
  std::vector<std::string> names;
  for (const Object& object : objects) {
    names.push_back(object.name);
    object_groups_.push_back(group_of(object.light_group));
  }
  for (const LightPtr& light : lights_) {
    const LightLinking& linking = light->linking();
    light_groups_.push_back(group_of(linking.group));
    const bool only = !linking.only.empty();
    std::vector<bool> lit;
    if (only || !linking.except.empty()) lit.assign(objects.size(), !only);
    for (const std::string& name : only ? linking.only : linking.except) {
      bool found = std::any_of(omitted.begin(), omitted.end(), [&](const std::string& each) {
        return name == each || name.compare(0, each.size() + 1, each + "/") == 0;
      });
      for (size_t i = 0; i < names.size(); ++i)
        if (names[i] == name || names[i].compare(0, name.size() + 1, name + "/") == 0)
          lit[i] = only, found = true;
      if (!found)
        throw Error(
            ErrorCode::bad_input,
            fmt::format("a light is linked to '{}', but there is no object of that name", name), {},
            suggestion(name, names));
    }
    linked_ |= !lit.empty();
    lit_.push_back(std::move(lit));
  }
}

uint32_t LightSet::group_of(const std::string& name) {
  if (name.empty()) return kNoGroup;
  const auto at = std::find(group_names_.begin(), group_names_.end(), name);
  if (at != group_names_.end()) return static_cast<uint32_t>(at - group_names_.begin());
  group_names_.push_back(name);
  return static_cast<uint32_t>(group_names_.size() - 1);
}

template <class Weight>
float LightSet::weight_of(size_t branch, const Weight& weight) const {
  const Branch& b = branches_[branch];
  const auto in_tree = [&] {
    const LightTree::Node& node = b.tree->node(b.index / LightTree::kWidth);
    return weight.node_importances(*b.tree, node)[b.index % LightTree::kWidth];
  };
  const float importance = b.single != kNoLight ? weight.light(b.single) * b.scale : in_tree();
  return importance > 0 ? importance * weight.branch_visibility(branch) : 0;
}

/// `weight_of` all branches.
template <class Weight>
void LightSet::weigh(const Weight& weight, float* weights) const {
  const LightTree::Node* known = nullptr;
  LightTree::Weights importances;  // NOLINT: of the known node
  for (size_t i = 0; i < branches_.size(); ++i) {
    const Branch& b = branches_[i];
    if (b.single != kNoLight) {
      weights[i] = weight_of(i, weight);
      continue;
    }
    const LightTree::Node& node = b.tree->node(b.index / LightTree::kWidth);
    if (&node != known) importances = weight.node_importances(*b.tree, node), known = &node;
    const float importance = importances[b.index % LightTree::kWidth];
    weights[i] = importance > 0 ? importance * weight.branch_visibility(i) : 0;
  }
}

template <class Weight>
LightChoice LightSet::choose_in(const Branch& branch, double u, const Weight& weight) const {
  if (branch.single != kNoLight) return {branch.single, 1};
  const LightTree::SampledLeaf found = branch.tree->descend(
      branch.index, u,
      [&](const LightTree::Node& node) { return weight.node_importances(*branch.tree, node); });
  return {found.light, found.probability};
}

template <class Weight>
LightChoices LightSet::choose_by(float u, const Weight& weight, LightSelection& selection) const {
  constexpr size_t kUsual = 2 * LightTree::kMaxBranches + 16;
  std::array<float, kUsual> few;  // NOLINT: filled by weigh
  std::vector<float> many;
  if (branches_.size() > kUsual) many.resize(branches_.size());
  float* const weights = many.empty() ? few.data() : many.data();
  weigh(weight, weights);
  double total = 0, count = 0;
  for (size_t i = 0; i < branches_.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    total += static_cast<double>(weights[i]);
    count += 1;
  }
  LightChoices choices;
  if (!(total > 0)) return choices;
  const double even = weight.has_visibility()    ? kEvenKnown
                      : branches_.size() < size_ ? kEvenMany
                                                 : kEvenFew;
  const auto samples = static_cast<double>(selection.samples);
  selection.proportional = static_cast<float>(samples * (1 - even) / total);
  selection.even = static_cast<float>(samples * even / count);

  // Systematic sampling: equidistant positions over the cumulative expected samples of the
  // branches.
  double passed = 0, tooth = static_cast<double>(u);
  for (size_t i = 0; i < branches_.size(); ++i) {
    const float expected = selection.expected_samples(weights[i]);
    const auto width = static_cast<double>(expected);
    if (tooth < passed + width) {
      const double rest = std::clamp((tooth - passed) / width, 0.0, 0x1.fffffffffffffp-1);
      LightChoice choice = choose_in(branches_[i], rest, weight);
      choice.probability *= expected;
      choice.visibility = weight.branch_visibility(i);
      if (choice.light != kNoLight) choices.add(choice);
      tooth += 1;
    }
    passed += width;
  }
  return choices;
}

/// Systematic sampling, too, over lights of equal weight.
LightChoices LightSet::choose_evenly(float u, uint32_t object, LightSelection& selection) const {
  LightChoices choices;
  if (all_.empty()) return choices;
  const auto count = static_cast<float>(all_.size());
  selection.proportional = 0, selection.even = std::min(1.0f, selection.samples / count);
  for (float tooth = u; tooth < count * selection.even; tooth += 1) {
    const size_t i = std::min(static_cast<size_t>(tooth / selection.even), all_.size() - 1);
    if (reaches(all_[i], object)) choices.add({all_[i], selection.even});
  }
  return choices;
}

bool LightSet::can_choose(LightId light, uint32_t object) const {
  return reaches(light, object) &&
         (light_tree_.contains(light) || emitter_tree_.contains(light) ||
          std::find(sampled_skies_.begin(), sampled_skies_.end(), light) != sampled_skies_.end());
}

LightChoices LightSet::choose(const LightSampleContext& point, float u,
                              LightSelection& selection) const {
  if (selection.sampler == LightSampler::uniform) return choose_evenly(u, point.object, selection);
  return choose_by(u, AtPoint{*this, point, selection.visibility}, selection);
}
LightChoices LightSet::choose_along(const Ray& ray, const Segment& segment, float u,
                                    LightSelection selection,
                                    const VisibilityCache& visibility) const {
  if (selection.sampler == LightSampler::uniform) return choose_evenly(u, kNoObject, selection);
  return choose_by(u, AlongRay{*this, ray, segment, visibility}, selection);
}
LightChoice LightSet::choose_in(size_t branch, const LightSampleContext& point, float u) const {
  const AtPoint weight{*this, point, nullptr};
  return weight_of(branch, weight) > 0
             ? choose_in(branches_[branch], static_cast<double>(u), weight)
             : LightChoice{};
}

float LightSet::pmf(LightId light, const LightSampleContext& point,
                    const LightSelection& selection) const {
  if (selection.sampler == LightSampler::uniform)
    return can_choose(light, point.object) ? selection.even : 0;
  const AtPoint weight{*this, point, selection.visibility};
  size_t branch = sampled_skies_.size();
  for (const LightTree* tree : {&light_tree_, &emitter_tree_}) {
    if (tree->contains(light)) {
      const LightTree::Location location = tree->locate(
          light, [&](const LightTree::Node& node) { return weight.node_importances(*tree, node); });
      return location.probability > 0
                 ? location.probability *
                       selection.expected_samples(weight_of(branch + location.branch, weight))
                 : 0;
    }
    branch += tree->branches();
  }
  for (size_t i = 0; i < sampled_skies_.size(); ++i)
    if (sampled_skies_[i] == light) return selection.expected_samples(weight_of(i, weight));
  return 0;
}

bool LightSet::needs_portals() const {
  bool sun = false, sampled = false;
  for (const LightId id : skies_) {
    const Light& sky = *lights_[id];
    sun |= sky.sampled_with_portals();
    sampled |= !sky.sampled_with_portals() && !is_plain(sky);
  }
  return has_sky() && !has_portals_ && !(sun && sampled);
}

Rgb LightSet::sky_radiance(const Vec3f& direction, uint32_t object) const {
  Rgb sum(0.0f);
  for (const LightId id : skies_)
    if (reaches(id, object)) sum += lights_[id]->eval_environment(direction);
  return sum;
}

float LightSet::sky_pdf(const LightSampleContext& point, const LightSelection& selection,
                        const Vec3f& direction, LightId known) const {
  float sum = 0;
  const AtPoint weight{*this, point, selection.visibility};
  for (size_t i = 0; i < sampled_skies_.size(); ++i) {
    if (sampled_skies_[i] == known) continue;
    const float samples = selection.sampler == LightSampler::uniform
                              ? reaches(sampled_skies_[i], point.object) * selection.even
                              : selection.expected_samples(weight_of(i, weight));
    if (samples > 0) sum += samples * lights_[sampled_skies_[i]]->pdf(point, direction);
  }
  return sum;
}

}  // namespace vug::render
