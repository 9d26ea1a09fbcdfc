// stanok-drives: the simulated drives and spindles of a machine as a Modbus server.
//
// Reads the machine file, serves until SIGINT or SIGTERM. Prints where it serves and which unit is
// which; registers and faults are described in docs/drives.md.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "config/machine_file.h"
#include "plant/machine_drives.h"
#include "plant/modbus_server.h"

namespace stanok::plant {
namespace {

enum ExitCode { exit_ok = 0, exit_failed = 1, exit_usage = 2 };

struct Options {
  std::string machine;
  ServerConfig server;
  bool json = false;
  std::vector<std::string> faults;  // AXIS=KIND
};

struct Injection {
  std::size_t drive;
  FaultKind kind;
};

void define(CLI::App& app, Options& options) {
  app.add_option("--machine", options.machine, "machine file")->required()->type_name("FILE");
  app.add_option("--host", options.server.host, "address to listen on")->capture_default_str();
  auto* port = app.add_option("--port", options.server.port, "TCP port; 0: any free one")
                   ->check(CLI::Range(0, 65535))
                   ->capture_default_str();
  app.add_option("--rtu", options.server.rtu_device, "serve Modbus RTU on this serial line instead")
      ->type_name("DEVICE")
      ->excludes(port);
  app.add_option("--baud", options.server.baud, "bits per second of the serial line")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--rate", options.server.rate_hz, "the drives move in steps of at most 1/HZ")
      ->check(CLI::Range(1.0, 1e5))
      ->type_name("HZ")
      ->capture_default_str();
  app.add_flag("--json", options.json, "print the units as JSON");
  app.add_option("--fault", options.faults,
                 "begin with a fault: off, stuck, garbage, slow, intermittent, trip, elsewhere, "
                 "mangled or hang_up")
      ->type_name("AXIS=KIND");
}

// No value when the axis or the fault is unknown.
std::optional<Injection> injection(const std::string& text,
                                   const std::vector<SimulatedDriveConfig>& drives) {
  const std::size_t sign = text.find('=');
  const std::string axis = text.substr(0, sign);
  const auto kind = sign == std::string::npos ? std::nullopt : fault_named(text.substr(sign + 1));
  const auto drive = std::find_if(drives.begin(), drives.end(), [&](const auto& candidate) {
    return candidate.registers.axis == axis;
  });
  if (!kind || drive == drives.end()) {
    return std::nullopt;
  }
  return Injection{static_cast<std::size_t>(drive - drives.begin()), *kind};
}

nlohmann::ordered_json description(const ServerConfig& server, int port,
                                   const std::vector<SimulatedDriveConfig>& drives) {
  nlohmann::ordered_json json;
  if (server.rtu_device.empty()) {
    json["host"] = server.host;
    json["port"] = port;
  } else {
    json["device"] = server.rtu_device;
  }
  json["fault_panel_unit"] = fault_panel_unit;
  json["units"] = nlohmann::ordered_json::array();
  for (const SimulatedDriveConfig& drive : drives) {
    const drives::AxisDriveConfig& registers = drive.registers;
    json["units"].push_back({{"unit", registers.unit},
                             {"axis", registers.axis},
                             {"kind", drive.kind == PlantKind::spindle ? "spindle" : "axis"},
                             {"control_register", registers.map.control_word.address},
                             {"status_register", registers.map.status_word.address},
                             {"position_scale", registers.map.position.scale},
                             {"velocity_scale", registers.map.velocity.scale}});
  }
  return json;
}

void print_description(const nlohmann::ordered_json& json) {
  if (json.contains("port")) {
    std::cout << "port " << json["port"] << " on " << json["host"].get<std::string>() << '\n';
  } else {
    std::cout << "line " << json["device"].get<std::string>() << '\n';
  }
  for (const auto& unit : json["units"]) {
    std::cout << "unit " << unit["unit"] << "  " << unit["axis"].get<std::string>() << '\n';
  }
  std::cout << "unit " << json["fault_panel_unit"] << "  fault panel\n" << std::flush;
}

// Blocked before any thread starts, so that only wait_for_end receives them.
sigset_t block_end_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

void wait_for_end(const sigset_t& signals) {
  int received = 0;
  sigwait(&signals, &received);
}

int serve(const Options& options) {
  const auto drives = drives_of(config::read_machine_file(options.machine));
  std::vector<Injection> injections;
  for (const std::string& text : options.faults) {
    const auto found = injection(text, drives);
    if (!found) {
      std::cerr << "stanok-drives: --fault " << text << ": no such axis or fault; see --help\n";
      return exit_usage;
    }
    injections.push_back(*found);
  }
  const sigset_t end_signals = block_end_signals();
  ModbusServer server(options.server, drives);
  for (const Injection& fault : injections) {
    server.inject(fault.drive, fault.kind);
  }
  server.start();
  const auto json = description(options.server, server.port(), drives);
  if (options.json) {
    std::cout << json << '\n' << std::flush;
  } else {
    print_description(json);
  }
  wait_for_end(end_signals);
  server.stop();
  return exit_ok;
}

int run(int argc, char** argv) {
  CLI::App app("Simulated drives and spindles of a machine: a Modbus TCP or RTU server.",
               "stanok-drives");
  Options options;
  define(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  return serve(options);
}

}  // namespace
}  // namespace stanok::plant

int main(int argc, char** argv) {
  try {
    return stanok::plant::run(argc, argv);
  } catch (const std::exception& error) {  // ConfigError, ServerError
    std::fprintf(stderr, "%s\n", error.what());
    return stanok::plant::exit_failed;
  }
}
