// A bus and a server of simulated drives that talk over loopback, and waiting for conditions.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

#include "drives/modbus/modbus_bus.h"
#include "plant/modbus/modbus_server.h"

namespace stanok::plant {

// Repeats until the condition holds; false after four minutes, since a computer may be loaded.
inline bool eventually(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{4};
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return true;
}

// `count` axes at units 1, 2, ...
inline drives::BusConfig bus_of(int count) {
  drives::BusConfig bus{.kind = drives::BusKind::modbus_tcp, .poll_ms = 2};
  for (int i = 0; i < count; ++i) {
    bus.axes.push_back({.axis = "A" + std::to_string(i + 1), .unit = i + 1, .velocity_max = 400.0});
  }
  return bus;
}

// The cycle's side of a bus.
class CycleSide {
 public:
  CycleSide(drives::BusConfig config, int port) : bus(with_port(std::move(config), port), cycle) {
    bus.start();
  }
  template <class Link>
  CycleSide(const drives::BusConfig& config, int port, std::type_identity<Link> /*kind*/)
      : bus(with_port(config, port), cycle, std::make_unique<Link>(with_port(config, port))) {
    bus.start();
  }

  // One cycle.
  void run() {
    bus.write(targets);
    bus.read(feedback);
  }

  bool until(const std::function<bool()>& condition) {
    return eventually([&] {
      run();
      return condition();
    });
  }

  bool all_valid() const {
    return std::all_of(feedback.begin(), feedback.end(), [](const auto& f) { return f.valid; });
  }

  // Targets where the axes are, power on.
  bool switch_on() {
    if (!until([&] { return all_valid(); })) {
      return false;
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
      targets[i] = {.position = feedback[i].position, .enabled = true, .brake_closed = false};
    }
    return until([&] {
      return std::all_of(feedback.begin(), feedback.end(), [](const auto& f) {
        return f.state == drives::DriveState::operation_enabled;
      });
    });
  }

  std::uint64_t errors(drives::ExchangeError kind) const { return bus.status().errors[kind]; }

  static constexpr Duration cycle = 1.0 * millisecond;
  drives::ModbusBus bus;
  std::vector<drives::DriveTarget> targets = std::vector<drives::DriveTarget>(axes());
  std::vector<drives::DriveFeedback> feedback = std::vector<drives::DriveFeedback>(axes());

 private:
  static drives::BusConfig with_port(drives::BusConfig config, int port) {
    config.port = port;
    return config;
  }
  std::size_t axes() const { return bus.status().axes.size(); }
};

}  // namespace stanok::plant
