#include "base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace stanok {

void assertion_failed(const char* claim, const char* file, int line) noexcept {
  std::fprintf(stderr, "%s:%d: broken claim: %s\n", file, line, claim);
  std::abort();
}

}  // namespace stanok
