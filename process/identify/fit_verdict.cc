#include "process/identify/fit_verdict.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace stanok::process {
namespace {

struct MisfitRow {
  std::string_view name;
  std::string_view remedy;
};

constexpr std::array<MisfitRow, 10> misfit_rows{{
    {"none", ""},
    {"dead_sensor", "check the power sensor and its cable; record the cut again"},
    {"saturated", "set the range of the sensor to the highest power, or take lighter cuts"},
    {"coarse", "set a finer resolution of the power in the drive, or take heavier cuts"},
    {"steps",
     "give the stock as it was before the cut, with its hardness by place, or record a cut in one "
     "material"},
    {"drift", "record a short cut with a fresh tool, after spindle and sensor have warmed up"},
    {"force_law", "record with feeds near those that you use, or with a sharp edge"},
    {"lag", "check whether the drive filters the power; the lag is that of all filters together"},
    {"bounds", "check that spindle, tool and stock are those of the cut"},
    {"open", "record a longer cut with feeds and depths that differ by half and more"},
}};

}  // namespace

std::string_view name_of(Misfit kind) {
  return misfit_rows[static_cast<std::size_t>(kind)].name;
}

FitVerdict verdict(FitState state, Misfit kind, const std::string& because) {
  return {.state = state,
          .kind = kind,
          .reason = "the model does not fit because " + because,
          .remedy = std::string(misfit_rows[static_cast<std::size_t>(kind)].remedy)};
}

void add_verdict(const FitVerdict& further, FitVerdict& to) {
  if (to.state == FitState::fits)
    to = further;
  else
    to.state = std::max(to.state, further.state);
}

}  // namespace stanok::process
