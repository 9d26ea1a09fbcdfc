// What gives the words of a channel their meaning as an LCM message.
#pragma once

#include <stanok_messages/situation_t.hpp>

#include "channels/contract/output.h"
#include "channels/contract/reports.h"
#include "recording/format/encode.h"

namespace stanok::recording {

// `situation` is the one with the number that the output shows.
[[nodiscard]] situation_t to_situation(const channels::ChannelOutput& output,
                                       const channels::SituationReport& situation,
                                       const Stamp& stamp);

}  // namespace stanok::recording
