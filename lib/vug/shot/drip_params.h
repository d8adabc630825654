// SPDX-License-Identifier: Apache-2.0
// The parameters of the drips of a rock and of the speleothems that grow from them.
#pragma once

#include <vug/drips/build_graph.h>
#include <vug/drips/dripstone.h>
#include <vug/field/kind.h>
#include <vug/shot/drip_edits.h>
#include <vug/shot/geology.h>

#include <vector>

namespace vug::shot {

struct DripParams {
  field::Field field;
  Vec3d from{-5, -5, -5}, to{5, 5, 5};
  double spacing = drips::SeepOptions().spacing;
  double density = drips::SeepOptions().density;
  std::optional<field::Noise> where;
  std::vector<GeologyFeaturePtr> joints;
  int joint_seed = 1;
  double interval = drips::SeepOptions().interval;
  double age = drips::SeepOptions().oldest, final_age = 0;
  double temperature = drips::GraphOptions().temperature;
  double girth = drips::GraphOptions().girth;
  double straws = drips::GraphOptions().straws;
  int budget = 0;
  std::vector<DripEditPtr> edits;
  int seed = 1;
  double tip = 0.01;
  double stalagmites = drips::FormOptions().stalagmites;
  double broken = drips::FormOptions().broken;
  double draperies = drips::DraperyOptions().share;
  double folds = drips::DraperyOptions().fold;
  double flowstone = drips::FlowstoneOptions().share;

  drips::DripstoneOptions options() const;
  std::string fault() const;
};

template <class P>
void describe_drips(Schema<P>& s) {
  const auto share = [](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::ratio, .min = 0, .max = 1};
  };
  s.param("field", &DripParams::field, {.doc = "the rock", .required = true})
      .param("from", &DripParams::from, any_length("a corner of the box in which water drips"))
      .param("to", &DripParams::to, any_length("the opposite corner"))
      .param("spacing", &DripParams::spacing,
             positive_length("mean distance between the places at which water may drip"))
      .param(
          "density", &DripParams::density,
          {.doc = "greater values let more of these places drip: at 50 % about a third, at 100 % "
                  "all",
           .dimension = Dimension::ratio,
           .min = 0,
           .max = 1})
      .param("where", &DripParams::where,
             {.doc = "a noise by which the density varies: 0 at -1, twice at 1; every place drips "
                     "where that is 100 % or more"})
      .param("joints", &DripParams::joints,
             {.doc = "fractures, faults and beds, out of which most of the water comes"})
      .param("joint_seed", &DripParams::joint_seed,
             {.doc = "places of the joints; the seed of the network `karst` for the same joints",
              .min = 0})
      .param("interval", &DripParams::interval,
             {.doc = "median time between two drops in seconds; stalagmites under fast drips are "
                     "thick",
              .min = 0.5,
              .max = 1e6})
      .param("age", &DripParams::age,
             {.doc = "age of the oldest drips in years; most have a sixth of it",
              .min = 1,
              .max = 1e7})
      .param("final_age", &DripParams::final_age,
             {.doc = "the last age of a sequence in which 'age' has keys: stalactites break, and "
                     "added drips have their ages, relative to it; 0: 'age'",
              .min = 0,
              .max = 1e7})
      .param("temperature", &DripParams::temperature,
             {.doc = "temperature of the cave in degrees Celsius; in warm caves stone grows faster",
              .min = 0,
              .max = 30})
      .param("girth", &DripParams::girth,
             {.doc = "radius at the root of a stalactite that is one metre long",
              .dimension = Dimension::length,
              .min = 0.005,
              .max = 0.5})
      .param(
          "straws", &DripParams::straws,
          {.doc =
               "share of the drips with a straw in place of a stalactite; straws need a 'tip' of "
               "5.1 mm or less",
           .dimension = Dimension::ratio,
           .min = 0,
           .max = 1})
      .param("budget", &DripParams::budget,
             {.doc = "the number of places where water leaves the rock, those with the most water; "
                     "added drips do not count; 0: all",
              .min = 0})
      .param("edits", &DripParams::edits, {.doc = "drips that are added, moved or removed by hand"})
      .param("seed", &DripParams::seed, {.doc = "random seed; each seed gives different drips"})
      .param("tip", &DripParams::tip,
             positive_length("least radius of every form: 2.55 mm in nature, but 1.2 voxels of the "
                             "volume that shows it. Stalactites shorter than three of it are left "
                             "out"))
      .param("stalagmites", &DripParams::stalagmites,
             share("share of the drips with a stalagmite below"))
      .param("broken", &DripParams::broken, share("share of the stalactites that broke"))
      .param("draperies", &DripParams::draperies,
             share("share of the films under sloping roofs along which draperies hang"))
      .param("folds", &DripParams::folds, positive_length("mean distance of their folds"))
      .param("flowstone", &DripParams::flowstone,
             share("share of the films on walls and floors that leave a skin of flowstone"));
}

}  // namespace vug::shot
