// Parameter study of grinding cycles: one design for each combination of varied numbers of the
// sheet, on all processors.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "process/grinding/cycle_design.h"

namespace stanok::client {

// A number of the sheet, or the allowance, and the values that it takes one after the other.
struct Variation {
  std::string key;
  std::vector<double> values;
};

// KEY=FROM:TO:COUNT (equal steps) or KEY=A,B,C (these, in this order). Nothing when the text has
// another form or names no number of the sheet.
[[nodiscard]] std::optional<Variation> read_variation(const std::string& text);

struct StudyPoint {
  std::vector<double> values;                    // of the variations
  std::optional<process::CycleDesign> design{};  // without samples
  std::string finding{};                         // code and text of the first error
};

constexpr int study_points_max = 1'000'000;

// The number of combinations; above study_points_max they are not to be run.
[[nodiscard]] double study_size(const std::vector<Variation>& variations);

// All combinations, the last variation fastest, in this order whatever the number of threads.
// `show` is called now and then with the number of those that are done; what it throws ends the
// study.
[[nodiscard]] std::vector<StudyPoint> run_study(const process::DesignRequest& request,
                                                const std::vector<Variation>& variations,
                                                const std::function<void(std::size_t)>& show);

[[nodiscard]] std::string study_csv(const std::vector<Variation>& variations,
                                    const std::vector<StudyPoint>& points);

}  // namespace stanok::client
