G0 X10
DlgMsg "ready?" "X" 100
; expect error 2:1 E2042
G1 X20 F100
