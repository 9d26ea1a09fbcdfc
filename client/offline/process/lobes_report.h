// What `stanok process lobes` tells: for people, as CSV, as a picture.
#pragma once

#include <filesystem>
#include <string>

#include "process/chatter/lobes_study.h"

namespace stanok::client {

[[nodiscard]] std::string to_text(const process::LobesStudy& study);
[[nodiscard]] std::string to_csv(const process::LobesStudy& study);

// The script for gnuplot, and the picture itself, .svg or .png; throws when it cannot be drawn.
[[nodiscard]] std::string picture_script(const process::LobesStudy& study,
                                         const std::filesystem::path& file);
void draw_picture(const process::LobesStudy& study, const std::filesystem::path& file);

}  // namespace stanok::client
