// Random part programs of everything that moves: lines, arcs, splines, threads, drilling cycles,
// feed laws, frames and modes, and moves that are tiny or none at all.
//
// Whatever decides comes through Choices: a seeded generator, or the bytes of a fuzzer. Programs
// stay well within the travel of the machines of MachineBench; not all of them are right. A third
// of those for the mill with three axes and the lathe are programs of shops (shop_program.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

#include "channels/contract/entry_limits.h"

namespace stanok::testing {

// Of a machine that takes what random lines write into its tables: touching off where the axes
// happen to stand makes lengths of either sign, and any value may be that of a wear.
inline constexpr channels::EntryLimits random_entries{.tool_length_min_mm = -500.0,
                                                      .wear_max_mm = 10.0};

class Choices {
 public:
  virtual ~Choices() = default;
  virtual double between(double low, double high) = 0;
  bool chance(double probability) { return between(0.0, 1.0) < probability; }
  std::size_t below(std::size_t count);
};

class SeededChoices final : public Choices {
 public:
  explicit SeededChoices(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) override {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }

 private:
  std::mt19937_64 engine_;
};

// Eight bits a choice; when they are used up a generator goes on that all of them seed.
class ChoicesOfBytes final : public Choices {
 public:
  ChoicesOfBytes(const std::uint8_t* bytes, std::size_t size);
  double between(double low, double high) override;

 private:
  const std::uint8_t* bytes_;
  std::size_t left_;
  SeededChoices then_;
};

enum class MachineKind { three_axes, five_axes, lathe };

[[nodiscard]] std::string random_program(MachineKind machine, Choices& choices);

}  // namespace stanok::testing
