// Texts as plain data, as they travel between operators, the cycle and the preparation of a
// channel.
#pragma once

#include "base/fixed_text.h"

namespace stanok::channels {

using ShortText = FixedText<256>;
using ReasonText = FixedText<1024>;  // of an answer: lines after the first are notes
using FileName = FixedText<96>;

}  // namespace stanok::channels
