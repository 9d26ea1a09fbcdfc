; channel table B
; The face of B about Y: B is a length beside Z. Arcs have K and I: from Z10 B0 about Z0 B0.
G12.1
; expect: transformation polar face B
; expect: request sync
G1 Z10 B0 F100
; expect: line Z10 B0 F100
G3 Z0 B10 K-10 I0
; expect: arc ccw zx centre 0,0 Z0 B10 F100
G13.1
; expect: transformation off
; expect: request sync
M30
; expect: end and rewind
