// The picture of a part for people: four views at one scale, labelled, as a PNG file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "simulation/picture/shaded_view.h"

namespace stanok::simulation {

struct PictureLabels {
  std::string title;               // the program
  std::vector<std::string> facts;  // resolution, volumes: one line each
  std::vector<Vector> marks;       // places of findings in K
};

// "" or why the file could not be written.
[[nodiscard]] std::string draw_part(const Mesh& mesh, const Blank& blank, const Grid& grid,
                                    const PictureLabels& labels, const std::filesystem::path& file);

}  // namespace stanok::simulation
