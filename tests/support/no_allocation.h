// NoAllocation: while a guard lives, every heap allocation of this thread fails the test.
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

}  // namespace stanok::testing
