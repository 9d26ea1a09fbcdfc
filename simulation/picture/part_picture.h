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

// One view from the front, right and above, that the part fills, as the bytes of a PNG file; what
// is no part is transparent. Empty: there is no memory for it.
[[nodiscard]] std::string view_of_part(const Mesh& mesh, const Blank& blank, const Grid& grid,
                                       int width, int height);

}  // namespace stanok::simulation
