// How far two pictures are apart, in numbers.
#pragma once

#include <vug/image/image.h>

#include <string>
#include <vector>

namespace vug::image {

struct ChannelDifference {
  std::string channel;
  double mean_a = 0;
  double mean_b = 0;
  double rmse = 0;           ///< Root of the mean squared difference.
  double relative_rmse = 0;  ///< rmse over the mean of |a|; 0 when rmse is 0.
  double mean_error = 0;     ///< Mean of |a - b|.
  double max_error = 0;      ///< Largest |a - b|.
};

/// One line for each channel of `a` and one called "all" over every channel at the end.
/// A pixel where both are NaN or the same infinity counts as equal, otherwise a value that is
/// not finite makes max_error infinite. Error(bad_input) when sizes or channel names differ.
std::vector<ChannelDifference> compare(const Image& a, const Image& b);

}  // namespace vug::image
