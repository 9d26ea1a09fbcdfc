// BusConnection: the link of a bus, made again when it is broken.
//
// At once after an error, and where it cannot be made with growing pauses up to a second, until
// somebody answers. Owned by the bus, on its thread.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "drives/modbus/bus_clock.h"
#include "drives/modbus/modbus_link.h"

namespace stanok::drives {

class BusConnection {
 public:
  enum class Try : std::uint8_t { stands, made, failed, not_yet };

  BusConnection(std::unique_ptr<ModbusLink> link, BusTime timeout)
      : link_(std::move(link)), timeout_(timeout) {}

  [[nodiscard]] ModbusLink& link() { return *link_; }
  [[nodiscard]] const ModbusLink& link() const { return *link_; }

  // Makes the connection where it is missing and the pause is over.
  [[nodiscard]] Try ensure(const BusClock& clock);
  void note_answer() { pause_ = BusTime{0}; }

 private:
  std::unique_ptr<ModbusLink> link_;
  BusTime timeout_;
  BusTime pause_{0};
  BusTime again_at_{0};
};

}  // namespace stanok::drives
