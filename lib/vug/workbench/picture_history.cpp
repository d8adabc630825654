// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/pluralize.h>
#include <vug/image/measure.h>
#include <vug/viewport/scaled_codes.h>
#include <vug/workbench/picture_history.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vug::workbench {
namespace {

const std::vector<std::string> kBeautyChannels = {"R", "G", "B"};

/// The pixels of `a`, changed by `change(x, pixel of a, pixel of b)`.
template <class Change>
ShownPicture combined(const ShownPicture& a, const ShownPicture& b, const Change& change) {
  ShownPicture out = a;
  if (b.rgb.empty()) return out;
  const std::vector<uint8_t> below =
      viewport::scaled_codes(b.rgb, b.width, b.height, a.width, a.height);
  for (size_t at = 0; at < below.size(); at += 3)
    change(static_cast<int>(at / 3) % a.width, &out.rgb[at], &below[at]);
  return out;
}

}  // namespace

std::string KeptPicture::settings() const {
  std::string out =
      fmt::format("{}, {} x {}, {}", viewport::mode_names()[static_cast<size_t>(mode)], shown.width,
                  shown.height, pluralize(static_cast<size_t>(samples), "sample"));
  if (mode != viewport::Mode::path) return out;
  if (display.stops != 0) out += fmt::format(", exposure {:+.2g}", display.stops);
  if (!display.view.empty()) out += ", " + display.view;
  if (!display.layer.empty()) out += ", layer " + display.layer;
  if (display.denoise) out += ", denoised";
  return out;
}

size_t KeptPicture::bytes() const {
  return shown.rgb.size() + light.pixels.size() * sizeof(float) + text->size();
}

const std::vector<std::string>& comparison_names() {
  static const std::vector<std::string> names = {"off", "wipe", "difference"};
  return names;
}

ComparisonMode comparison_of(const std::string& name) {
  const auto& names = comparison_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(ErrorCode::bad_input, fmt::format("unknown comparison '{}'", name), {},
                fmt::format("use one of: {}", fmt::join(names, ", ")));
  return static_cast<ComparisonMode>(found - names.begin());
}

ShownPicture wiped(const ShownPicture& a, const ShownPicture& b, double edge) {
  const int first = static_cast<int>(std::lround(edge * a.width));
  return combined(a, b, [&](int x, uint8_t* to, const uint8_t* from) {
    if (x >= first) std::copy_n(from, 3, to);
  });
}

ShownPicture difference_of(const ShownPicture& a, const ShownPicture& b) {
  return combined(a, b, [](int, uint8_t* to, const uint8_t* from) {
    for (int c = 0; c < 3; ++c) to[c] = static_cast<uint8_t>(std::abs(to[c] - from[c]));
  });
}

const KeptPicturePtr& PictureHistory::find(int number) const {
  for (const KeptPicturePtr& each : all_)
    if (each->number == number) return each;
  throw Error(ErrorCode::bad_input, fmt::format("the history has no picture {}", number), {},
              all_.empty() ? "keep one first: keep_picture"
                           : fmt::format("the last one is {}", all_.back()->number));
}

int PictureHistory::keep(const viewport::Preview& picture) {
  const auto& scene = *picture.scene.scene;
  if (!scene.text)
    throw Error(ErrorCode::bad_input, "the text of the picture is unknown", {},
                "build the text in the viewport");
  auto kept = std::make_shared<KeptPicture>();
  kept->number = ++last_;
  kept->text = scene.text;
  kept->view = picture.view;
  kept->mode = picture.mode;
  kept->display = picture.display;
  kept->samples = picture.samples;
  kept->shown = {picture.width, picture.height, picture.rgb};
  kept->light = picture.light->select(kBeautyChannels);
  all_.push_back(kept);
  size_t sum = 0;
  for (const KeptPicturePtr& each : all_) sum += each->bytes();
  while (sum > most_bytes_ && all_.size() > 1) {
    sum -= all_.front()->bytes();
    forget(all_.front()->number);
  }
  ++revision_;
  return last_;
}

void PictureHistory::forget(int number) {
  find(number);
  all_.erase(std::remove_if(all_.begin(), all_.end(),
                            [&](const KeptPicturePtr& each) { return each->number == number; }),
             all_.end());
  if (shown_ == number) shown_ = 0;
  if (reference_ == number) reference_ = 0;
  ++revision_;
}

void PictureHistory::clear() {
  all_.clear();
  shown_ = reference_ = 0;
  comparison_ = ComparisonMode::off;
  ++revision_;
}

void PictureHistory::show(int number) {
  if (number != 0) find(number);
  shown_ = number;
  ++revision_;
}

void PictureHistory::set_reference(int number) {
  if (number != 0) find(number);
  reference_ = number;
  ++revision_;
}

void PictureHistory::compare(ComparisonMode mode) {
  comparison_ = mode;
  ++revision_;
}

void PictureHistory::set_edge(double edge) {
  edge_ = std::clamp(edge, 0.0, 1.0);
  ++revision_;
}

std::shared_ptr<const ShownPicture> PictureHistory::picture(
    int number, const viewport::PreviewPtr& live) const {
  if (number != 0) {
    const KeptPicturePtr& kept = find(number);
    return {kept, &kept->shown};
  }
  if (!live) return std::make_shared<const ShownPicture>();
  return std::make_shared<const ShownPicture>(ShownPicture{live->width, live->height, live->rgb});
}

image::Image PictureHistory::light(int number, const viewport::PreviewPtr& live) const {
  if (number != 0) return find(number)->light;
  if (!live)
    throw Error(ErrorCode::bad_input, "the first picture is not finished", {}, "wait for it");
  return live->light->select(kBeautyChannels);
}

std::shared_ptr<const ShownPicture> PictureHistory::displayed(
    const viewport::PreviewPtr& live) const {
  if (comparison_ == ComparisonMode::off && shown_ == 0) return nullptr;
  const auto a = picture(shown_, live);
  if (comparison_ == ComparisonMode::off) return a;
  const auto b = picture(reference_, live);
  return std::make_shared<const ShownPicture>(
      comparison_ == ComparisonMode::wipe ? wiped(*a, *b, edge_) : difference_of(*a, *b));
}

double PictureHistory::difference(const viewport::PreviewPtr& live) const {
  return image::measure("rmse", light(reference_, live), light(shown_, live));
}

}  // namespace vug::workbench
