// NoAllocation: while a guard lives, every heap allocation of this thread fails the test.
// NoMemoryElsewhere: while it lives, every heap allocation of every other thread throws.
#pragma once

namespace stanok::testing {

class NoAllocation {
 public:
  NoAllocation();
  ~NoAllocation();  // reports the number of allocations as a test failure when it is not 0
  NoAllocation(const NoAllocation&) = delete;
  NoAllocation& operator=(const NoAllocation&) = delete;

  [[nodiscard]] static long count();  // allocations since the guard began
};

class NoMemoryElsewhere {
 public:
  NoMemoryElsewhere();
  ~NoMemoryElsewhere();
  NoMemoryElsewhere(const NoMemoryElsewhere&) = delete;
  NoMemoryElsewhere& operator=(const NoMemoryElsewhere&) = delete;

  [[nodiscard]] static long count();  // allocations refused since it began
};

}  // namespace stanok::testing
