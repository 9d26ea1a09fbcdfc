; A line by its angle: one coordinate of the end and the angle from X.
G1 X10 ,A45 F300
; expect: line X10 Y10 F300
Y20 ,A90
; expect: line X10 Y20 F300
; A right triangle of 30 deg: 10 across is 10 / tan 30 along.
G91 Y-10 ,A-30
; expect: line X27.32050808 Y10 F300
G90 X10 ,A180
; expect: line X10 Y10 F300
Y0 ,A-90
; expect: line X10 Y0 F300
; The end of the first line is where it meets the second: a square on its corner.
,A45
X30 Y0 ,A-45
; expect: line X20 Y10 F300
; expect: line X30 Y0 F300
; With a rounding between them: tangent points at 2 from the corner, centre at 2 across.
,A90 ,R2
X50 Y10 ,A0
; expect: line X30 Y8 F300
; expect: arc cw xy centre 32,8 X32 Y10 F300
; expect: line X50 Y10 F300
; Directions are those of programmed coordinates: mirrored here.
G51.1 X0
G1 X-40 Y10
; expect: line X40 Y10 F300
X-30 ,A45
; expect: line X30 Y20 F300
G50.1 X0
M30
; expect: end and rewind
