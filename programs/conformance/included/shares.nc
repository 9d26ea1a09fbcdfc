#include "shares.nc"
num local = 50;
G0 X=R5 Y=#100
R5=9
G91
