// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/inference/choices.h>

#include <array>
#include <limits>

namespace vug::inference {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

/// The logarithm of a whole number; a table covers almost all choices.
double ln_of(int count) {
  static const std::array<double, 1024> table = [] {
    std::array<double, 1024> out{};
    for (size_t i = 1; i < out.size(); ++i) out[i] = maths::log(static_cast<double>(i));
    return out;
  }();
  const auto index = static_cast<size_t>(count);
  return index < table.size() ? table[index] : maths::log(count);
}

}  // namespace

void Choices::begin() {
  stream_ = nullptr;
  replayed_ = nullptr;
  trace_.clear();
  ln_ = 0;
}

void Choices::draw(RandomStream& stream) {
  begin();
  stream_ = &stream;
}

void Choices::replay(const ChoiceTrace& trace) {
  begin();
  replayed_ = &trace;
}

void Choices::score() { begin(); }

bool Choices::possible() const { return ln_ > kImpossible; }

int Choices::next() {
  if (trace_.size() >= replayed_->size())
    throw Error(ErrorCode::internal, "a move asks for more choices than its trace holds");
  return (*replayed_)[trace_.size()];
}

int Choices::below(int count, int given) {
  int value = given;
  if (stream_)
    value = count > 0 ? static_cast<int>(stream_->below(static_cast<uint32_t>(count))) : 0;
  else if (replayed_)
    value = next();
  trace_.push_back(value);
  ln_ = value >= 0 && value < count ? ln_ - ln_of(count) : kImpossible;
  return value;
}

int Choices::among(const DiscreteDistribution& profile, int low, int high, int given) {
  int value = given;
  if (stream_)
    value = low < high ? profile.find(low, high, stream_->uniform()) : low;
  else if (replayed_)
    value = next();
  trace_.push_back(value);
  ln_ = low < high ? ln_ + profile.ln_probability(low, high, value) : kImpossible;
  return value;
}

void Choices::append(const Choices& others) {
  trace_.insert(trace_.end(), others.trace_.begin(), others.trace_.end());
  ln_ += others.ln_;
}

}  // namespace vug::inference
