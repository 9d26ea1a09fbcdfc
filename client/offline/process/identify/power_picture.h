// The picture of an identification: power as recorded and as the model has it, and what is left.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stanok::client {

struct PowerPoint {
  double time_s = 0.0;
  double recorded_w = 0.0;
  double model_w = 0.0;
};

[[nodiscard]] std::string power_picture_script(const std::vector<PowerPoint>& points,
                                               const std::filesystem::path& file);
// Throws std::runtime_error where it cannot be drawn.
void draw_power_picture(const std::vector<PowerPoint>& points, const std::filesystem::path& file);

}  // namespace stanok::client
