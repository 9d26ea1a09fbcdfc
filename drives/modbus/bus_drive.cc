#include "drives/modbus/bus_drive.h"

#include "base/place.h"

namespace stanok::drives {

BusDrive::BusDrive(const AxisDriveConfig& config, BusTime poll, BusTime timeout)
    : config_(config),
      exchange_(config, poll, timeout),
      look_(look_plan(config)),
      run_(exchange_plan(config, WriteOrder::target_first)),
      stop_(exchange_plan(config, WriteOrder::control_word_first)),
      image_(checked_size(register_count(config.map))),
      patience_(timeout) {}

std::span<const ModbusRequest> BusDrive::requests_to_look() const {
  return exchange_.has_answered() ? std::span<const ModbusRequest>{} : look_;
}

std::span<const ModbusRequest> BusDrive::requests_for(const DriveTarget& target, TargetAge age) {
  write_block(config_.map, exchange_.command(target, age), image_);
  return exchange_.write_order() == WriteOrder::target_first ? run_ : stop_;
}

std::optional<ExchangeError> BusDrive::take(std::optional<ExchangeError> error, BusTime asked,
                                            BusTime now) {
  if (!error) return exchange_.take(status_block(config_.map, image_), asked, now);
  exchange_.fail(*error);
  return error;
}

}  // namespace stanok::drives
