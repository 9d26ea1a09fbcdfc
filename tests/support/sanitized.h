// What tests do less of where a sanitizer makes a program five to ten times slower.
#pragma once

namespace stanok::testing {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;
#elif defined(__has_feature)
constexpr bool is_sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ||
                              __has_feature(realtime_sanitizer);
#else
constexpr bool is_sanitized = false;
#endif

// How many of so many random cases are looked at: all of them in a release, whose figures count; a
// tenth with a sanitizer, which looks at what the code does with memory and threads.
template <class Count>
[[nodiscard]] constexpr Count cases(Count count) {
  return is_sanitized ? (count + 9) / 10 : count;
}

}  // namespace stanok::testing
