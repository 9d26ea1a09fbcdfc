// What was found out about a program as bytes, to pass between processes and to lie in the cache.
#pragma once

#include <string>
#include <vector>

#include "client/offline/check/check_report.h"
#include "client/offline/machine/job_options.h"

namespace stanok::client {

[[nodiscard]] std::string check_record(const CheckedProgram& program);
// Throws nlohmann::json::exception where it is none.
[[nodiscard]] CheckedProgram checked_program(const std::string& record);

// What the result of a check depends on among the options of the command.
[[nodiscard]] std::vector<std::string> asked_of(const JobOptions& job);

}  // namespace stanok::client
