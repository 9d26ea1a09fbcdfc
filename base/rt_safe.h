// RT_SAFE marks every function that the real-time cycle can reach.
//
// Such a function neither allocates, locks, throws, logs, touches files nor loops without a bound.
// With clang (>= 20) the attribute makes the compiler prove it (-Wfunction-effects) and the
// RealtimeSanitizer check it at run time; with other compilers it is noexcept and a word to the
// reader.
#pragma once

#if defined(__clang__) && __has_cpp_attribute(clang::nonblocking)
#define RT_SAFE noexcept [[clang::nonblocking]]
#else
#define RT_SAFE noexcept
#endif
