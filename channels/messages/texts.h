// The texts that travel between a channel's preparation and its part of the cycle: plain data.
#pragma once

#include "base/fixed_text.h"

namespace stanok::channels {

using ShortText = FixedText<256>;
using ReasonText = FixedText<1024>;  // of an answer: lines after the first are notes
using FileName = FixedText<96>;

}  // namespace stanok::channels
