// A function of an acceleration does not take a speed.
#include "base/units.h"

using namespace stanok;

double in_g(Acceleration value) {
  return value / (9806.65 * mm / second / second);
}

#ifdef MUST_FAIL
double answer = in_g(100.0 * mm / second);
#else
double answer = in_g(100.0 * mm / second / second);
#endif
