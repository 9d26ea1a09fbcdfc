// What `stanok process identify --grinding` tells: for people, as JSON, as the process file with
// the figures that were found, as a picture of what is left.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "client/offline/process/identify/grind_log.h"

namespace stanok::client {

struct GrindFitReport {
  const GrindLog& log;
  const process::GrindingFit& fit;
};

[[nodiscard]] std::string to_text(const GrindFitReport& report);
[[nodiscard]] nlohmann::ordered_json to_json(const GrindFitReport& report);
// The text of a process file with stiffness, force_factor and force_exponent replaced, each with
// its interval; all else stays.
[[nodiscard]] std::string with_figures(const std::string& process_file,
                                       const process::GrindingFit& fit);
void draw_picture(const GrindFitReport& report, const std::filesystem::path& file);

}  // namespace stanok::client
