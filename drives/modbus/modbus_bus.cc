// The bus thread: one round over all drives per poll, at absolute times, and between the rounds
// those again that did not answer.
#include "drives/modbus/modbus_bus.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "base/assert.h"
#include "base/place.h"

namespace stanok::drives {
ModbusBus::ModbusBus(const BusConfig& config, Duration cycle)
    : ModbusBus(config, cycle, std::make_unique<ModbusLink>(config)) {}

ModbusBus::ModbusBus(const BusConfig& config, Duration cycle, std::unique_ptr<ModbusLink> link)
    : poll_(std::chrono::milliseconds{config.poll_ms}),
      boxes_(drives_of(config).size(), config.timeout_ms * millisecond, cycle),
      status_(link->endpoint(), config),
      connection_(std::move(link), std::chrono::milliseconds{config.timeout_ms}),
      silent_turn_(std::chrono::milliseconds{config.timeout_ms}),
      target_watch_(std::chrono::milliseconds{config.timeout_ms}),
      signals_(config.signals, std::chrono::milliseconds{config.timeout_ms}) {
  STANOK_ASSERT(config.poll_ms > 0 && config.timeout_ms > 0 && cycle > Duration{});
  const BusTime timeout = std::chrono::milliseconds{config.timeout_ms};
  const std::vector<AxisDriveConfig> drives = drives_of(config);
  for (const AxisDriveConfig& drive : drives) drives_.emplace_back(drive, poll_, timeout);
  for (const VibrationSensorConfig& sensor : config.vibration_sensors) {
    const auto drive = std::ranges::find(drives, sensor.spindle, &AxisDriveConfig::spindle);
    sensors_.emplace_back(
        sensor, timeout,
        drive == drives.end() ? std::nullopt : std::optional(checked_size(drive - drives.begin())));
  }
}

ModbusBus::~ModbusBus() {
  stop();
}

void ModbusBus::start() {
  STANOK_ASSERT(!thread_.joinable());
  thread_ = std::jthread([this](const std::stop_token& stop_requested) { run(stop_requested); });
}

void ModbusBus::stop() {
  if (thread_.joinable()) {
    thread_.request_stop();
    thread_.join();
  }
}

void ModbusBus::write(std::span<const DriveTarget> targets) RT_SAFE {
  boxes_.write(targets, clock_.now());
}

void ModbusBus::read(std::span<DriveFeedback> feedback) RT_SAFE {
  boxes_.read(feedback);
}

void ModbusBus::write_signals(const Signals& outputs) RT_SAFE {
  boxes_.write_signals(outputs);
}

Signals ModbusBus::read_signals() RT_SAFE {
  return boxes_.read_signals();
}

std::size_t ModbusBus::read_vibration(std::size_t sensor, std::span<double> samples_um) RT_SAFE {
  return sensor < sensors_.size() ? sensors_[sensor].take_samples(samples_um) : 0;
}

std::optional<VibrationLevel> ModbusBus::read_vibration_level(std::size_t sensor) RT_SAFE {
  if (sensor >= sensors_.size()) return std::nullopt;
  return sensors_[sensor].level();
}

BusStatus ModbusBus::status() const {
  return status_.status();
}

// The root of the thread: nothing that happens here ends the process while axes move.
void ModbusBus::run(const std::stop_token& stop_requested) {
  while (!stop_requested.stop_requested()) {
    without_end([&] { poll_until(stop_requested); });
  }
  without_end([this] { take_leave(); });
  connection_.link().close();
}

template <class Work>
void ModbusBus::without_end(const Work& work) {
  try {
    work();
  } catch (const std::exception& fault) {
    lose_contact(fault.what());
  } catch (...) {
    lose_contact("an exception without a text");
  }
}

// As with a connection that breaks: the cycle sees at once that no drive answers, and the drives
// hear nothing until they are told to stop, or until their watchdogs stop them. Allocates nothing:
// memory may be what is missing.
void ModbusBus::lose_contact(std::string_view reason) {
  connection_.link().close();
  for (std::size_t place = 0; place < drives_.size(); ++place) {
    AxisExchange& exchange = drives_[place].exchange();
    exchange.lose_contact();
    boxes_.publish(place, exchange.feedback());
  }
  status_.tell_own_fault(reason);
  std::this_thread::sleep_for(poll_);  // a fault of every round takes no processor from others
}

void ModbusBus::poll_until(const std::stop_token& stop_requested) {
  BusTime next_poll = clock_.now();
  while (!stop_requested.stop_requested()) {
    if (clock_.now() >= next_poll) {
      poll_all();
      next_poll = std::max(next_poll + poll_, clock_.now());
    } else {
      ask_again();
    }
    std::unique_lock lock(wait_mutex_);
    wait_.wait_until(lock, stop_requested, clock_.at(next_turn(next_poll)), [] { return false; });
  }
}

// The drives are told to stop, and outputs fall.
void ModbusBus::take_leave() {
  for (std::size_t place = 0; place < drives_.size() && connection_.link().is_connected();
       ++place) {
    poll_one(place, TargetAge::stale);
  }
  poll_signals(TargetAge::stale);
}

void ModbusBus::poll_all() {
  const TargetAge age = target_age();
  const auto is_lost = [&](std::size_t place) {
    return drives_[place].exchange().contact().is_lost();
  };
  silent_turn_.choose(drives_.size(), is_lost);
  for (std::size_t place = 0; place < drives_.size(); ++place) {
    const bool is_turn = silent_turn_.is_turn_of(place, clock_.now());
    if (!is_lost(place) || is_turn) poll_one(place, age);
    judge(place);
  }
  poll_signals(age);
  for (std::size_t sensor = 0; sensor < sensors_.size(); ++sensor) poll_sensor(sensor);
}

// One missed answer costs a poll of 50 ms no more than one of 10 ms.
void ModbusBus::ask_again() {
  const TargetAge age = target_age();
  for (std::size_t place = 0; place < drives_.size(); ++place) {
    const BusDrive& drive = drives_[place];
    if (!drive.is_asked_again() || clock_.now() < drive.again_at()) continue;
    poll_one(place, age);
    judge(place);
  }
}

BusTime ModbusBus::next_turn(BusTime next_poll) const {
  BusTime next = next_poll;
  for (const BusDrive& drive : drives_) {
    if (drive.is_asked_again()) next = std::min(next, drive.again_at());
  }
  return next;
}

// Outputs fall when the cycle is silent.
void ModbusBus::poll_signals(TargetAge age) {
  const Signals outputs = boxes_.outputs();
  signals_.fill_outputs(age == TargetAge::fresh ? outputs : Signals{});
  for (std::size_t place = 0; place < signals_.blocks().size(); ++place) {
    SignalBlock& block = signals_.blocks()[place];
    if (!signals_.is_due(block, clock_.now()) || !ensure_connected()) continue;
    if (exchange(block, signals_.patience(place))) {
      signals_.fail(block, clock_.now());
    } else {
      signals_.take(block);
    }
    status_.count_signal_request();
  }
  boxes_.publish_inputs(signals_.inputs());
}

void ModbusBus::poll_sensor(std::size_t place) {
  BusSensor& sensor = sensors_[place];
  if (!sensor.is_due(clock_.now()) || !ensure_connected()) return;
  if (exchange(sensor.block(), sensor.patience())) {
    sensor.fail(clock_.now());
  } else {
    sensor.take(speed_at(sensor));
  }
  status_.tell_sensor(place, sensor);
}

// Measured, rev/min; 0: the drive of the spindle gives none.
double ModbusBus::speed_at(const BusSensor& sensor) const {
  if (!sensor.drive()) return 0.0;
  const DriveFeedback& feedback = drives_[*sensor.drive()].exchange().feedback();
  return feedback.valid ? feedback.velocity : 0.0;
}

std::optional<ExchangeError> ModbusBus::exchange(SignalBlock& block, Patience& patience) {
  connection_.link().wait_at_most(patience.for_next_answer());
  const BusTime begin = clock_.now();
  const auto error = connection_.link().exchange(block);
  note_answer(error, clock_.now() - begin, patience);
  return error;
}

void ModbusBus::note_answer(std::optional<ExchangeError> error, BusTime round_trip,
                            Patience& patience) {
  status_.count_exchange(error, round_trip);
  const bool is_answer = !error || *error == ExchangeError::exception;
  if (is_answer) connection_.note_answer();
  is_answer ? patience.note_answer(round_trip) : patience.note_silence();
}

void ModbusBus::poll_one(std::size_t place, TargetAge age) {
  BusDrive& drive = drives_[place];
  drive.begin_try(clock_.now());
  if (!ensure_connected()) return;
  const auto error = exchange(place, age);
  if (error && drive.exchange().contact().is_lost()) silent_turn_.note_silence(clock_.now());
}

std::optional<ExchangeError> ModbusBus::exchange(std::size_t place, TargetAge age) {
  BusDrive& drive = drives_[place];
  if (const auto requests = drive.requests_to_look(); !requests.empty()) {
    if (const auto error = carry_out(drive, requests)) return error;
  }
  return carry_out(drive, drive.requests_for(boxes_.target(place, clock_.now()), age));
}

std::optional<ExchangeError> ModbusBus::carry_out(BusDrive& drive,
                                                  std::span<const ModbusRequest> requests) {
  connection_.link().wait_at_most(drive.patience().for_next_answer());
  const BusTime begin = clock_.now();
  const auto sent = connection_.link().exchange(drive.unit(), requests, drive.image());
  const BusTime end = clock_.now();
  const auto error = drive.take(sent, begin, end);
  note_answer(error, end - begin, drive.patience());
  return error;
}

bool ModbusBus::ensure_connected() {
  status_.count_connection(connection_.ensure(clock_));
  return connection_.link().is_connected();
}

TargetAge ModbusBus::target_age() {
  return target_watch_.age(boxes_.writes(), clock_.now());
}

// Whether it is still in contact, for the cycle and for operators.
void ModbusBus::judge(std::size_t place) {
  AxisExchange& exchange = drives_[place].exchange();
  exchange.supervise(clock_.now());
  boxes_.publish(place, exchange.feedback());
  status_.set_connected(connection_.link().is_connected());
  status_.tell_drive(place, exchange);
}

}  // namespace stanok::drives
