// The drive bus as the runtime sees it: targets out, feedback in, without ever waiting.
//
// A bus owns its thread and its connection. The cycle calls `read` and `write`, which only move
// plain data through latest-value boxes; how old a value is stands in its feedback. Operators ask
// `status`. `start` and `stop` belong to one thread, `read` and `write` to the real-time cycle,
// `status` to anybody.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_array.h"
#include "base/fixed_text.h"
#include "base/rt_safe.h"
#include "drives/drive.h"
#include "drives/signals.h"
#include "drives/vibration_meter.h"

namespace stanok::drives {

// Why an exchange gave no value.
enum class ExchangeError : std::uint8_t {
  not_connected,  // there is no connection, or it could not be made
  timeout,        // no answer in time
  disconnected,   // the other side closed the connection
  mangled,        // wrong checksum, transaction id, length or sender
  exception,      // the drive answered with a Modbus exception
  stuck,          // the answer does not echo the request: it is not from now
  implausible,    // no state of the standard, or a position or velocity the axis cannot have
  own_fault,      // a fault of stanok itself ended the round of exchanges
};

[[nodiscard]] std::string_view name_of(ExchangeError error);

// Time from request to answer, in microseconds; 0 before the first answer.
struct RoundTrip {
  double p50_us = 0.0;
  double p90_us = 0.0;
  double p99_us = 0.0;
  double p999_us = 0.0;
  double max_us = 0.0;
};

using ErrorCounts = EnumArray<ExchangeError, std::uint64_t>;

struct AxisBusStatus {
  std::string axis;  // "X"; "S1" of a spindle
  bool in_contact = false;
  std::uint64_t answers = 0;
  std::uint64_t errors = 0;
  ErrorCounts errors_by_kind{};
  DriveFeedback feedback{};  // the last that was believed
};

struct VibrationStatus {
  std::string sensor;  // "S1"
  VibrationLevel level{};
  std::uint64_t samples = 0;
  std::uint64_t lost = 0;
  std::uint64_t errors = 0;
};

struct BusStatus {
  std::string endpoint{};  // "127.0.0.1:502", "/dev/ttyUSB0", "simulated"
  bool connected = false;
  std::uint64_t connections = 0;  // made since the start
  std::uint64_t exchanges = 0;    // good and bad
  ErrorCounts errors{};
  FixedText<200> own_fault{};  // what the latest one says
  RoundTrip round_trip{};
  std::vector<AxisBusStatus> axes{};
  std::vector<VibrationStatus> vibration{};
  std::uint64_t signal_requests = 0;  // good and bad; counted in exchanges and errors, too
};

class DriveBus {
 public:
  DriveBus() = default;
  virtual ~DriveBus() = default;
  DriveBus(const DriveBus&) = delete;
  DriveBus& operator=(const DriveBus&) = delete;

  // Returns at once; a drive that is absent shows in the feedback and in the status.
  virtual void start() = 0;

  // Asks all drives for a quick stop, then ends the connection.
  virtual void stop() = 0;

  // One target and one feedback per drive: the axes in machine order, then the spindles.
  virtual void write(std::span<const DriveTarget> targets) RT_SAFE = 0;
  virtual void read(std::span<DriveFeedback> feedback) RT_SAFE = 0;

  // Signals of programs; inputs without an answer keep their last values. A bus without signals
  // takes outputs nowhere.
  virtual void write_signals(const Signals& outputs) RT_SAFE { static_cast<void>(outputs); }
  [[nodiscard]] virtual Signals read_signals() RT_SAFE { return {}; }

  // The new samples of a vibration sensor in um, as many as there is room for, the oldest first;
  // their number. Those that nobody takes are given up.
  [[nodiscard]] virtual std::size_t read_vibration(std::size_t sensor, std::span<double> samples_um)
      RT_SAFE {
    static_cast<void>(sensor);
    static_cast<void>(samples_um);
    return 0;
  }

  // What the meter of a vibration sensor makes of its samples, not a number while none arrive;
  // none: this bus has no such sensor.
  [[nodiscard]] virtual std::optional<VibrationLevel> read_vibration_level(std::size_t sensor)
      RT_SAFE {
    static_cast<void>(sensor);
    return std::nullopt;
  }

  [[nodiscard]] virtual BusStatus status() const = 0;
};

}  // namespace stanok::drives
