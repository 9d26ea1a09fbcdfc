// ForecastJob: the program whose forces are told before it is run, and the machine that runs it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"

namespace stanok::jobs {

struct ForecastJob {
  config::MachineFile machine;
  std::vector<std::filesystem::path> program_roots;
  std::string program;  // as it is found beneath the roots
  std::string text;     // of the program
  int channel = 1;
  std::vector<std::pair<int, int>> schemes;  // channel, scheme at the start
  // Of the path; more of them are refused with std::runtime_error, since they take memory.
  std::size_t places_max = 20'000'000;
  // Is told what is wrong with the program.
  std::function<void(const Diagnostic&)> tell = [](const Diagnostic&) {};
  // Asked often; true ends the forecast with std::runtime_error.
  GivesUp gives_up = [] { return false; };

  // Active in the channel at the start; -1: that of the machine file.
  [[nodiscard]] int scheme() const {
    for (const auto& [of, scheme] : schemes)
      if (of == channel) return scheme;
    return -1;
  }
};

}  // namespace stanok::jobs
