// The picture of an identification: power as recorded and as the model has it, and what is left.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "jobs/cutting/power_points.h"

namespace stanok::client {

[[nodiscard]] std::string power_picture_script(const std::vector<jobs::PowerPoint>& points,
                                               const std::filesystem::path& file);
// Throws std::runtime_error where it cannot be drawn.
void draw_power_picture(const std::vector<jobs::PowerPoint>& points,
                        const std::filesystem::path& file);

}  // namespace stanok::client
