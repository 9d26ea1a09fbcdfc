// Pictures of one channel of a log, drawn by gnuplot: the path from the top, the front and the
// side, path speed, and velocity, acceleration and jerk of every axis over time.
//
// A run in another kinematic scheme has its own colour. The number of points is bounded whatever
// the length of the log; peaks over time are kept. The script with its data stays beside the
// pictures: `gnuplot ch1.gnuplot` in that directory draws them again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/expected.h"
#include "recording/read/log_contents.h"

namespace stanok::recording {

// Writes PNG and SVG files named ch<channel>-<picture> into `directory`, which is made when absent.
// Returns the files. `contents` are those of the same file.
[[nodiscard]] Expected<std::vector<std::string>, LogError> plot_channel(
    const std::filesystem::path& file, const LogContents& contents, int channel,
    const std::filesystem::path& directory);

}  // namespace stanok::recording
