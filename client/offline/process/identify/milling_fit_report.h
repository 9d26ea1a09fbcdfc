// What `stanok process identify --cut` tells: for people, as JSON, as the file of tool and material
// with the figures that were found, as a picture of what is left.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "jobs/cutting/milling_log.h"

namespace stanok::client {

struct MillingFitReport {
  const jobs::MillingLog& log;
  const process::MillingFit& fit;
  // Of the drive, known from elsewhere: K_t is that times K_t / eta.
  double efficiency = 1.0;
};

[[nodiscard]] std::string to_text(const MillingFitReport& report);
[[nodiscard]] nlohmann::ordered_json to_json(const MillingFitReport& report);
// The text of a file of tool and material (config/files/chatter_file.h) with force and edge_force
// replaced, each with its interval; all else stays.
[[nodiscard]] std::string with_figures(const std::string& cut_file, const MillingFitReport& report);
void draw_picture(const MillingFitReport& report, const std::filesystem::path& file);

}  // namespace stanok::client
