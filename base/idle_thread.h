// A thread that runs when nothing else of the computer wants to (sched(7), SCHED_IDLE).
#pragma once

namespace stanok {

// The thread that calls it, from now on; where the system does not let it, it stays what it is.
void run_when_idle();

}  // namespace stanok
