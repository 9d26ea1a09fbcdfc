// The check of programs as work of a library, and what is printed of it: the same whether the
// programs are checked by this process, by several, or by other computers.
#pragma once

#include "client/offline/library/library_run.h"
#include "client/offline/machine/job_options.h"

namespace stanok::client {

struct CheckWanted {
  JobOptions job;
  bool estimate = false;  // figures of feed laws instead of the summary
};

// Reads the machine file; throws what it throws.
[[nodiscard]] LibraryWork check_work(const CheckWanted& wanted);
[[nodiscard]] LibraryOutput check_output(const CheckWanted& wanted, ProgramsNamed named);

}  // namespace stanok::client
