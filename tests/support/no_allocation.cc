#include "tests/support/no_allocation.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

namespace {
thread_local bool guarded = false;
thread_local long allocations = 0;

void* counted(std::size_t size) {
  if (guarded) ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) {
  return counted(size);
}
void* operator new[](std::size_t size) {
  return counted(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace stanok::testing {

NoAllocation::NoAllocation() {
  allocations = 0;
  guarded = true;
}

NoAllocation::~NoAllocation() {
  guarded = false;
  EXPECT_EQ(allocations, 0) << "the heap was used where the real-time cycle must not";
}

long NoAllocation::count() {
  return allocations;
}

}  // namespace stanok::testing
