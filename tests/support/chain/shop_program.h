// Random part programs as shops write them for Fanuc and Haas controls: drilling cycles and
// patterns, subprograms and macros with flow, corners, offsets, and on lathes the cycles of code
// system A.
#pragma once

#include <string>

#include "tests/support/chain/random_program.h"

namespace stanok::testing {

// For the mill with three axes and the lathe; not all programs are right.
[[nodiscard]] std::string random_shop_program(MachineKind machine, Choices& choices);

}  // namespace stanok::testing
