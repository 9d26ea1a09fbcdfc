#include "client/operator/pendant.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace stanok::client {
namespace {

constexpr double too_late_s = 0.3;
constexpr std::array<int, 4> wheels{REL_WHEEL, REL_HWHEEL, REL_DIAL, REL_MISC};

bool is_turn(const input_event& event) {
  if (event.type != EV_REL || event.value == 0) return false;
  for (const int wheel : wheels)
    if (event.code == wheel) return true;
  return false;
}

// 0: up, 1: down, 2: repeated while it is held.
bool is_press(const input_event& event) {
  return event.type == EV_KEY && event.value == 1;
}

double time_of(const input_event& event) {
  return static_cast<double>(event.input_event_sec) +
         1e-6 * static_cast<double>(event.input_event_usec);
}

}  // namespace

std::optional<pendant::KeyEffect> pendant::key_effect(std::string_view text) {
  constexpr std::string_view step_word = "step:";
  if (text == "hold") return Hold{};
  if (text == "resume") return Resume{};
  if (!text.starts_with(step_word)) {
    if (text.empty()) return std::nullopt;
    return ChooseAxis{std::string(text)};
  }
  text.remove_prefix(step_word.size());
  double step = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), step);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !(step > 0.0))
    return std::nullopt;
  return ChooseStep{step};
}

std::vector<pendant::Order> Pendant::orders(std::span<const input_event> events, double now_s) {
  std::vector<pendant::Order> orders;
  for (const input_event& event : events) {
    if (is_press(event)) press(event.code, orders);
    if (!is_turn(event)) continue;
    if (settings_.axis.empty() || now_s - time_of(event) > too_late_s) {
      ++dropped_;
    } else {
      turn(event.value, orders);
    }
  }
  return orders;
}

void Pendant::turn(int notches, std::vector<pendant::Order>& orders) {
  const double way = notches * settings_.step;
  auto* const last = orders.empty() ? nullptr : std::get_if<pendant::Turn>(&orders.back());
  if (last != nullptr && last->axis == settings_.axis) {
    last->way += way;
  } else {
    orders.emplace_back(pendant::Turn{.axis = settings_.axis, .way = way});
  }
}

void Pendant::press(int code, std::vector<pendant::Order>& orders) {
  const auto found = settings_.keys.find(code);
  if (found == settings_.keys.end()) return;
  if (const auto* axis = std::get_if<pendant::ChooseAxis>(&found->second))
    settings_.axis = axis->axis;
  if (const auto* step = std::get_if<pendant::ChooseStep>(&found->second))
    settings_.step = step->step;
  if (std::holds_alternative<pendant::Hold>(found->second)) orders.emplace_back(pendant::Hold{});
  if (std::holds_alternative<pendant::Resume>(found->second))
    orders.emplace_back(pendant::Resume{});
}

std::string text_of(const input_event& event) {
  if (is_turn(event)) return fmt::format("wheel {} {:+}", event.code, event.value);
  if (event.type == EV_KEY && event.value < 2)
    return fmt::format("key {} {}", event.code, event.value == 1 ? "down" : "up");
  return "";
}

}  // namespace stanok::client
