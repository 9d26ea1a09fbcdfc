// A TOML text in which figures are replaced, each with its interval behind it; all else stays.
#pragma once

#include <string>
#include <vector>

#include "process/identify/drive_fit.h"

namespace stanok::jobs {

struct KeyedFigure {
  std::string key;
  process::Estimate estimate;
  int digits = 0;
};

// Keys of the main table, which ends where the first [section] begins. A key that the text does not
// have is put in front of that.
[[nodiscard]] std::string with_figures(const std::string& toml,
                                       const std::vector<KeyedFigure>& figures);

}  // namespace stanok::jobs
