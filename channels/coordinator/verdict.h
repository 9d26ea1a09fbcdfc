// Verdict: how what was asked of the coordinator stands after a step: pending, done, or refused
// with a code of the catalogue and a sentence.
#pragma once

#include <string_view>

#include "base/fixed_text.h"
#include "base/rt_safe.h"
#include "channels/messages/item.h"

namespace stanok::channels {

struct Verdict {
  bool done = true;
  bool ok = true;
  bool raises = false;  // lang::Answer
  double number = 0.0;
  FixedText<8> code;
  ReasonText text;
};

[[nodiscard]] Verdict pending() RT_SAFE;
[[nodiscard]] Verdict success(double number = 0.0) RT_SAFE;
[[nodiscard]] Verdict refusal(std::string_view code, std::string_view text) RT_SAFE;
// "channel 2 <claim>"
[[nodiscard]] Verdict refusal_of(int channel, std::string_view code, std::string_view claim)
    RT_SAFE;

}  // namespace stanok::channels
