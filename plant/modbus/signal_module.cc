// The wires of a module.
#include "plant/modbus/signal_module.h"

#include <algorithm>

#include "base/assert.h"

namespace stanok::plant {
namespace {

constexpr int size = 1024;  // of each table

}  // namespace

SignalModule::SignalModule(int unit)
    : unit_(unit), registers_(modbus_mapping_new(size, size, size, size)) {
  STANOK_ASSERT(registers_ != nullptr);
}

modbus_mapping_t* SignalModule::registers() {
  std::copy_n(registers_->tab_bits, size, registers_->tab_input_bits);
  std::copy_n(registers_->tab_registers, size, registers_->tab_input_registers);
  return registers_.get();
}

}  // namespace stanok::plant
