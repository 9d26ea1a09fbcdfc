// A bare number is no distance: it has to name its unit.
#include "base/units.h"

using namespace stanok;

#ifdef MUST_FAIL
Distance deviation = 0.01;
#else
Distance deviation = 0.01 * mm;
#endif
