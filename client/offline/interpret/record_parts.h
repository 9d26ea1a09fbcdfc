// The pieces that the lines of `stanok interpret` are made of.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/enum_names.h"
#include "lang/contract/command.h"
#include "motion/path/path.h"

namespace stanok::client {

using Words = std::vector<std::string>;  // axis words of the channel

template <class... Arguments>
void append(std::string& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
}

// A JSON string: quotes, backslashes and control characters escaped.
void append_string(std::string& text, std::string_view value);
// An object of the axes' coordinates.
void append_axes(std::string& text, const Words& words, const lang::AxisValues& point);
inline constexpr auto spindle_action_names = enum_names<lang::SpindleAction>({
    {lang::SpindleAction::set_speed, "speed"},
    {lang::SpindleAction::clockwise, "clockwise"},
    {lang::SpindleAction::counter_clockwise, "counter_clockwise"},
    {lang::SpindleAction::stop, "stop"},
    {lang::SpindleAction::orient, "orient"},
});

}  // namespace stanok::client
