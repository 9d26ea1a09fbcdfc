// Random programs through the whole chain (tests/support/chain): what `check` takes runs, what it
// refuses does not, and no axis ever passes a limit, whatever an operator does meanwhile.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/chain/chain_run.h"
#include "tests/support/sanitized.h"

namespace stanok::testing {
namespace {

// Of each machine; a thousand in all, but with sanitizers.
constexpr std::uint64_t programs = cases(334U);

// STANOK_CHAIN_PROGRAMS and STANOK_CHAIN_SEED make longer and other runs of the same test.
std::uint64_t from_environment(const char* variable, std::uint64_t value) {
  const char* const text = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe)
  return text == nullptr ? value : std::strtoull(text, nullptr, 10);
}

class WholeChain : public ::testing::TestWithParam<MachineKind> {};

TEST_P(WholeChain, RunsWhatCheckTakes) {
  const std::uint64_t first = from_environment("STANOK_CHAIN_SEED", 1);
  const std::uint64_t count = from_environment("STANOK_CHAIN_PROGRAMS", programs);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    SeededChoices choices(seed);
    const std::string program = random_program(GetParam(), choices);
    const std::string fault = chain_fault(GetParam(), program, choices);
    EXPECT_EQ(fault, "") << "seed " << seed << "\n" << program;
  }
}

std::string name_of(const ::testing::TestParamInfo<MachineKind>& info) {
  constexpr const char* names[] = {"ThreeAxes", "FiveAxes", "Lathe"};
  return names[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Machines, WholeChain,
                         ::testing::Values(MachineKind::three_axes, MachineKind::five_axes,
                                           MachineKind::lathe),
                         name_of);

}  // namespace
}  // namespace stanok::testing
