// What the answers of ProcessDesk have in common.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "config/text/config_error.h"
#include "daemon/desk/background_work.h"
#include "daemon/desk/program_folder.h"
#include "jobs/cutting/forecast_job.h"
#include "jobs/dry_run/dry_run.h"

namespace stanok::daemon {

// Of a virtual workpiece that is cut beside the machine.
inline constexpr std::uint64_t workpiece_bytes_max = 256U << 20;

// Why nothing can be told of a cut.
[[nodiscard]] Unexpected<protocol::Failure> nothing_told(const std::string& reason);

// The first fault of a file of the program root, which the client knows as `name`.
[[nodiscard]] Unexpected<protocol::Failure> wrong_file(const config::ConfigError& error,
                                                       const std::string& name);

// True once the request is given up, or when the thread that calls it has worked for the time of a
// foresight since it was made.
[[nodiscard]] jobs::GivesUp gives_up_when(const std::stop_token& stop);

// What ProcessDesk has done in the background: figures of a cut from a log, forces along a program
// (its text is read then).
[[nodiscard]] BackgroundWork::Work figures_from(const std::filesystem::path& log, int channel,
                                                const ProgramFolder& folder,
                                                const nlohmann::json& parameters);
[[nodiscard]] BackgroundWork::Work forces_along(jobs::ForecastJob job, const ProgramFolder& folder,
                                                const nlohmann::json& parameters);

}  // namespace stanok::daemon
