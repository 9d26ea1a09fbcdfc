; Holes of a circle, a line and a grid with the cycle that is active.
#include "mill/patterns.nc"
G0 X0 Y0 Z2 F100
; expect: rapid X0 Y0 Z2
G99 G81 Z-5 R2 L0
hole_circle (10, 90, 2);
; expect: rapid X0 Y10
; expect: line Z-5 F100
; expect: rapid Z2
; expect: rapid X0 Y-10
; expect: line Z-5 F100
; expect: rapid Z2
hole_line (5, 0, 2);
; expect: rapid X0 Y-10
; expect: line Z-5 F100
; expect: rapid Z2
; expect: rapid X5 Y-10
; expect: line Z-5 F100
; expect: rapid Z2
hole_grid (4, 2, 3, 2);
; expect: rapid X5 Y-10
; expect: line Z-5 F100
; expect: rapid Z2
; expect: rapid X9 Y-10
; expect: line Z-5 F100
; expect: rapid Z2
; expect: rapid X9 Y-7
; expect: line Z-5 F100
; expect: rapid Z2
; expect: rapid X5 Y-7
; expect: line Z-5 F100
; expect: rapid Z2
G80
M30
; expect: end and rewind
