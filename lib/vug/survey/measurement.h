// SPDX-License-Identifier: Apache-2.0
// Vectors of legs and their covariances, computed from readings that are calibrated and in metres
// and radians. Bearings count from north to east, gradients are positive upwards. The variance
// model is that of Survex: each station has an error of its own, to which the errors of the
// instruments are added, propagated to first order.
#pragma once

#include <vug/survey/observations.h>

namespace vug::survey {

/// Standard deviations of readings in metres and radians; the initialisers are Survex's defaults.
struct Deviations {
  double position = 0.05;  ///< Position of a station.
  double tape = 0.05;
  double count = 0.05;
  double depth = 0.05;
  double coordinate = 0.05;  ///< Easting, northing and altitude.
  double compass = 0.5 * kPi / 180;
  double clino = 0.5 * kPi / 180;
  double level = 0.25 * kPi / 180;
  double plumb = 0.25 * kPi / 180;
};

/// A reading, possibly the average of two, with its variance.
struct Reading {
  double value = 0;
  double variance = 0;
};

/// The average of a reading and its repetition in the other direction, weighted by their variances.
/// `disagreement` is the difference in standard deviations. Both values have the same sense.
struct Averaged {
  Reading reading;
  double disagreement = 0;
};
Averaged average(const Reading& fore, const Reading& back);
/// The same for angles, of which the difference may contain whole turns.
Averaged average_bearing(const Reading& fore, const Reading& back);

struct MeasuredVector {
  Vec3d vector{0.0};
  Covariance covariance;
};

/// The vector and its covariance after a rotation about the z axis: `angle` is added to bearings.
MeasuredVector turned(const MeasuredVector& leg, double angle);

/// `position` is the variance of a station (a third of it is added to each axis).
MeasuredVector polar_leg(const Reading& tape, const Reading& bearing, const Reading& gradient,
                         double position);
/// A leg without a gradient: level, with a standard deviation of height of L / sqrt(10).
MeasuredVector unlevelled_leg(const Reading& tape, const Reading& bearing, double position);
/// A vertical leg; `height` is signed, `plumb` the variance of the plumb line's angle.
MeasuredVector plumb_leg(const Reading& height, double plumb, double position);
/// The slope distance, the bearing and the difference in altitude. If the difference exceeds the
/// distance, the leg is vertical and its height is the average of both.
MeasuredVector diving_leg(const Reading& tape, const Reading& bearing, const Reading& rise,
                          double position);
/// The horizontal distance, the bearing and the difference in altitude.
MeasuredVector cylindrical_leg(const Reading& distance, const Reading& bearing, const Reading& rise,
                               double position);

}  // namespace vug::survey
