#include "daemon/host/real_time_rights.h"

#include <linux/capability.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "base/system_error.h"

namespace stanok::daemon {
namespace {

constexpr std::size_t stack_bytes_touched = 256U << 10;

bool has_capability(unsigned capability) {
  __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> sets{};
  if (syscall(SYS_capget, &header, sets.data()) != 0) return false;
  return (sets[CAP_TO_INDEX(capability)].effective & CAP_TO_MASK(capability)) != 0;
}

// With a limit, MCL_FUTURE would make later allocations of every thread fail instead of page.
bool may_lock_all_memory() {
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  return limit.rlim_cur == RLIM_INFINITY || has_capability(CAP_IPC_LOCK);
}

// Pages of the stack that the cycle will use are mapped now.
void touch_stack() {
  std::array<char, stack_bytes_touched> stack;  // NOLINT: written below
  volatile char* const bytes = stack.data();    // volatile: the writes are the purpose
  constexpr std::size_t page = 4096;
  for (std::size_t k = 0; k < stack.size(); k += page) bytes[k] = 0;
}

}  // namespace

RealTimeRights take_real_time_rights(int priority) {
  RealTimeRights rights;
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  rights.has_fifo_scheduling = error == 0;
  if (error != 0) {
    rights.notes.push_back("no FIFO scheduling (" + system_error_text(error) +
                           "): grant CAP_SYS_NICE or LimitRTPRIO");
  }
  if (!may_lock_all_memory()) {
    rights.notes.emplace_back("memory is not locked: grant CAP_IPC_LOCK or LimitMEMLOCK=infinity");
  } else if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    rights.notes.push_back("memory is not locked (" + system_error_text(errno) + ")");
  } else {
    rights.has_locked_memory = true;
  }
  touch_stack();
  return rights;
}

void prefer_this_thread(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  // Refused without the right to it; take_real_time_rights tells the operator so.
  static_cast<void>(pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters));
}

void be_ordinary_thread() {
  const sched_param parameters{};
  static_cast<void>(pthread_setschedparam(pthread_self(), SCHED_OTHER, &parameters));
}

FifoForNewThreads::FifoForNewThreads(int priority) {
  sched_param parameters{};
  pthread_getschedparam(pthread_self(), &policy_before_, &parameters);
  priority_before_ = parameters.sched_priority;
  prefer_this_thread(priority);
}

FifoForNewThreads::~FifoForNewThreads() {
  sched_param parameters{};
  parameters.sched_priority = priority_before_;
  pthread_setschedparam(pthread_self(), policy_before_, &parameters);
}

}  // namespace stanok::daemon
