(a library of other conformance programs)
const num SAFE_HEIGHT = 50;
num ramp (num from, num to, num part = 0.5) {
  return from + (to - from)*part;
}
log ("ramp");
M99
