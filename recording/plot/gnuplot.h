// Runs gnuplot, and writes what it reads: quoted texts, numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/log/log_writer.h"

namespace stanok::recording {

// Runs the script in its own directory, without a shell. Nothing is returned but the reason of a
// failure; a missing gnuplot is named with the package that has it.
[[nodiscard]] std::optional<LogError> run_gnuplot(const std::filesystem::path& script);

// The same for a script as a text.
[[nodiscard]] std::optional<LogError> draw(const std::string& script);

// A text as gnuplot's single-quoted string; control characters become blanks.
[[nodiscard]] std::string gnuplot_text(std::string_view text);
// Nine significant digits, the same in every locale.
[[nodiscard]] std::string number(double value);

// "$name << END ... END", from which a script plots: a line for each row.
[[nodiscard]] std::string data_block(const std::string& name,
                                     const std::vector<std::vector<double>>& rows);

}  // namespace stanok::recording
