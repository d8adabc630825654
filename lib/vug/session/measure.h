// The metrics of what a scene builds, or of a file.
#pragma once

#include <vug/metrics/report.h>
#include <vug/session/build.h>

#include <filesystem>

namespace vug::session {

/// Measures one mesh of the shot: the named one, else the first. Cells are counted on the
/// volume's own lattice; productions are those of all of the shot's grammars.
/// Error(bad_input) when the shot has no such mesh.
metrics::Report measure(Builder& builder, const std::string& mesh = {});

/// Measures a mesh file, or the surface of a level set in a .vdb file.
metrics::Report measure_file(const std::filesystem::path& file,
                             Progress& progress = Progress::none());

}  // namespace vug::session
