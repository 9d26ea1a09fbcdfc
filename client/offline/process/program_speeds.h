// The speeds at which a part program cuts.
#pragma once

#include <string>
#include <vector>

#include "client/offline/machine/job_options.h"

namespace stanok::client {

// Speeds of the master spindle in the moves at feed of the program, rev/min, rising, each once.
// Under G96 the speed follows the diameter: it is not among them. What is wrong with the program is
// printed; throws std::runtime_error then.
[[nodiscard]] std::vector<double> speeds_of_program(const std::string& program,
                                                    const JobOptions& job);

}  // namespace stanok::client
