// Rows of numbers, and their text.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace stanok::jobs {

using NumberRows = std::vector<std::vector<double>>;

// What is not a number is the nearest to 0.
[[nodiscard]] double farther_from_zero(double a, double b);

// One line of a table, values separated by commas.
void append_line(std::string& text, std::span<const double> values, std::span<const int> decimals);

}  // namespace stanok::jobs
