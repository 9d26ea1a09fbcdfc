// Drives on Modbus TCP or RTU: a thread exchanges targets and feedback with every drive, the
// signals of programs and the samples of vibration sensors each poll.
//
// Per drive and poll one request with function code 23 where its register map allows it, else as
// few as possible. A drive that does not answer is asked again as soon as its patience says, while
// the others are asked at their polls. After an error the connection is closed and made again at
// once; where it cannot be made, with growing pauses up to a second. Drives that are given up take
// turns, so that they do not hold up the others. What is sent and what is believed is decided
// in AxisExchange. When the cycle writes no targets for the timeout the drives are stopped.
// An exception in the bus thread is a loss of contact with every drive; the thread goes on.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#include "base/latest.h"
#include "base/ring.h"
#include "base/units.h"
#include "drives/bus.h"
#include "drives/bus_config.h"
#include "drives/bus_statistics.h"
#include "drives/modbus/axis_exchange.h"
#include "drives/modbus/exchange_plan.h"
#include "drives/modbus/modbus_link.h"
#include "drives/modbus/patience.h"
#include "drives/modbus/signal_exchange.h"

namespace stanok::drives {

class ModbusBus final : public DriveBus {
 public:
  // `cycle`: period of read and write. Feedback older than the timeout is invalid even when the bus
  // thread itself hangs; that is counted in cycles.
  ModbusBus(BusConfig config, Duration cycle);
  // Over a link of the caller's.
  ModbusBus(BusConfig config, Duration cycle, std::unique_ptr<ModbusLink> link);
  ~ModbusBus() override;

  void start() override;
  void stop() override;
  void write(std::span<const DriveTarget> targets) RT_SAFE override;
  void read(std::span<DriveFeedback> feedback) RT_SAFE override;
  void write_signals(const Signals& outputs) RT_SAFE override;
  [[nodiscard]] Signals read_signals() RT_SAFE override;
  [[nodiscard]] std::size_t read_vibration(std::size_t sensor, std::span<double> samples_um)
      RT_SAFE override;
  [[nodiscard]] BusStatus status() const override;

 private:
  // What crosses between cycle and bus thread for one axis.
  struct Boxes {
    Latest<DriveTarget> target;
    Latest<DriveFeedback> feedback;
    std::uint32_t sequence_seen = 0;  // of the cycle
    std::uint32_t age_cycles = 0;
  };

  // The requests of one drive: to look at it, to let it move, to stop it.
  struct Plans {
    std::vector<Request> look;
    std::vector<Request> run;
    std::vector<Request> stop;
  };

  // When a drive is asked, and how long it may take to answer.
  struct Asking {
    Patience patience;
    BusTime again_at{0};  // after a try that failed
  };

  // A vibration sensor: what is read, and what crosses to the cycle.
  struct Sensor {
    Sensor(const VibrationSensorConfig& config, BusTime timeout);

    SignalBlock block;
    VibrationReader reader;
    VibrationMeter meter;
    Ring<double> samples;
    std::uint64_t errors = 0;
    Asking asking;
  };

  void run(const std::stop_token& stop_requested);
  template <class Work>
  void without_end(const Work& work);
  void lose_contact(std::string_view reason);
  void poll_until(const std::stop_token& stop_requested);
  void take_leave();
  void poll_all();
  void ask_again();
  [[nodiscard]] bool is_asked_again(std::size_t axis) const;
  [[nodiscard]] BusTime next_turn(BusTime next_poll) const;
  void poll_one(std::size_t axis, TargetAge age);
  void poll_signals(TargetAge age);
  void poll_sensor(std::size_t sensor);
  [[nodiscard]] std::optional<ExchangeError> exchange(SignalBlock& block, Patience& patience);
  [[nodiscard]] std::optional<ExchangeError> exchange(std::size_t axis, TargetAge age);
  [[nodiscard]] std::optional<ExchangeError> carry_out(std::size_t axis,
                                                       std::span<const Request> plan);
  [[nodiscard]] bool ensure_connected();
  void note_answer(std::optional<ExchangeError> error, BusTime round_trip, Patience& patience);
  void back_off();
  void choose_silent_axis();
  [[nodiscard]] TargetAge target_age();
  [[nodiscard]] BusTime now() const;
  void publish_axis(std::size_t axis);
  void count_exchange(std::optional<ExchangeError> error, BusTime round_trip);

  // Configuration.
  BusConfig config_;
  BusTime poll_;
  BusTime timeout_;
  std::uint32_t timeout_cycles_;
  std::chrono::steady_clock::time_point epoch_;
  std::vector<AxisDriveConfig> drives_;

  // Shared with the cycle.
  std::vector<Boxes> boxes_;
  Latest<Signals> outputs_;
  Latest<Signals> inputs_;
  std::atomic<std::uint64_t> writes_{0};

  // These belong to the bus thread.
  std::unique_ptr<ModbusLink> link_;
  std::vector<AxisExchange> axes_;
  std::vector<Plans> plans_;
  std::vector<Asking> asking_;
  std::vector<Patience> signal_patience_;           // of each block
  std::vector<std::vector<std::uint16_t>> images_;  // registers of each drive, n at place n
  SignalExchange signals_;
  std::deque<Sensor> sensors_;  // rings stay where they are
  BusTime pause_{0};
  BusTime connect_again_at_{0};
  std::size_t silent_axis_ = 0;  // of those that do not answer, the one to be tried
  BusTime silent_again_at_{0};
  std::uint64_t writes_seen_ = 0;
  BusTime last_write_{0};

  // Shared with operators.
  mutable std::mutex status_mutex_;
  BusStatus status_;
  RoundTripHistogram round_trips_;

  std::mutex wait_mutex_;
  std::condition_variable_any wait_;
  std::jthread thread_;
};

}  // namespace stanok::drives
