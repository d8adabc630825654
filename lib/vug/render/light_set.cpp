#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/render/light_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vug::render {

/// Importances at a point: of skies, of lamps as they tell it themselves, of triangles and
/// branches by their bounds.
struct LightSet::AtPoint {
  const LightSet& set;
  const LitPoint& point;

  float sky(LightId id) const {
    if (!set.reaches(id, point.object)) return 0;
    const Light& light = *set.lights_[id];
    return (light.is_portal() ? set.sky_scale_ : 1) * light.importance(point);
  }
  float branch(const LightTree& tree, uint32_t node) const {
    if (&tree == &set.lamp_tree_ && tree.is_leaf(node)) {
      const LightId id = tree.light(node);
      return set.reaches(id, point.object) ? set.lights_[id]->importance(point) : 0;
    }
    return tree.importance(node, point);
  }
};

struct LightSet::AlongRay {
  const LightSet& set;
  const Ray& ray;
  const Segment& segment;

  float sky(LightId id) const {
    const Light& light = *set.lights_[id];
    return (light.is_portal() ? set.sky_scale_ : 1) *
           light.importance_along(ray, segment.begin, segment.end);
  }
  float branch(const LightTree& tree, uint32_t node) const {
    if (&tree == &set.lamp_tree_ && tree.is_leaf(node))
      return set.lights_[tree.light(node)]->importance_along(ray, segment.begin, segment.end);
    return tree.importance_along(node, ray, segment.begin, segment.end);
  }
};

LightSet::LightSet(std::vector<LightPtr> lights, const std::vector<Object>& objects)
    : lights_(std::move(lights)), emitters_(objects) {
  lights_.erase(std::remove(lights_.begin(), lights_.end(), nullptr), lights_.end());
  bool portals = false;
  for (LightId id = 0; id < lamp_ids(); ++id) {
    const Light& light = *lights_[id];
    portals |= light.is_portal();
    if (!light.is_sky() || light.is_portal()) continue;
    skies_.push_back(id);
    if (!light.beside_portals()) sky_scale_ += light.mean_luminance();
  }
  for (LightId id = 0; id < lamp_ids(); ++id) {
    const Light& light = *lights_[id];
    // Where portals are, they find the sky better than the sky does.
    if (!light.is_sky() ||
        (light.is_portal() ? !(sky_scale_ > 0) : portals && !light.beside_portals()))
      continue;
    sampled_skies_.push_back(id);
    branches_.push_back({nullptr, id});
  }
  lamp_tree_ = LightTree(lights_.size(), 0, [&](size_t i) {
    return lights_[i]->is_sky() ? LightBounds{} : lights_[i]->bounds();
  });
  emitter_tree_ = LightTree(emitters_.size(), lamp_ids(),
                            [&](size_t i) { return emitters_.bounds(static_cast<uint32_t>(i)); });
  for (const LightTree* tree : {&lamp_tree_, &emitter_tree_})
    for (const uint32_t node : tree->cut()) branches_.push_back({tree, node});
  link(objects);
  size_ = sampled_skies_.size() + lamp_tree_.size() + emitter_tree_.size();
  // Among branches of many lights there is less to be missed than among single ones.
  even_ = branches_.size() < size_ ? 0.25f : 0.5f;
  if (size_ <= kFew)
    for (const Branch& b : branches_) few_.push_back(b.tree ? b.tree->light(b.node) : b.node);
}

void LightSet::link(const std::vector<Object>& objects) {
  std::vector<std::string> names;
  for (const Object& object : objects) {
    names.push_back(object.name);
    object_groups_.push_back(group_of(object.light_group));
  }
  for (const LightPtr& light : lights_) {
    const LightNotes& notes = light->notes();
    light_groups_.push_back(group_of(notes.group));
    const bool only = !notes.only.empty();
    std::vector<bool> lit;
    if (only || !notes.except.empty()) lit.assign(objects.size(), !only);
    for (const std::string& name : only ? notes.only : notes.except) {
      bool found = false;
      for (size_t i = 0; i < names.size(); ++i)
        if (names[i] == name || names[i].compare(0, name.size() + 1, name + "/") == 0)
          lit[i] = only, found = true;
      if (!found)
        throw Error(ErrorCode::bad_input,
                    fmt::format("a light is linked to '{}', but no object has that name", name), {},
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
LightChoice LightSet::choose_by(float u, const Weight& weight) const {
  constexpr size_t kUsual = 2 * LightTree::kCutSize + 16;
  std::array<float, kUsual> few;
  std::vector<float> many;
  if (branches_.size() > kUsual) many.resize(branches_.size());
  float* const weights = many.empty() ? few.data() : many.data();
  double total = 0, count = 0;
  for (size_t i = 0; i < branches_.size(); ++i) {
    const Branch& branch = branches_[i];
    const float w =
        branch.tree ? weight.branch(*branch.tree, branch.node) : weight.sky(branch.node);
    weights[i] = w > 0 ? w : 0;
    if (!(w > 0)) continue;
    total += static_cast<double>(w);
    count += 1;
  }
  LightChoice choice;
  choice.odds = {false, static_cast<float>(total), static_cast<float>(count), even_};
  if (!(total > 0)) return choice;

  // Along all weights, or along as many equal parts, to where the number stands.
  const bool even = u < even_;
  const auto part = static_cast<double>(even_);
  const double place = even ? static_cast<double>(u) / part * count
                            : (static_cast<double>(u) - part) / (1 - part) * total;
  const Branch* chosen = nullptr;
  double passed = 0, width = 0;
  float chosen_weight = 0;
  for (size_t i = 0; i < branches_.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    passed += width;
    width = even ? 1 : static_cast<double>(weights[i]);
    chosen = &branches_[i];
    chosen_weight = weights[i];
    if (place < passed + width) break;
  }
  const double rest = std::clamp((place - passed) / width, 0.0, 0x1.fffffffffffffp-1);
  choice.light = chosen->node;
  choice.probability = choice.odds.of(chosen_weight);
  if (chosen->tree) {
    const LightTree::Found found = chosen->tree->descend(
        chosen->node, rest, [&](uint32_t node) { return weight.branch(*chosen->tree, node); });
    choice.light = found.light;
    choice.probability *= found.probability;
  }
  return choice;
}

template <class Weight>
float LightSet::share_by(LightId light, const Weight& weight, const LightOdds& odds) const {
  for (const LightTree* tree : {&lamp_tree_, &emitter_tree_}) {
    if (!tree->holds(light)) continue;
    const LightTree::Place place =
        tree->place(light, [&](uint32_t node) { return weight.branch(*tree, node); });
    return place.probability > 0 ? place.probability * odds.of(weight.branch(*tree, place.branch))
                                 : 0;
  }
  return light < lights_.size() && lights_[light]->is_sky() ? odds.of(weight.sky(light)) : 0;
}

LightChoice LightSet::choose(const LitPoint& point, float u) const {
  return choose_by(u, AtPoint{*this, point});
}
LightChoice LightSet::choose_along(const Ray& ray, const Segment& segment, float u) const {
  return choose_by(u, AlongRay{*this, ray, segment});
}
float LightSet::share(LightId light, const LitPoint& point, const LightOdds& odds) const {
  return share_by(light, AtPoint{*this, point}, odds);
}
float LightSet::share_along(LightId light, const Ray& ray, const Segment& segment,
                            const LightOdds& odds) const {
  return share_by(light, AlongRay{*this, ray, segment}, odds);
}

bool LightSet::sky_is_plain() const {
  const LitPoint anywhere{Vec3f(0.0f)};
  return std::all_of(sampled_skies_.begin(), sampled_skies_.end(), [&](LightId id) {
    const Light& sky = *lights_[id];
    return !sky.is_portal() && (sky.beside_portals() || !(sky.importance(anywhere) > 0));
  });
}

Rgb LightSet::sky_radiance(const Vec3f& direction, uint32_t object) const {
  Rgb sum(0.0f);
  for (const LightId id : skies_)
    if (reaches(id, object)) sum += lights_[id]->escape_radiance(direction);
  return sum;
}

float LightSet::sky_pdf(const LitPoint& point, const LightOdds& odds,
                        const Vec3f& direction) const {
  float sum = 0;
  for (const LightId id : sampled_skies_)
    if (const float samples = share(id, point, odds); samples > 0)
      sum += samples * lights_[id]->pdf(point, direction);
  return sum;
}

}  // namespace vug::render
