// What a run depends on besides the records of operators and sensors, to LCM messages and back.
#pragma once

#include <stanok_messages/arrival_t.hpp>
#include <stanok_messages/feedback_t.hpp>
#include <stanok_messages/program_read_t.hpp>
#include <string>

#include "channels/contract/output.h"
#include "recording/format/encode.h"

namespace stanok::recording {

// A program text that was asked for.
struct ProgramRead {
  std::string name{};
  std::string from{};  // path of the text that asks; empty: an operator
  std::string path{};  // where it was found
  std::string text{};
  bool found = false;
};

[[nodiscard]] arrival_t to_arrival(int channel, const channels::Arrivals& arrivals,
                                   const Stamp& stamp);
[[nodiscard]] feedback_t to_feedback(int channel, int axis, const channels::AxisFeedback& feedback,
                                     const Stamp& stamp);
[[nodiscard]] program_read_t to_program_read(const ProgramRead& read, const Stamp& stamp);

[[nodiscard]] channels::Arrivals from_arrival(const arrival_t& message);
[[nodiscard]] channels::AxisFeedback from_feedback(const feedback_t& message);

}  // namespace stanok::recording
