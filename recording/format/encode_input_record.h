// Records of operators, signals and sensors to LCM messages and back. Pure functions; every record
// comes back as it was.
#pragma once

#include <stanok_messages/input_t.hpp>

#include "channels/contract/input_record.h"
#include "recording/format/encode.h"

namespace stanok::recording {

[[nodiscard]] input_t to_input(const channels::InputRecord& record, const Stamp& stamp);
// UnknownInput where this version does not know what the message has: logs may come from anywhere.
[[nodiscard]] channels::InputRecord from_input(const input_t& message);

}  // namespace stanok::recording
