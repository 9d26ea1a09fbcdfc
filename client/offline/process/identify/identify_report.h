// What `stanok process identify` tells: for people, as JSON, as a section of a machine file, as a
// picture of what is left.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "jobs/cutting/cut_log.h"

namespace stanok::client {

struct IdentifyReport {
  const jobs::CutLog& log;
  const process::TurningFit& fit;
  // Known from elsewhere: C of the material, N; 0: it is not known, and neither is the efficiency.
  double coefficient_n = 0.0;
};

[[nodiscard]] std::string to_text(const IdentifyReport& report);
[[nodiscard]] nlohmann::ordered_json to_json(const IdentifyReport& report);
// [process] of a machine file, as far as the log tells it, each value with its interval.
[[nodiscard]] std::string process_section(const IdentifyReport& report);

void draw_picture(const IdentifyReport& report, const std::filesystem::path& file);

}  // namespace stanok::client
