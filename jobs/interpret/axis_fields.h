// What the records of a program have in common: coordinates by the words of their axes, names of
// spindle actions.
#pragma once

#include <string>
#include <vector>

#include "base/enum_names.h"
#include "base/fields.h"
#include "lang/contract/command.h"
#include "motion/path/path.h"

namespace stanok::jobs {

using Words = std::vector<std::string>;  // axis words of the channel

[[nodiscard]] Fields axis_fields(const Words& words, const lang::AxisValues& point);

inline constexpr auto spindle_action_names = enum_names<lang::SpindleAction>({
    {lang::SpindleAction::set_speed, "speed"},
    {lang::SpindleAction::clockwise, "clockwise"},
    {lang::SpindleAction::counter_clockwise, "counter_clockwise"},
    {lang::SpindleAction::stop, "stop"},
    {lang::SpindleAction::orient, "orient"},
});

}  // namespace stanok::jobs
