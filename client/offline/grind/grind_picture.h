// Picture of a grinding cycle, drawn by gnuplot: removal under its boundary, and the infeed in
// time.
#pragma once

#include <filesystem>
#include <string>

#include "process/grinding/cycle_design.h"

namespace stanok::client {

// A law, what it does, and, where there is one, the continuous law beside it.
struct GrindPicture {
  const process::DesignRequest& request;
  const process::InfeedLaw& law;
  const process::PlungeRun& run;
  const process::OptimalLaw* optimum = nullptr;
};

// The upper part is the paper's plane of removal and allowance: boundary, law and trajectory; the
// middle one the travel of the wheel head and its feed over time; the lower one Q/D.
[[nodiscard]] std::string picture_script(const GrindPicture& picture,
                                         const std::filesystem::path& file);

// Writes the picture; its name ends in .svg or .png. Throws std::runtime_error with the reason.
void draw_picture(const GrindPicture& picture, const std::filesystem::path& file);

}  // namespace stanok::client
