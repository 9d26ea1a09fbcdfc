// What owns memory does not cross into the real-time cycle through a Latest box.
#include <string>

#include "base/latest.h"

#ifdef MUST_FAIL
stanok::Latest<std::string> text;
#else
stanok::Latest<char> text;
#endif
