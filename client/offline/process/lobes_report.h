// What `stanok process lobes` tells: for people, as JSON, as CSV, as a picture.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "client/offline/process/lobes_study.h"

namespace stanok::client {

[[nodiscard]] std::string to_text(const LobesStudy& study);
[[nodiscard]] nlohmann::ordered_json to_json(const LobesStudy& study);
[[nodiscard]] std::string to_csv(const LobesStudy& study);

// The script for gnuplot, and the picture itself, .svg or .png; throws when it cannot be drawn.
[[nodiscard]] std::string picture_script(const LobesStudy& study,
                                         const std::filesystem::path& file);
void draw_picture(const LobesStudy& study, const std::filesystem::path& file);

}  // namespace stanok::client
