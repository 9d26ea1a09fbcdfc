#tool_overhang (3)
M30
; expect error 1:1 E5012
