// In which order the registers of a drive are written, for every place that the control word can
// have beside the target: a server of libmodbus that notes each register as it comes.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <modbus/modbus.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "drives/cia402.h"
#include "drives/modbus/modbus_bus.h"

namespace stanok::drives {
namespace {

constexpr double stands_at_mm = 1.25;
constexpr double start_of_the_file_mm = 120.0;

// One register that was written, and what the drive did then.
struct Write {
  int address = 0;
  bool is_control_word = false;
  bool is_target = false;
  bool enables = false;
  bool stops = false;
  double target_mm = 0.0;  // in the registers after this write
  double actual_mm = 0.0;
  DriveState state = DriveState::switch_on_disabled;  // before this write
  std::size_t request = 0;
};

// The harshest drive: it acts on every single register at once, in the order in which they come,
// and jumps to its target while it is on.
class NotingDrive {
 public:
  explicit NotingDrive(const RegisterMap& map)
      : map_(map), mapping_(modbus_mapping_new(0, 0, register_count(map), 0)) {
    context_ = modbus_new_tcp("127.0.0.1", 0);
    listener_ = modbus_tcp_listen(context_, 1);
    report();
    thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
  }
  ~NotingDrive() {
    thread_.request_stop();
    thread_.join();
    close(listener_);
    modbus_close(context_);
    modbus_free(context_);
    modbus_mapping_free(mapping_);
  }
  NotingDrive(const NotingDrive&) = delete;
  NotingDrive& operator=(const NotingDrive&) = delete;

  [[nodiscard]] int port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    EXPECT_EQ(getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    return ntohs(address.sin_port);
  }
  [[nodiscard]] std::vector<Write> writes() const {
    const std::scoped_lock lock(mutex_);
    return writes_;
  }
  [[nodiscard]] std::size_t reads_before_the_first_write() const {
    const std::scoped_lock lock(mutex_);
    return reads_first_;
  }
  // Switches itself off, as a drive does whose power is interrupted.
  void drop_out() {
    const std::scoped_lock lock(mutex_);
    state_ = DriveState::switch_on_disabled;
    report();
  }

 private:
  std::span<std::uint16_t> registers() {
    return {mapping_->tab_registers, static_cast<std::size_t>(mapping_->nb_registers)};
  }

  void report() {
    write_field(map_.status_word, state_bits(state_), registers());
    write_field(map_.position, *map_.position.increments(actual_mm_), registers());
  }

  void serve(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      pollfd waiting{.fd = listener_, .events = POLLIN, .revents = 0};
      if (::poll(&waiting, 1, 10) != 1) continue;
      int server = listener_;
      modbus_tcp_accept(context_, &server);
      answer_all(stop);
      modbus_close(context_);
    }
  }

  void answer_all(const std::stop_token& stop) {
    std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> query{};
    while (!stop.stop_requested()) {
      pollfd waiting{.fd = modbus_get_socket(context_), .events = POLLIN, .revents = 0};
      if (::poll(&waiting, 1, 10) != 1) continue;
      const int length = modbus_receive(context_, query.data());
      if (length < 0) return;
      const std::scoped_lock lock(mutex_);
      take(query);
      modbus_reply(context_, query.data(), length, mapping_);
      // What the reply has written once more is the same; the status is the drive's own.
      report();
    }
  }

  static int word(const std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH>& query,
                  std::size_t at) {
    return query[at] << 8 | query[at + 1];
  }

  // Functions 6, 16 and 23, behind the header of seven bytes.
  void take(const std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH>& query) {
    constexpr std::size_t pdu = 7;
    ++requests_;
    const int function = query[pdu];
    if (function == 3) {
      if (writes_.empty()) ++reads_first_;
    } else if (function == 6) {
      take(word(query, pdu + 1), word(query, pdu + 3));
    } else {
      const std::size_t begin = function == 23 ? pdu + 5 : pdu + 1;
      for (int k = 0; k < word(query, begin + 2); ++k)
        take(word(query, begin) + k, word(query, begin + 5 + 2 * static_cast<std::size_t>(k)));
    }
    report();
  }

  void take(int address, int value) {
    registers()[static_cast<std::size_t>(address)] = static_cast<std::uint16_t>(value);
    const RegisterField& target = map_.target_position;
    Write write{.address = address,
                .is_control_word = address == map_.control_word.address,
                .is_target = address >= target.address && address < target.end(),
                .target_mm = target.value(read_field(target, registers())),
                .actual_mm = actual_mm_,
                .state = state_,
                .request = requests_};
    if (write.is_control_word) {
      const DriveState next = after(value & 0x0F);
      write.enables = next == DriveState::operation_enabled && state_ != next;
      write.stops = state_ == DriveState::operation_enabled && next != state_;
      state_ = next;
    }
    if (state_ == DriveState::operation_enabled) actual_mm_ = write.target_mm;
    writes_.push_back(write);
  }

  [[nodiscard]] DriveState after(int command) const {
    switch (command) {
      case 0x06:
        return DriveState::ready_to_switch_on;
      case 0x07:
        return DriveState::switched_on;
      case 0x0F:
        return state_ == DriveState::switched_on ? DriveState::operation_enabled : state_;
      default:
        return DriveState::switch_on_disabled;
    }
  }

  RegisterMap map_;
  modbus_mapping_t* mapping_;
  modbus_t* context_ = nullptr;
  int listener_ = -1;
  mutable std::mutex mutex_;
  std::vector<Write> writes_;
  std::size_t requests_ = 0;
  std::size_t reads_first_ = 0;
  DriveState state_ = DriveState::switch_on_disabled;
  double actual_mm_ = stands_at_mm;
  std::jthread thread_;
};

struct Split {
  const char* name;
  int control_word;  // the target stands at 20
  int words;
  RequestStyle style;
};

AxisDriveConfig drive_of(const Split& split) {
  const bool is_long = split.words == 2;
  const double scale = is_long ? 1000.0 : 100.0;
  AxisDriveConfig drive{
      .axis = "X", .unit = 1, .map = {}, .requests = split.style, .velocity_max = 1e6};
  drive.map.control_word = {.address = split.control_word};
  drive.map.target_position = {
      .address = 20, .words = split.words, .is_signed = true, .scale = scale};
  drive.map.target_velocity = {
      .address = 30, .words = split.words, .is_signed = true, .scale = scale};
  drive.map.status_word = {.address = 100};
  drive.map.position = {.address = 101, .words = 2, .scale = 1000.0};
  return drive;
}

class WriteOrderOnTheBus : public ::testing::TestWithParam<Split> {
 protected:
  WriteOrderOnTheBus() { bus.start(); }

  bool until(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{60};
    while (std::chrono::steady_clock::now() < end) {
      bus.write({&target, 1});
      bus.read({&feedback, 1});
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return false;
  }
  // Polls of the drive, each answered.
  bool polls(std::uint32_t count) {
    const std::uint32_t begin = feedback.sequence;
    return until([&] { return feedback.sequence >= begin + count; });
  }
  bool switch_on() {
    if (!polls(1)) return false;
    target = {.position = feedback.position, .enabled = true, .brake_closed = false};
    return until([&] { return feedback.state == DriveState::operation_enabled; });
  }

  AxisDriveConfig config = drive_of(GetParam());
  NotingDrive drive{config.map};
  ModbusBus bus{{.kind = BusKind::modbus_tcp,
                 .port = drive.port(),
                 .poll_ms = 1,
                 .timeout_ms = 5000,
                 .axes = {config}},
                1.0 * millisecond};
  DriveTarget target{.position = start_of_the_file_mm};
  DriveFeedback feedback;
};

TEST_P(WriteOrderOnTheBus, WhileItIsOffTheTargetIsWhereTheDriveStands) {
  ASSERT_TRUE(polls(20));
  ASSERT_TRUE(switch_on());
  EXPECT_GT(drive.reads_before_the_first_write(), 0U) << "the drive was written before it was read";
  bool target_written = false;
  for (const Write& write : drive.writes()) {
    target_written |= write.is_target;
    if (write.enables) {
      EXPECT_TRUE(target_written) << "enabled before its target was written";
      EXPECT_NEAR(write.target_mm, write.actual_mm, config.following_error_max);
    }
    if (!write.is_control_word) continue;
    if (target_written) {
      EXPECT_NEAR(write.target_mm, stands_at_mm, 1e-9);
    }
    target_written = false;
  }
  EXPECT_NEAR(feedback.position, stands_at_mm, 1e-9);
}

TEST_P(WriteOrderOnTheBus, IsNotEnabledForATargetThatIsElsewhere) {
  target = {.position = stands_at_mm + 1.0, .enabled = true, .brake_closed = false};
  ASSERT_TRUE(polls(50));
  for (const Write& write : drive.writes()) EXPECT_FALSE(write.enables);
  EXPECT_NE(feedback.state, DriveState::operation_enabled);
  EXPECT_NEAR(feedback.position, stands_at_mm, 1e-9);
  target.position = stands_at_mm;
  EXPECT_TRUE(until([&] { return feedback.state == DriveState::operation_enabled; }));
}

TEST_P(WriteOrderOnTheBus, StopsBeforeAnythingElseIsWritten) {
  ASSERT_TRUE(switch_on());
  target.position += 0.25;
  ASSERT_TRUE(until([&] { return std::abs(feedback.position - stands_at_mm - 0.25) < 1e-9; }));
  target.enabled = false;
  ASSERT_TRUE(until([&] { return feedback.state != DriveState::operation_enabled; }));
  const std::vector<Write> writes = drive.writes();
  const auto stop = std::ranges::find_if(writes, &Write::stops);
  ASSERT_NE(stop, writes.end());
  const auto runs = std::find_if(std::make_reverse_iterator(stop), writes.rend(),
                                 [](const Write& write) { return write.is_control_word; });
  ASSERT_NE(runs, writes.rend());
  for (auto between = runs.base(); between != stop; ++between) {
    EXPECT_TRUE(between->request == stop->request || between->request == runs->request)
        << "register " << between->address << " was written before the stop";
  }
}

TEST_P(WriteOrderOnTheBus, ADriveThatDroppedOutIsNotEnabledAgainByItself) {
  ASSERT_TRUE(switch_on());
  drive.drop_out();
  ASSERT_TRUE(until([&] { return feedback.state != DriveState::operation_enabled; }));
  const std::size_t before = drive.writes().size();
  ASSERT_TRUE(polls(30));
  const std::vector<Write> writes = drive.writes();
  for (std::size_t k = before; k < writes.size(); ++k) EXPECT_FALSE(writes[k].enables);
  target.enabled = false;
  ASSERT_TRUE(polls(3));
  target.enabled = true;
  EXPECT_TRUE(until([&] { return feedback.state == DriveState::operation_enabled; }));
}

std::vector<Split> splits() {
  std::vector<Split> all;
  struct Named {
    const char* name;
    int control_word;
    int words;
  };
  constexpr std::array<Named, 12> places = {{{"short_right_before", 19, 1},
                                             {"short_right_behind", 21, 1},
                                             {"short_before", 16, 1},
                                             {"short_behind", 25, 1},
                                             {"short_far_before", 0, 1},
                                             {"short_far_behind", 90, 1},
                                             {"long_right_before", 19, 2},
                                             {"long_right_behind", 22, 2},
                                             {"long_before", 16, 2},
                                             {"long_behind", 25, 2},
                                             {"long_far_before", 0, 2},
                                             {"long_far_behind", 90, 2}}};
  for (const RequestStyle style :
       {RequestStyle::write_and_read, RequestStyle::write_multiple, RequestStyle::write_single}) {
    for (const Named& place : places) {
      if (style == RequestStyle::write_single && place.words == 2) continue;  // would be torn
      all.push_back({place.name, place.control_word, place.words, style});
    }
  }
  return all;
}

std::string split_name(const ::testing::TestParamInfo<Split>& one) {
  constexpr std::array<const char*, 3> styles = {"fc23", "fc16", "fc06"};
  return std::string(one.param.name) + "_" + styles[static_cast<std::size_t>(one.param.style)];
}

INSTANTIATE_TEST_SUITE_P(Splits, WriteOrderOnTheBus, ::testing::ValuesIn(splits()), split_name);

}  // namespace
}  // namespace stanok::drives
