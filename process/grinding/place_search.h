// Search for the places of least time around given ones.
#pragma once

#include <functional>
#include <vector>

namespace stanok::process {

// Places, falling from below `begin_mm` on, each moved as long as `time_s` of all of them falls, in
// steps that become finer; as the control file writes them, with `decimals`. What time_s refuses is
// infinite. Ends after a number of evaluations that grows with the number of places.
[[nodiscard]] std::vector<double> search_places(
    std::vector<double> places_mm, double begin_mm, int decimals,
    const std::function<double(const std::vector<double>&)>& time_s);

}  // namespace stanok::process
