// What is told of the forces along a milling program: text, JSON, a picture over the path.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "jobs/cutting/milling_forecast.h"

namespace stanok::client {

[[nodiscard]] std::string to_text(const jobs::MillingForecast& forecast);
[[nodiscard]] nlohmann::ordered_json to_json(const jobs::MillingForecast& forecast);

// Force, feed, power and deflection along the path, and the force on the path as it lies in X and
// Y.
[[nodiscard]] std::string picture_script(const jobs::MillingForecast& forecast,
                                         const std::filesystem::path& file);
void draw_picture(const jobs::MillingForecast& forecast, const std::filesystem::path& file);

}  // namespace stanok::client
