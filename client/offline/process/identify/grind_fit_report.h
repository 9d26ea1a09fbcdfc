// What `stanok process identify --grinding` tells: for people, as JSON, as a picture of what is
// left.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "jobs/cutting/grind_log.h"

namespace stanok::client {

struct GrindFitReport {
  const jobs::GrindLog& log;
  const process::GrindingFit& fit;
};

[[nodiscard]] std::string to_text(const GrindFitReport& report);
[[nodiscard]] nlohmann::ordered_json to_json(const GrindFitReport& report);
void draw_picture(const GrindFitReport& report, const std::filesystem::path& file);

}  // namespace stanok::client
