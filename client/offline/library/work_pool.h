// WorkPool: pieces of work done by processes of their own, several at a time.
//
// What a piece gives comes back as bytes, in the order of the pieces, whichever ends first. A
// process that dies takes the piece with it that it was at, and nothing else: another one takes its
// place. Thread: one, and the process has no other while the pool is made or runs (fork(2)).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace stanok::client {

// What became of a piece.
struct PieceResult {
  std::string bytes;
  std::string death;  // why its process ended before it was done; empty: it was done
};

struct PoolCalls {
  // Does piece `index`, in a process of its own.
  std::function<std::string(std::size_t index)> work;
  // Called with every piece, in their order.
  std::function<void(std::size_t index, PieceResult result)> take;
  // Called whenever a piece is done.
  std::function<void(std::size_t done)> progress;
  // Asked often; true: what runs is ended, and nothing more is taken.
  std::function<bool()> gives_up;
};

// Does all pieces from 0 to `count` with so many processes. False: given up. Throws
// std::system_error where no process can be made, and std::runtime_error with the words of what
// `work` threw: then nothing more is done.
[[nodiscard]] bool do_in_processes(std::size_t count, int processes, const PoolCalls& calls);

}  // namespace stanok::client
