// SPDX-License-Identifier: Apache-2.0
// For any bytes, the reader returns a pixel classifier that yields probabilities, or fails.
#include "require.h"
#include "target.h"

#include <vug/base/error.h>
#include <vug/fit/learning/pixel_classifier.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>

VUG_FUZZ_TARGET(pixel_classifier) {
  using namespace vug;
  const auto text = nlohmann::json::parse(data, data + size, nullptr, false);
  if (text.is_discarded()) return;
  try {
    const fit::PixelClassifier model = fit::PixelClassifier::from_json(text);
    const fit::Planes maps = model.classify(image::Image(3, 2, {"R", "G", "B"}));
    require(static_cast<int>(maps.count()) == model.classes().count(), "a map for each class");
    for (size_t i = 0; i < maps.pixels(); ++i) {
      double sum = 0;
      for (const fit::Plane& plane : maps.planes) {
        require(plane[i] > 0, "nothing is impossible");
        sum += plane[i];
      }
      require(std::fabs(sum - 1) < 1e-3, "something is there");
    }
    const nlohmann::json written = model.to_json();
    require(fit::PixelClassifier::from_json(written).to_json() == written,
            "what is written is read");
  } catch (const Error& error) {
    require(error.code() == ErrorCode::bad_input, "looks are bad");
  }
}
