#include "jobs/columns/number_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <iterator>

namespace stanok::jobs {

double farther_from_zero(double a, double b) {
  if (std::isnan(a)) return b;
  return std::abs(b) > std::abs(a) ? b : a;
}

void append_line(std::string& text, std::span<const double> values, std::span<const int> decimals) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "{}{:.{}f}", k == 0 ? "" : ",", values[k],
                   decimals[k]);
  }
  text += '\n';
}

}  // namespace stanok::jobs
