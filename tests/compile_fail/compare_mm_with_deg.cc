// A distance is neither smaller nor greater than an angle.
#include "base/units.h"

using namespace stanok;

#ifdef MUST_FAIL
bool smaller = 1.0 * mm < 1.0 * degree;
#else
bool smaller = 1.0 * mm < 1.0 * inch;
#endif
