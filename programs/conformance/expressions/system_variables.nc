; Programmed values are known at once: no request to the channel. `$tool_next` is what T prepared.
; channel two spindles
num at = $line;
string name = $program;
G0 X=at
; expect: rapid X3
msg (name + " " + str ($channel));
; expect: message main.nc 1
T3
; expect: prepare T3
X=$tool Y=$tool_next
; expect: rapid X0 Y3
M6
; expect: change T3
X=$tool Y=$tool_length Z=$tool_radius + $edge
; expect: rapid X3 Y30 Z2
S500 S2=900
; expect: spindle speed 500
; expect: spindle speed 900 $2
X=$speed Y=$speed[1] Z=$speed[2]
; expect: rapid X500 Y500 Z900
G91 G55 F250 G18
; expect: frame 2 X100 Y200 Z300 B0 C0
X=$g[2] Y=$g[3] Z=$g[12]
; expect: rapid X418 Y391 Z655
G90 G0 X1
; expect: rapid X1
X=$prog_pos[X] + 1 Y=$feed
; expect: rapid X2 Y250
X=$speed[3]
; expect error 30:3 E4053
M30
