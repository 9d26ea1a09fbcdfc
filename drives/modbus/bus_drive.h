// BusDrive: one drive on a bus: what is exchanged with it, in which requests, and when it is asked.
//
// A drive that has never answered is looked at before anything is written to it. No sockets, no
// clock: the bus carries the requests. Owned by the bus, on its thread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drives/modbus/axis_exchange.h"
#include "drives/modbus/patience.h"

namespace stanok::drives {

class BusDrive {
 public:
  BusDrive(const AxisDriveConfig& config, BusTime poll, BusTime timeout);

  // The requests that only look at the drive; empty: it has answered before.
  [[nodiscard]] std::span<const ModbusRequest> requests_to_look() const;
  // Those that bring it the target, which is then in the image.
  [[nodiscard]] std::span<const ModbusRequest> requests_for(const DriveTarget& target,
                                                            TargetAge age);
  // What the requests have brought, or the error that ended them.
  [[nodiscard]] std::optional<ExchangeError> take(std::optional<ExchangeError> error, BusTime asked,
                                                  BusTime now);

  // It missed the last answer, but is not given up.
  [[nodiscard]] bool is_asked_again() const {
    return !exchange_.contact().is_answering() && !exchange_.contact().is_lost();
  }
  [[nodiscard]] BusTime again_at() const { return again_at_; }
  void begin_try(BusTime now) { again_at_ = now + patience_.between_tries(); }

  [[nodiscard]] int unit() const { return config_.unit; }
  // Register n at place n.
  [[nodiscard]] std::span<std::uint16_t> image() { return image_; }
  [[nodiscard]] Patience& patience() { return patience_; }
  [[nodiscard]] AxisExchange& exchange() { return exchange_; }
  [[nodiscard]] const AxisExchange& exchange() const { return exchange_; }

 private:
  AxisDriveConfig config_;
  AxisExchange exchange_;
  std::vector<ModbusRequest> look_;
  std::vector<ModbusRequest> run_;   // to let it move
  std::vector<ModbusRequest> stop_;  // to stop it
  std::vector<std::uint16_t> image_;
  Patience patience_;
  BusTime again_at_{0};  // after a try that failed
};

}  // namespace stanok::drives
