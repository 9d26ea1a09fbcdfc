// Progress: what one bounded step of a preparation came to.
#pragma once

namespace stanok::channels {

// blocked: waits for the cycle. computing: it might go on for ever, nothing of what was done is for
// the cycle; a clock that waits for the preparations goes on after a while.
enum class Progress { worked, computing, blocked };

}  // namespace stanok::channels
