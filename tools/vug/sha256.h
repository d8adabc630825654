// SPDX-License-Identifier: Apache-2.0
// SHA-256 as computed by sha256sum and Python's hashlib, for hashes that other programs also
// compute.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace vug::cli {

class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void add(std::string_view bytes);
  std::string hex();  ///< 64 hexadecimal digits. Must be the last call.

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vug::cli
