// The job of a forecast from what the command line says of it.
#pragma once

#include <string>

#include "client/offline/machine/job_options.h"
#include "jobs/cutting/forecast_job.h"

namespace stanok::client {

[[nodiscard]] std::string text_of_file(const std::string& path);

// Prints what is wrong with the program, and gives up when the command is interrupted.
[[nodiscard]] jobs::ForecastJob forecast_job(const std::string& program, const JobOptions& options);

}  // namespace stanok::client
