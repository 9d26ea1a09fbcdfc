// Pendant: what the events of an input device of Linux ask of the machine: a wheel moves the chosen
// axis by one step a notch, and keys choose axis and step, hold and resume.
//
// Each event has its time. What is older than a moment is dropped: whoever turned the wheel does
// not wait for it any more. Pure: reads no device and asks no machine.
#pragma once

#include <linux/input.h>

#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace stanok::client {

namespace pendant {

// What a key does when it goes down.
struct ChooseAxis {
  std::string axis;
};
struct ChooseStep {
  double step = 0.0;  // mm or deg
};
struct Hold {};
struct Resume {};
using KeyEffect = std::variant<ChooseAxis, ChooseStep, Hold, Resume>;

// "X", "step:0.1", "hold", "resume"; nothing: none of these.
[[nodiscard]] std::optional<KeyEffect> key_effect(std::string_view text);

// What the machine is asked for.
struct Turn {
  std::string axis;
  double way = 0.0;  // mm or deg

  friend bool operator==(const Turn&, const Turn&) = default;
};
using Order = std::variant<Turn, Hold, Resume>;

}  // namespace pendant

struct PendantSettings {
  std::string axis;                          // until a key chooses another one; empty: none
  double step = 0.01;                        // of a notch, mm or deg; the same
  std::map<int, pendant::KeyEffect> keys{};  // by the code of the key
};

class Pendant {
 public:
  explicit Pendant(PendantSettings settings) : settings_(std::move(settings)) {}

  // In their order, turns of one axis that follow each other as one. `now_s`: by the clock of the
  // events.
  [[nodiscard]] std::vector<pendant::Order> orders(std::span<const input_event> events,
                                                   double now_s);
  // Turns that came too late, and those without an axis.
  [[nodiscard]] int dropped() const { return dropped_; }

 private:
  void turn(int notches, std::vector<pendant::Order>& orders);
  void press(int code, std::vector<pendant::Order>& orders);

  PendantSettings settings_;
  int dropped_ = 0;
};

// "wheel 8 +1", "key 256 down"; empty for events of other kinds.
[[nodiscard]] std::string text_of(const input_event& event);

}  // namespace stanok::client
