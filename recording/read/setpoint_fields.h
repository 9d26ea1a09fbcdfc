// The fields of setpoints by name, in the order in which arrays of setpoints are given: those of
// Python and of .npz files.
//
// A field of the axes is a row of as many numbers as the channel has axes.
#pragma once

#include <cstdint>
#include <stanok_messages/setpoint_t.hpp>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace stanok::recording {

struct SetpointField {
  template <class Number>
  using OfAxes = Number (setpoint_t::*)[8];
  struct Time {};  // s, from the first event of the log on: no field of the message
  using Source = std::variant<Time, double setpoint_t::*, std::int64_t setpoint_t::*,
                              std::int32_t setpoint_t::*, std::int16_t setpoint_t::*,
                              std::int8_t setpoint_t::*, OfAxes<double>, OfAxes<std::int64_t>>;

  std::string_view name;
  Source source;

  [[nodiscard]] bool is_of_axes() const {
    return std::holds_alternative<OfAxes<double>>(source) ||
           std::holds_alternative<OfAxes<std::int64_t>>(source);
  }
};

// The type of the numbers of an alternative of SetpointField::Source.
template <class Kind>
struct NumberOfSource;
template <>
struct NumberOfSource<SetpointField::Time> {
  using Type = double;
};
template <class Member>
struct NumberOfSource<Member setpoint_t::*> {
  using Type = std::remove_all_extents_t<Member>;
};

[[nodiscard]] const std::vector<SetpointField>& setpoint_fields();

// As many as the first setpoint of a channel says that there are.
[[nodiscard]] int axis_count_of(const setpoint_t& first);

}  // namespace stanok::recording
