// SPDX-License-Identifier: Apache-2.0
// Collects the meshes of a scene or of a file for the report of metrics/report.h.
#pragma once

#include <vug/building/builder.h>
#include <vug/metrics/report.h>

#include <filesystem>

namespace vug::delivery {

/// Measures one mesh of the shot: the named one, else the first. Volume cells are counted on the
/// volume's own lattice; productions are those of all grammars of the shot. Error(bad_input) if the
/// shot has no such mesh.
metrics::Report measure(building::Builder& builder, const std::string& mesh = {});

/// Measures a mesh file, or the surface of a level set in a .vdb file.
metrics::Report measure_file(const std::filesystem::path& file,
                             Progress& progress = Progress::none());

}  // namespace vug::delivery
