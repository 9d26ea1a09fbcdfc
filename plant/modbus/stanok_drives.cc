// stanok-drives: the simulated drives and spindles of a machine as a Modbus server.
//
// Reads the machine file, serves until SIGINT or SIGTERM. Prints where it serves and which unit is
// which; takes faults and loads from standard input. Registers and faults:
// docs/integrator/drives.md.
#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/place.h"
#include "base/utf8.h"
#include "config/files/machine_file.h"
#include "plant/modbus/drive_console.h"
#include "plant/modbus/machine_drives.h"
#include "plant/modbus/modbus_server.h"

namespace stanok::plant {
namespace {

enum ExitCode { exit_ok = 0, exit_failed = 1, exit_usage = 2 };

struct Options {
  std::string machine;
  ServerConfig server;
  bool json = false;
  std::vector<std::string> faults;  // AXIS=KIND
};

void define(CLI::App& app, Options& options) {
  app.add_option("--machine", options.machine, "machine file")->required()->type_name("FILE");
  app.add_option("--host", options.server.host, "address to listen on")->capture_default_str();
  auto* port = app.add_option("--port", options.server.port, "TCP port; 0: any free port")
                   ->check(CLI::Range(0, 65535))
                   ->capture_default_str();
  app.add_option("--rtu", options.server.rtu_device, "serve Modbus RTU on this serial line instead")
      ->type_name("DEVICE")
      ->excludes(port);
  app.add_option("--baud", options.server.baud, "bits per second of the serial line")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--rate", options.server.rate_hz,
                 "rate of the simulation: the drives move in steps of at most 1/HZ")
      ->check(CLI::Range(1.0, 1e5))
      ->type_name("HZ")
      ->capture_default_str();
  app.add_flag("--json", options.json, "print the units as JSON");
  app.add_option("--fault", options.faults,
                 "start with a fault: off, stuck, garbage, slow, intermittent, trip, elsewhere, "
                 "mangled, hang_up, jammed or frozen")
      ->type_name("AXIS=KIND");
}

// "AXIS=KIND"; no value when either is unknown.
std::optional<Injection> injection_of(const std::string& text,
                                      const std::vector<SimulatedDriveConfig>& drives) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) return std::nullopt;
  return injection(text.substr(0, sign), text.substr(sign + 1), drives);
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

// Blocked before any thread starts, so that only serve_until_signal receives them.
sigset_t block_end_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

// Carries out the lines of standard input until a signal comes; the end of the input is no end.
void serve_until_signal(const sigset_t& signals, const std::vector<SimulatedDriveConfig>& drives,
                        ModbusServer& server) {
  const int signal = signalfd(-1, &signals, SFD_CLOEXEC);
  std::string text;
  std::array<pollfd, 2> polled = {{{signal, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
  while (poll(polled.data(), polled.size(), -1) < 0 || polled[0].revents == 0) {
    if (polled[1].revents == 0) continue;
    std::array<char, 4096> bytes{};
    const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count <= 0) polled[1].fd = -1;
    text.append(bytes.data(), checked_size(std::max<ssize_t>(count, 0)));
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
      const std::string wrong = carry_out(text.substr(0, end), drives, server);
      if (!wrong.empty()) std::cerr << "stanok-drives: " << wrong << '\n';
      text.erase(0, end + 1);
    }
    if (text.size() > 65536) text.clear();
  }
  close(signal);
}

int serve(const Options& options) {
  const config::MachineFile machine = config::read_machine_file(options.machine);
  const auto drives = drives_of(machine);
  std::vector<Injection> injections;
  for (const std::string& text : options.faults) {
    const auto found = injection_of(text, drives);
    if (!found) {
      std::cerr << "stanok-drives: --fault " << text
                << ": there is no such axis or fault; see --help\n";
      return exit_usage;
    }
    injections.push_back(*found);
  }
  const sigset_t end_signals = block_end_signals();
  ServerConfig config = options.server;
  config.modules = modules_of(machine);
  ModbusServer server(config, drives);
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
  serve_until_signal(end_signals, drives, server);
  server.stop();
  return exit_ok;
}

int run(int argc, char** argv) {
  CLI::App app("Simulated drives and spindles of a machine: a Modbus TCP or RTU server.",
               "stanok-drives");
  app.footer(
      "Commands on standard input while the drives are served:\n"
      "  fault AXIS KIND                 make a drive fail; KIND none: it works again\n"
      "  load AXIS POWER_W [UM HZ]       power and vibration of the cutting process\n"
      "Axes are named as in the machine file, spindles S1, S2. Any Modbus client can read and "
      "write\n"
      "the registers; unit 247 is the fault panel.");
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
    std::fprintf(stderr, "%s\n", stanok::valid_utf8(error.what()).c_str());
    return stanok::plant::exit_failed;
  }
}
