// SPDX-License-Identifier: Apache-2.0
// Statistics of three decorated chambers, with the numbers of the styles show_cave, pristine and
// dry: drips follow joints, stalagmites are under their drops, sizes are spread, roots end in rock.
#include <vug/drips/growth.h>
#include <vug/drips/surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "decorated_chambers.h"

namespace vug::drips {
namespace {

double spread_of_logarithms(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double v : values) sum += std::log(v), squares += std::log(v) * std::log(v);
  const auto n = static_cast<double>(values.size());
  return std::sqrt(std::max(0.0, squares / n - sum * sum / n / n));
}

class Chambers : public testing::TestWithParam<Style> {
 protected:
  Chambers()
      : o_(options_of(GetParam())),
        rock_(rock_of(o_)),
        graph_(build_graph(rock_, o_.graph)),
        grown_(grow_dripstone(rock_, graph_, o_)) {
    for (const Node& node : graph_.nodes)
      if (node.kind == NodeKind::drop) drops_.emplace(node.id, &node);
  }

  DripstoneOptions o_;
  field::Field rock_;
  Graph graph_;
  Dripstone grown_;
  std::map<int64_t, const Node*> drops_;
};

TEST_P(Chambers, DripsLieNearerToJointsThanAThirdOfRandomSites) {
  const Planes planes = joints();
  const auto distance = [&](const Vec3d& p) { return std::fabs(planes.nearest(p)->distance); };
  std::vector<double> dripping, anywhere;
  for (const auto& [id, drop] : drops_) dripping.push_back(distance(drop->position));
  SeepOptions sites = o_.graph;
  sites.planes.reset();
  sites.density = 1;
  for (const Seep& seep : find_seeps(rock_, sites)) anywhere.push_back(distance(seep.position));
  ASSERT_GT(dripping.size(), 80u);
  ASSERT_GT(anywhere.size(), 200u);
  EXPECT_LT(median(dripping), median(anywhere) / 3);
}

TEST_P(Chambers, StalagmitesAreUnderTheirDrops) {
  int standing = 0;
  for (const Form& form : grown_.forms) {
    ASSERT_TRUE(drops_.contains(form.drip)) << "no form is without a source";
    if (form.kind != FormKind::stalagmite && form.kind != FormKind::column) continue;
    ++standing;
    const Node& drop = *drops_[form.drip];
    const Vec3d& apex = form.top;
    EXPECT_LE(std::hypot(apex.x - drop.tip.x, apex.z - drop.tip.z),
              0.03 + 0.01 * (drop.position.y - apex.y));
    EXPECT_LE(std::hypot(form.bottom.x - drop.tip.x, form.bottom.z - drop.tip.z),
              0.03 + 0.085 * (form.top.y - form.bottom.y))
        << "the foot is aside by a small part of the height";
  }
  EXPECT_GT(standing, 30);
}

TEST_P(Chambers, SizesAreSpread) {
  std::map<FormKind, std::vector<double>> lengths;
  for (const Form& form : grown_.forms)
    if (form.sunk == 0 && form.kind != FormKind::column && form.kind != FormKind::piece)
      lengths[form.kind].push_back((form.top - form.bottom).length());
  std::vector<double> hanging = lengths[FormKind::stalactite];
  const std::vector<double>& straws = lengths[FormKind::straw];
  hanging.insert(hanging.end(), straws.begin(), straws.end());
  std::vector<double> all = hanging;
  const std::vector<double>& standing = lengths[FormKind::stalagmite];
  all.insert(all.end(), standing.begin(), standing.end());
  EXPECT_GE(spread_of_logarithms(hanging), 0.7);
  EXPECT_GE(spread_of_logarithms(standing), 0.7);
  EXPECT_GE(spread_of_logarithms(all), 0.7);
}

TEST_P(Chambers, StrawsAreAsWideAsADropOrAVoxel) {
  FormOptions fine = o_.forms;
  fine.tip = 0.002;
  int straws = 0;
  for (const Form& form : forms_of(graph_, fine)) {
    if (form.kind != FormKind::straw) continue;
    ++straws;
    EXPECT_NEAR(2 * form.radius, 0.0051, 1e-4);
  }
  if (GetParam().straws > 0) {
    EXPECT_GT(straws, 20);
  }
  // With the voxels of the style, hanging forms are wider than a voxel, and none counts as a straw.
  for (const Form& form : grown_.forms) {
    EXPECT_GE(2 * form.radius, GetParam().voxel);
    EXPECT_FALSE(form.kind == FormKind::straw && form.radius > 0.0052);
  }
}

TEST_P(Chambers, RootsEndInTheRock) {
  const field::StalactiteCurve curve = common_curve(o_.forms.girth);
  int ring = 0, outside = 0, forms = 0, hollow = 0;
  for (const Form& form : grown_.forms) {
    if (form.kind == FormKind::piece) continue;
    const bool stands = form.kind == FormKind::stalagmite;
    const Vec3d root = stands ? form.bottom - Vec3d(0, form.root, 0) : form.top;
    EXPECT_LT(rock_.value(root), 0.01) << kind_name(form.kind) << " " << form.drip;
    // The rim of the end that is in the rock.
    const std::vector<Vec2d> outline = outline_of(form, o_.forms, curve);
    const double wide = stands ? outline[outline.size() - 2].x : form.radius;
    const Vec3d end = stands ? root : form.top + Vec3d(0, form.sunk + form.root, 0);
    int out = 0;
    for (int i = 0; i < 12; ++i) {
      const double turn = 2 * kPi * i / 12;
      ++ring;
      out += rock_.value(end + Vec3d(wide * std::cos(turn), 0, wide * std::sin(turn))) > 0;
    }
    hollow += out > 6;
    ++forms;
    outside += out;
  }
  ASSERT_GT(ring, 500);
  EXPECT_LT(outside, 0.05 * ring) << "roots end in the rock all around, but for a few in hollows";
  // Some hang from pendants or stand on edges that are narrower than their root.
  EXPECT_LT(hollow, 0.05 * forms);
  for (const HungDrapery& drapery : grown_.draperies)
    for (const Vec3d& p : drapery.sheet.path)
      EXPECT_LT(rock_.value(p + Vec3d(0, drapery.sheet.root, 0)), 0.005);
  for (const field::Deposit& layer : grown_.layers)
    EXPECT_LT(std::fabs(rock_.value(layer.from)), 0.02) << "flowstone lies on the rock";
}

INSTANTIATE_TEST_SUITE_P(Styles, Chambers, testing::ValuesIn(kStyles),
                         [](const auto& style) { return std::string(style.param.name); });

}  // namespace
}  // namespace vug::drips
