// libFuzzer target: bytes are the choices of a random program and of the operator of its run
// (tests/support/chain); the first one chooses the machine. What check takes runs, what it refuses
// does not, limits are kept.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/support/chain/chain_run.h"

using namespace stanok::testing;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  constexpr MachineKind machines[] = {MachineKind::three_axes, MachineKind::five_axes,
                                      MachineKind::lathe};
  const MachineKind machine = machines[bytes[0] % 3];
  ChoicesOfBytes choices(bytes + 1, size - 1);
  const std::string program = random_program(machine, choices);
  const std::string fault = chain_fault(machine, program, choices);
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n%s\n", fault.c_str(), program.c_str());
  std::abort();
}
