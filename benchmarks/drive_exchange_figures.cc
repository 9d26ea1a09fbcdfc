// Cyclic exchange with simulated drives over Modbus TCP on loopback: how long an exchange takes and
// how regularly the answers of each drive come.
//
//   drive_exchange_figures [SECONDS] [DRIVES] [POLL_MS]      default: 60 10 10
//
// The bus thread and the server are those of the runtime; a reader looks every millisecond which
// drives have answered anew. Prints one JSON object; ends with 1 when an answer came more than
// 100 ms after the one before, or an exchange failed.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "base/units.h"
#include "drives/modbus/modbus_bus.h"
#include "plant/modbus/modbus_server.h"

namespace stanok {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double late_ms = 100.0;

drives::BusConfig bus_of(int count, int poll_ms) {
  drives::BusConfig bus{.kind = drives::BusKind::modbus_tcp, .poll_ms = poll_ms};
  for (int unit = 1; unit <= count; ++unit)
    bus.axes.push_back({.axis = "A" + std::to_string(unit), .unit = unit});
  return bus;
}

// Times between the answers of one drive after the other.
class Intervals {
 public:
  explicit Intervals(std::size_t drives) : sequences_(drives), answered_(drives) {}

  void look(const std::vector<drives::DriveFeedback>& feedback) {
    const Clock::time_point now = Clock::now();
    for (std::size_t k = 0; k < feedback.size(); ++k) {
      if (feedback[k].sequence == sequences_[k]) continue;
      if (sequences_[k] > 0)
        times_ms_.push_back(std::chrono::duration<double, std::milli>(now - answered_[k]).count());
      sequences_[k] = feedback[k].sequence;
      answered_[k] = now;
    }
  }

  // All of them, ascending.
  [[nodiscard]] std::vector<double> sorted_ms() {
    std::ranges::sort(times_ms_);
    return times_ms_;
  }

 private:
  std::vector<std::uint32_t> sequences_;
  std::vector<Clock::time_point> answered_;
  std::vector<double> times_ms_;
};

double percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

int measure(double seconds, int count, int poll_ms) {
  const drives::BusConfig config = bus_of(count, poll_ms);
  plant::ModbusServer server({}, plant::drives_of(config, {}));
  server.start();
  drives::BusConfig bus_config = config;
  bus_config.port = server.port();
  drives::ModbusBus bus(bus_config, 1.0 * millisecond);
  const auto drives = static_cast<std::size_t>(count);
  std::vector<drives::DriveTarget> targets(drives, {.enabled = true, .brake_closed = false});
  std::vector<drives::DriveFeedback> feedback(drives);
  Intervals intervals(drives);
  bus.start();
  Clock::time_point next = Clock::now();
  const Clock::time_point end =
      next + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (next < end) {
    bus.write(targets);
    bus.read(feedback);
    intervals.look(feedback);
    next += std::chrono::milliseconds{1};
    std::this_thread::sleep_until(next);
  }
  const drives::BusStatus status = bus.status();
  bus.stop();

  std::uint64_t errors = 0;
  for (const std::uint64_t kind : status.errors) errors += kind;
  const std::vector<double> sorted = intervals.sorted_ms();
  const auto late = std::ranges::count_if(sorted, [](double time) { return time > late_ms; });
  fmt::print(
      "{{\"drives\":{},\"poll_ms\":{},\"seconds\":{},\"exchanges\":{},\"errors\":{},"
      "\"round_trip_us\":{{\"p50\":{:.1f},\"p90\":{:.1f},\"p99\":{:.1f},\"p999\":{:.1f},"
      "\"max\":{:.1f}}},\"interval_ms\":{{\"p50\":{:.2f},\"p99\":{:.2f},\"p999\":{:.2f},"
      "\"max\":{:.2f}}},\"later_than_100_ms\":{}}}\n",
      count, poll_ms, seconds, status.exchanges, errors, status.round_trip.p50_us,
      status.round_trip.p90_us, status.round_trip.p99_us, status.round_trip.p999_us,
      status.round_trip.max_us, percentile(sorted, 0.5), percentile(sorted, 0.99),
      percentile(sorted, 0.999), percentile(sorted, 1.0), late);
  return late == 0 && errors == 0 && !sorted.empty() ? 0 : 1;
}

}  // namespace
}  // namespace stanok

int main(int argc, char** argv) {
  const auto number = [&](int place, const char* initial) {
    return std::strtod(argc > place ? argv[place] : initial, nullptr);
  };
  const double seconds = number(1, "60");
  const int drives = static_cast<int>(number(2, "10"));
  const int poll_ms = static_cast<int>(number(3, "10"));
  if (seconds <= 0.0 || drives < 1 || drives > 200 || poll_ms < 1) {
    fmt::print(stderr, "usage: drive_exchange_figures [SECONDS] [DRIVES] [POLL_MS]\n");
    return 2;
  }
  return stanok::measure(seconds, drives, poll_ms);
}
