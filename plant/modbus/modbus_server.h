// The simulated drives as a Modbus server, TCP or RTU, with its own thread.
//
// One unit id per drive, and unit 247 as the panel for fault injection (docs/integrator/drives.md).
// Sockets are polled here, requests are answered by libmodbus. Any number of clients; one that does
// not read its answers is dropped. An exception in the thread, as when memory ends, hangs up on all
// clients; the thread goes on.
#pragma once

#include <modbus/modbus.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "plant/drive/fault.h"
#include "plant/mechanics/plant_config.h"
#include "plant/modbus/drive_bank.h"

namespace stanok::plant {

struct ServerConfig {
  std::string host = "127.0.0.1";
  int port = 0;              // 0: any free one
  std::string rtu_device{};  // not empty: serve this serial line instead
  int baud = 115200;
  ModuleConfig modules{};
  double rate_hz = 1000.0;  // the drives move in steps of at most 1/rate
};

// The port or the serial line cannot be opened.
class ServerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class ModbusServer {
 public:
  ModbusServer(ServerConfig config, const std::vector<SimulatedDriveConfig>& drives);
  ~ModbusServer();
  ModbusServer(const ModbusServer&) = delete;
  ModbusServer& operator=(const ModbusServer&) = delete;

  // Throws ServerError. Started again after `stop` it has the same port.
  void start();
  void stop();

  // 0 before the first start and on a serial line.
  [[nodiscard]] int port() const { return config_.port; }

  // Drives in the order of the constructor. From one thread other than the server's.
  void inject(std::size_t drive, FaultKind kind) { bank_.inject(drive, kind); }
  void load(std::size_t drive, const ProcessLoad& load) RT_SAFE { bank_.load(drive, load); }

 private:
  struct Free {
    void operator()(modbus_t* context) const { modbus_free(context); }
  };

  // A request that waits for its late answer.
  struct LateAnswer {
    std::chrono::steady_clock::time_point due;
    int socket;
    std::vector<std::uint8_t> request;
  };

  enum class Connection : std::uint8_t { goes_on, ends };

  void listen();
  void open_serial_line();
  void run(const std::stop_token& stop_requested);
  void serve_until(const std::stop_token& stop_requested);
  void hang_up() noexcept;
  [[nodiscard]] int poll_timeout_ms() const;
  void accept_client();
  void drop(int socket);
  [[nodiscard]] Connection serve_client(int socket);
  void serve_serial_line();
  [[nodiscard]] Connection serve(int socket, std::vector<std::uint8_t> request);
  [[nodiscard]] Connection answer(int socket, const std::vector<std::uint8_t>& request);
  [[nodiscard]] Connection refuse_unknown_unit(int socket, std::vector<std::uint8_t> request);
  void answer_mangled(int socket, const std::vector<std::uint8_t>& request);
  void answer_late_ones();
  [[nodiscard]] bool is_serial() const { return !config_.rtu_device.empty(); }

  ServerConfig config_;
  DriveBank bank_;
  std::chrono::steady_clock::time_point epoch_;
  std::unique_ptr<modbus_t, Free> context_;
  int wake_ = -1;      // eventfd: stop was requested
  int listener_ = -1;  // or the serial line
  std::vector<int> clients_;
  std::vector<LateAnswer> late_;
  RtuRequestReader serial_requests_;
  std::jthread thread_;
};

}  // namespace stanok::plant
