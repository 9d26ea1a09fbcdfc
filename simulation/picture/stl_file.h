// A surface as a binary STL file: what slicers, viewers and CAM systems read. mm.
#pragma once

#include <filesystem>
#include <string>

#include "simulation/surface_mesh.h"

namespace stanok::simulation {

// "" or why the file could not be written whole.
[[nodiscard]] std::string write_stl(const Mesh& mesh, const std::filesystem::path& file,
                                    std::string_view title);

}  // namespace stanok::simulation
