#include "tests/support/no_allocation.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
thread_local bool guarded = false;
thread_local long allocations = 0;

std::atomic<bool> memory_is_short = false;
std::atomic<long> refusals = 0;
thread_local bool has_memory = false;

void* counted_or_null(std::size_t size) noexcept {
  if (guarded) ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void* counted(std::size_t size) {
  if (memory_is_short && !has_memory) {
    ++refusals;
    throw std::bad_alloc();
  }
  if (void* memory = counted_or_null(size)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) {
  return counted(size);
}
void* operator new[](std::size_t size) {
  return counted(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return counted_or_null(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return counted_or_null(size);
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

NoMemoryElsewhere::NoMemoryElsewhere() {
  refusals = 0;
  has_memory = true;
  memory_is_short = true;
}

NoMemoryElsewhere::~NoMemoryElsewhere() {
  memory_is_short = false;
  has_memory = false;
}

long NoMemoryElsewhere::count() {
  return refusals;
}

}  // namespace stanok::testing
