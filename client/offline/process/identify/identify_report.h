// What `stanok process identify` prints, and its picture of power and residual.
#pragma once

#include <filesystem>
#include <string>

#include "jobs/cutting/identification.h"

namespace stanok::client {

// A table of the figures with what the intervals are, and how good the fit is; without the figures
// where the model does not fit.
[[nodiscard]] std::string to_text(const jobs::Identification& found);
// Throws std::runtime_error where it cannot be drawn.
void draw_picture(const jobs::Identification& found, const std::filesystem::path& file);

}  // namespace stanok::client
