// Drives on Modbus TCP or RTU: a thread exchanges targets and feedback with every drive, the
// signals of programs and the samples of vibration sensors each poll.
//
// Per drive and poll one request with function code 23 where its register map allows it, else as
// few as possible. A drive that does not answer is asked again as soon as its patience says, while
// the others are asked at their polls. What is sent and what is believed is decided in
// AxisExchange, each drive with its requests is a BusDrive; the other parts stand in their headers
// beside this one. When the cycle writes no targets for the timeout the drives are stopped.
// An exception in the bus thread is a loss of contact with every drive; the thread goes on.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#include "base/units.h"
#include "drives/bus.h"
#include "drives/bus_config.h"
#include "drives/modbus/bus_clock.h"
#include "drives/modbus/bus_connection.h"
#include "drives/modbus/bus_drive.h"
#include "drives/modbus/bus_sensor.h"
#include "drives/modbus/cycle_boxes.h"
#include "drives/modbus/signal_exchange.h"
#include "drives/modbus/silent_turn.h"
#include "drives/modbus/status_board.h"
#include "drives/modbus/target_watch.h"

namespace stanok::drives {

class ModbusBus final : public DriveBus {
 public:
  // `cycle`: period of read and write.
  ModbusBus(const BusConfig& config, Duration cycle);
  // Over a link of the caller's.
  ModbusBus(const BusConfig& config, Duration cycle, std::unique_ptr<ModbusLink> link);
  ~ModbusBus() override;

  void start() override;
  void stop() override;
  void write(std::span<const DriveTarget> targets) RT_SAFE override;
  void read(std::span<DriveFeedback> feedback) RT_SAFE override;
  void write_signals(const Signals& outputs) RT_SAFE override;
  [[nodiscard]] Signals read_signals() RT_SAFE override;
  [[nodiscard]] std::size_t read_vibration(std::size_t sensor, std::span<double> samples_um)
      RT_SAFE override;
  [[nodiscard]] std::optional<VibrationLevel> read_vibration_level(std::size_t sensor)
      RT_SAFE override;
  [[nodiscard]] BusStatus status() const override;

 private:
  void run(const std::stop_token& stop_requested);
  template <class Work>
  void without_end(const Work& work);
  void lose_contact(std::string_view reason);
  void poll_until(const std::stop_token& stop_requested);
  void take_leave();
  void poll_all();
  void ask_again();
  [[nodiscard]] BusTime next_turn(BusTime next_poll) const;
  void poll_one(std::size_t place, TargetAge age);
  void poll_signals(TargetAge age);
  void poll_sensor(std::size_t place);
  [[nodiscard]] double speed_at(const BusSensor& sensor) const;
  [[nodiscard]] std::optional<ExchangeError> exchange(SignalBlock& block, Patience& patience);
  [[nodiscard]] std::optional<ExchangeError> exchange(std::size_t place, TargetAge age);
  [[nodiscard]] std::optional<ExchangeError> carry_out(BusDrive& drive,
                                                       std::span<const ModbusRequest> requests);
  [[nodiscard]] bool ensure_connected();
  void note_answer(std::optional<ExchangeError> error, BusTime round_trip, Patience& patience);
  [[nodiscard]] TargetAge target_age();
  void judge(std::size_t place);

  BusClock clock_;
  BusTime poll_;
  CycleBoxes boxes_;    // shared with the cycle
  StatusBoard status_;  // shared with operators

  // These belong to the bus thread.
  BusConnection connection_;
  std::vector<BusDrive> drives_;
  SilentTurn silent_turn_;
  TargetWatch target_watch_;
  SignalExchange signals_;
  std::deque<BusSensor> sensors_;  // rings stay where they are

  std::mutex wait_mutex_;
  std::condition_variable_any wait_;
  std::jthread thread_;
};

}  // namespace stanok::drives
