// MeasuringBench: programs that measure, run on the virtual clock of the mill with a probe.
//
// What a program finds it says with `msg ("name=" + str (value, 6));`. The machine file may be
// changed before the run: what tools really are, where the part lies.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "config/files/machine_file.h"
#include "runtime/simulation.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::runtime {

class MeasuringBench {
 public:
  static constexpr double cycle_s = 1e-3;

  explicit MeasuringBench(const std::string& machine = "mill3_probe.toml") {
    const std::filesystem::path source = stanok::testing::source_folder();
    options.file = config::read_machine_file(source / "config" / "machines" / machine);
    options.file.simulation.tools.clear();
    options.program_roots = {folder.path(), source / "programs" / "cycles"};
  }

  [[nodiscard]] channels::ToolEdge& tool(int number) {
    for (channels::ToolEdge& edge : options.file.machine.tables.tools) {
      if (edge.number == number) return edge;
    }
    throw std::invalid_argument("no such tool");
  }
  void real_radius(int number, double radius) {
    options.file.simulation.tools.push_back({.number = number, .radius = radius});
  }

  void run(const std::string& program) {
    std::ofstream(folder.path() / "measure.nc") << program;
    options.programs = {{1, "measure.nc"}};
    Listener listener(*this);
    told.clear();
    alarms.clear();
    std::vector<CycleObserver*> all{&listener};
    all.insert(all.end(), observers.begin(), observers.end());
    result = simulate(options, all, [] { return false; });
    for (const auto& alarm : result.alarms) alarms.push_back(alarm.diagnostic.code);
    for (const std::string& refusal : result.refusals) ADD_FAILURE() << refusal;
    for (const auto& fault : result.load_diagnostics) {
      ADD_FAILURE() << fault.diagnostic.place.file << ":" << fault.diagnostic.place.line << " "
                    << fault.diagnostic.message;
    }
  }
  // That it came to its end.
  void run_to_end(const std::string& program) {
    run(program);
    for (const auto& alarm : result.alarms) {
      ADD_FAILURE() << alarm.diagnostic.code << " " << alarm.diagnostic.place.file << ":"
                    << alarm.diagnostic.place.line << " " << alarm.diagnostic.message;
    }
  }

  [[nodiscard]] double found(const std::string& name) const {
    const auto value = told.find(name);
    if (value == told.end()) ADD_FAILURE() << "the program has not told " << name;
    return value == told.end() ? 0.0 : value->second;
  }

  stanok::testing::TemporaryDirectory folder;
  SimulationOptions options;
  std::vector<CycleObserver*> observers;
  std::map<std::string, double> told;
  std::vector<std::string> alarms;
  SimulationResult result;
  channels::ToolRow last_tool;   // at work in the last cycle
  double lowest_z = 1e9;         // of the axis
  channels::CycleOutput output;  // of the last cycle

 private:
  class Listener final : public CycleObserver {
   public:
    explicit Listener(MeasuringBench& bench) : bench_(bench) {}

    void observe(const channels::CycleOutput& output) override {
      bench_.output = output;
      bench_.last_tool = output.channels[0].tool_row;
      bench_.lowest_z = std::min(bench_.lowest_z, output.channels[0].axes[2].position);
    }
    void observe(const channels::Event& event) override {
      const std::string text(event.text.view());
      const std::size_t equals = text.find('=');
      if (equals != std::string::npos && event.code.view().empty())
        bench_.told[text.substr(0, equals)] = std::strtod(text.c_str() + equals + 1, nullptr);
    }

   private:
    MeasuringBench& bench_;
  };
};

}  // namespace stanok::runtime
