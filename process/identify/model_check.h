// Whether what a fit leaves of the readings is noise, or the trace of something that its model does
// not have.
//
// Each thing that may be missing (a step of the force at a place, a growth over the record, a force
// of the edge, a second lag) is a further column beside the slopes of the fit. What of it the
// slopes do not explain takes some of the sum of squares of the residuals with it; of noise alone
// that is chi squared with one degree of freedom (C. R. Rao's score test, Proc. Camb. Phil. Soc. 44
// (1948) 50). The column that takes most is what is missing. Off line.
#pragma once

#include <cstdint>
#include <vector>

#include "process/identify/fit_verdict.h"
#include "process/identify/least_squares.h"

namespace stanok::process {

// By reading and whitened (process/identify/coloured_noise.h).
struct FitTraces {
  std::vector<double> rest;
  std::vector<std::vector<double>> slopes{};  // of the rest, by parameter
  double variance = 1.0;                      // of the rest, from reading to reading
};

// What a model may lack.
struct Suspect {
  Misfit kind = Misfit::none;
  std::vector<double> column;  // whitened; the change of the power for an amount of 1
};

enum class Along : std::uint8_t { time, place };  // s from the begin of the record; z, mm

// The power of the cut in one stretch of the record; stretches side by side make a step.
struct Stretches {
  std::vector<std::vector<double>> columns;  // whitened, one for each
  std::vector<double> begins;
  double end = 0.0;
  Along along = Along::time;
};

struct ModelLack {
  Misfit kind = Misfit::none;
  double gain = 0.0;    // of the sum of squares, over the variance
  double amount = 0.0;  // of the column: for a step and a drift, of the force
  double rest = 0.0;    // what it has left in the readings: root of its part of the squares
  Parameters moved{};   // by how much it has moved the parameters
  double from = 0.0;    // steps: the stretch
  double to = 0.0;
  Along along = Along::time;
};

// The one that takes most, or none where all could be of noise. `stretches`: those by place before
// those by time.
[[nodiscard]] ModelLack strongest_lack(const FitTraces& traces,
                                       const std::vector<Suspect>& suspects,
                                       const std::vector<Stretches>& stretches);

}  // namespace stanok::process
