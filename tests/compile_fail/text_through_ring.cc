// What owns memory does not cross into the real-time cycle through a Ring.
#include <string>

#include "base/ring.h"

#ifdef MUST_FAIL
stanok::Ring<std::string> texts(8);
#else
stanok::Ring<char> texts(8);
#endif
