// SPDX-License-Identifier: Apache-2.0
// A facade bench with the session of the data, and helpers for tests.
#pragma once

#include <gtest/gtest.h>
#include <vug/base/scratch_folder.h>
#include <vug/modeller/session.h>
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace vug::workbench {

inline std::string paris_photo() { return VUG_DATA "/facades/sessions/paris.jpg"; }
inline std::string paris_session() { return VUG_DATA "/facades/sessions/paris.json"; }

inline void run(FacadeBench& bench, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) run_command(bench, line);
}

/// The session as text, with undone edits.
inline std::string text_of(const FacadeBench& bench) {
  return modeller::session_text(bench.document().session(bench.stack().undone()));
}

/// The message of the error of a command; empty if it succeeds.
inline std::string refusal(FacadeBench& bench, const std::string& line) {
  try {
    run_command(bench, line);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Polls until no thread works. False after two minutes.
inline bool wait(FacadeBench& bench) {
  for (int i = 0; i < 12'000; ++i) {
    bench.poll();
    if (!bench.busy()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace vug::workbench
