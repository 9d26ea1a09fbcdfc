; Smin, Smax and dl: dl at Smin, dl at Smax, and so on.
G1 X10 Smin=60 Smax=240 dl=0.5
; expect: law alternating S_n=60 S_k=240 dl=0.5 for the block
; expect: line X10 F60
#feedlaw (alternating, 240, 60, 0.25)
; expect: law alternating S_n=240 S_k=60 dl=0.25
X20
; expect: line X20 F240
M2
; expect: law off
; expect: end
