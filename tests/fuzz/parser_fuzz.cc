// libFuzzer target: any bytes as a program to load, in a dialect by the first byte. It loads, or
// there are errors with places inside the text, at most 100 of them.
#include <cstdint>
#include <cstdlib>

#include "tests/fuzz/fuzzed_channel.h"

using namespace stanok;
using namespace stanok::lang;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fuzz::OneFile files(std::string(reinterpret_cast<const char*>(bytes), size));
  ChannelDescription channel = fuzz::mill();
  if (size > 0) channel.rules = fuzz::rules_of(bytes[0]);
  for (const ChannelDescription* one : {static_cast<const ChannelDescription*>(&channel),
                                        static_cast<const ChannelDescription*>(nullptr)}) {
    Diagnostics warnings;
    const auto program = compile("fuzz.nc", files, one, warnings);
    if (program) continue;
    constexpr std::size_t errors_max = 101;  // the last says that there are more
    const Diagnostics& errors = program.error();
    if (errors.empty() || errors.size() > errors_max) std::abort();
    for (const Diagnostic& error : errors) {
      if (error.code.empty() || error.place.line < 0 || to_text(error).empty()) std::abort();
    }
  }
  return 0;
}
