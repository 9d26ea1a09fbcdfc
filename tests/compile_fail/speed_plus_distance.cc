// A speed cannot be added to a distance.
#include "base/units.h"

using namespace stanok;

#ifdef MUST_FAIL
auto sum = 300.0 * mm / minute + 5.0 * mm;
#else
auto sum = 300.0 * mm / minute + 5.0 * mm / second;
#endif
