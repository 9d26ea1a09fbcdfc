(a library of other conformance programs)
const num SAFE_HEIGHT = 50, HALF = 1/2;
num ramp (num from, num to, num part = HALF) {
  return from + (to - from)*part;
}
log ("ramp");
M99
