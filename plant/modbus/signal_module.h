// A simulated module of inputs and outputs: what is written to its coils and holding registers
// comes back in its discrete inputs and input registers of the same number, as if they were wired.
#pragma once

#include <modbus/modbus.h>

#include <memory>

namespace stanok::plant {

class SignalModule {
 public:
  explicit SignalModule(int unit);

  [[nodiscard]] int unit() const { return unit_; }
  // The four tables, with the inputs as the outputs are wired now.
  [[nodiscard]] modbus_mapping_t* registers();

 private:
  struct Unmap {
    void operator()(modbus_mapping_t* mapping) const { modbus_mapping_free(mapping); }
  };

  int unit_;
  std::unique_ptr<modbus_mapping_t, Unmap> registers_;
};

}  // namespace stanok::plant
