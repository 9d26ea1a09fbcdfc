T1 M6
#tool_overhang (3, C)
M30
; expect: prepare T1
; expect: change T1
; expect error 2:1 E4306
