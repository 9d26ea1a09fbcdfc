// The position of a channel by its words, and where each of them comes from: the terms between the
// machine position and the word (runtime/display/word_steps.h), for people.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>

#include "daemon/cycle/running_machine.h"

namespace stanok::daemon {

enum class WordTerms : std::uint8_t { none, all };

// The result of channel.position. A term that changes nothing of an axis is left out there.
[[nodiscard]] nlohmann::json position_report(RunningMachine& machine, int channel, WordTerms terms);

}  // namespace stanok::daemon
