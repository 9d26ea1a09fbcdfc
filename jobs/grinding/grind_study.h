// Parameter study of grinding cycles: one design for each combination of varied numbers of the
// sheet, on all processors.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "process/grinding/cycle_design.h"

namespace stanok::jobs {

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

// One of `of` parts of a study, about equally long, from 1. All of them in their order are the
// study.
struct StudyPart {
  std::size_t number = 1;
  std::size_t of = 1;

  // The first combination of this part of so many; that of part `of` + 1 is the end.
  [[nodiscard]] std::size_t begin(std::size_t combinations) const {
    return combinations * (number - 1) / of;
  }
  [[nodiscard]] std::size_t end(std::size_t combinations) const {
    return combinations * number / of;
  }
};
// "3/10"; nothing: it is none.
[[nodiscard]] std::optional<StudyPart> read_study_part(const std::string& text);

// All combinations of the part, the last variation fastest, in this order whatever the number of
// threads.
// `show` is called now and then with the number of those that are done; what it throws ends the
// study.
[[nodiscard]] std::vector<StudyPoint> run_study(const process::DesignRequest& request,
                                                const std::vector<Variation>& variations,
                                                const StudyPart& part,
                                                const std::function<void(std::size_t)>& show);

// The headings stand above the first part only.
[[nodiscard]] std::string study_csv(const std::vector<Variation>& variations, const StudyPart& part,
                                    const std::vector<StudyPoint>& points);

}  // namespace stanok::jobs
