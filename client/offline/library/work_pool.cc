#include "client/offline/library/work_pool.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "base/file_descriptor.h"

namespace stanok::client {
namespace {

// What passes between the processes: an index to the worker, a length and so many bytes back. With
// `threw` in the length the bytes are those of an exception.
using Word = std::uint64_t;
constexpr Word threw = Word{1} << 63U;

bool send_all(int descriptor, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = ::send(descriptor, bytes, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int descriptor, char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t got = ::recv(descriptor, bytes, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

// The life of a worker: it ends with the process that asks it.
[[noreturn]] void serve(int descriptor, const PoolCalls& calls) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN);  // of the terminal: who asks ends the workers
  std::signal(SIGTERM, SIG_DFL);
  Word index = 0;
  while (receive_all(descriptor, reinterpret_cast<char*>(&index), sizeof(index))) {
    std::string result;
    Word size = 0;
    try {
      result = calls.work(static_cast<std::size_t>(index));
    } catch (const std::exception& exception) {
      result = exception.what();
      size = threw;
    }
    size |= result.size();
    if (!send_all(descriptor, reinterpret_cast<const char*>(&size), sizeof(size)) ||
        !send_all(descriptor, result.data(), result.size()))
      break;
  }
  ::_exit(0);
}

std::string death_of(int status) {
  if (!WIFSIGNALED(status)) return "it ended with exit code " + std::to_string(WEXITSTATUS(status));
  const char* const name = ::sigdescr_np(WTERMSIG(status));
  return "it was ended by signal " + std::to_string(WTERMSIG(status)) +
         (name == nullptr ? "" : " (" + std::string(name) + ")");
}

// A process that works, as seen by the one that asks it.
class Worker {
 public:
  explicit Worker(const PoolCalls& calls, const std::vector<std::unique_ptr<Worker>>& others) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
      throw std::system_error(errno, std::generic_category(), "socketpair");
    process_ = ::fork();
    if (process_ == 0) {
      ::close(ends[0]);
      for (const auto& other : others) ::close(other->descriptor());
      serve(ends[1], calls);
    }
    ::close(ends[1]);
    socket_ = std::make_unique<FileDescriptor>(ends[0]);
    if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  }
  ~Worker() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    wait();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  [[nodiscard]] int descriptor() const { return socket_->number(); }
  [[nodiscard]] const std::optional<std::size_t>& piece() const { return piece_; }

  void give(std::size_t index) {
    piece_ = index;
    const Word word = index;
    // A worker that is dead is found by what it does not answer.
    static_cast<void>(send_all(descriptor(), reinterpret_cast<const char*>(&word), sizeof(word)));
  }

  // Reads what has come: the whole of a result, or nothing yet. `is_over`: nothing comes any more.
  std::optional<std::string> read(bool& is_over) {
    std::array<char, 1 << 16> part;
    const ssize_t count = ::recv(descriptor(), part.data(), part.size(), MSG_DONTWAIT);
    if (count > 0) bytes_.append(part.data(), static_cast<std::size_t>(count));
    is_over = count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR);
    Word size = 0;
    if (bytes_.size() < sizeof(size)) return std::nullopt;
    std::memcpy(&size, bytes_.data(), sizeof(size));
    if (bytes_.size() < sizeof(size) + (size & ~threw)) return std::nullopt;
    std::string result = bytes_.substr(sizeof(size));
    if ((size & threw) != 0) throw std::runtime_error(result);
    bytes_.clear();
    piece_.reset();
    return result;
  }

  // Waits for its end.
  std::string wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return death_of(status);
  }

 private:
  pid_t process_ = 0;
  std::unique_ptr<FileDescriptor> socket_;
  std::optional<std::size_t> piece_;  // that it is at
  std::string bytes_;                 // of its result, so far
};

class Pool {
 public:
  Pool(std::size_t count, const PoolCalls& calls) : count_(count), calls_(calls) {}

  bool run(int processes) {
    const auto wanted = std::min(count_, static_cast<std::size_t>(std::max(processes, 1)));
    for (std::size_t k = 0; k < wanted; ++k) add_worker();
    while (taken_ < count_) {
      if (calls_.gives_up()) return false;
      wait_for_results();
    }
    return true;
  }

 private:
  void add_worker() {
    auto worker = std::make_unique<Worker>(calls_, workers_);
    if (next_ < count_) worker->give(next_++);
    workers_.push_back(std::move(worker));
  }

  void wait_for_results() {
    constexpr int look_ms = 200;
    std::vector<pollfd> places;
    places.reserve(workers_.size());
    for (const auto& worker : workers_) places.push_back({worker->descriptor(), POLLIN, 0});
    if (::poll(places.data(), places.size(), look_ms) <= 0) return;
    for (std::size_t k = places.size(); k > 0; --k) {
      if (places[k - 1].revents != 0) hear(k - 1);
    }
    pass_on();
  }

  void hear(std::size_t place) {
    Worker& worker = *workers_[place];
    const auto piece = worker.piece();
    bool is_over = false;
    auto result = worker.read(is_over);
    if (result && piece) {
      done_[*piece] = {std::move(*result), ""};
      if (next_ < count_) worker.give(next_++);
    }
    if (is_over) replace(place);
  }

  void replace(std::size_t place) {
    const auto piece = workers_[place]->piece();
    const std::string death = workers_[place]->wait();
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(place));
    if (piece) done_[*piece] = {"", death};
    if (next_ < count_) add_worker();
  }

  void pass_on() {
    calls_.progress(taken_ + done_.size());
    for (auto first = done_.begin(); first != done_.end() && first->first == taken_;
         first = done_.erase(first)) {
      calls_.take(first->first, std::move(first->second));
      ++taken_;
    }
  }

  std::size_t count_;
  const PoolCalls& calls_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::map<std::size_t, PieceResult> done_;  // that wait for those before them
  std::size_t next_ = 0;                     // to be given
  std::size_t taken_ = 0;
};

}  // namespace

bool do_in_processes(std::size_t count, int processes, const PoolCalls& calls) {
  return Pool(count, calls).run(processes);
}

}  // namespace stanok::client
