; #feedlaw says in one line what a block of addresses says.
num steps = 4;
G1 F50
#feedlaw (linear, 60, 0.1, -0.05)
; expect: law linear S_n=60 dS=-0.1 dl=0.05
#FEEDLAW (Modulated, 30, 0.5, 0.2, steps * 2);
; expect: law modulated S_n=30 S_k=34 dS=0.5 dl=0.2 n_s=8
/#feedlaw (interrupt, 0.4, 2)
; expect: law interrupted L_A=0.4 L_B=2
S500 M3
; expect: spindle speed 500
; expect: spindle clockwise 500
#feedlaw (speed, 500, -2, 60, 0.1, 0.05)
; expect: law linear S_n=60 dS=0.1 dl=0.05 n_n=500 step -2
#feedlaw (cutting_speed, 120, 0.5, 60, 0.1, 0.05)
; expect: law linear S_n=60 dS=0.1 dl=0.05 v_n=120 step 0.5
num ways[3] = {0, 10, 30};
num feeds[] = {60, 80.5, 40};
num speeds[3] = {500, 600, 700};
#feedlaw (curve, ways, feeds)
; expect: law curve S_n=60 (0 60 0) (10 80.5 0) (30 40 0)
if (true) {
#feedlaw (curve, ways, feeds, speeds)
}
; expect: law curve S_n=60 n_n=500 (0 60 500) (10 80.5 600) (30 40 700)
X5
; expect: line X5 F60
#feedlaw (off)
; expect: law off
X6
; expect: line X6 F50
M5
; expect: spindle stop 500
M30
; expect: end and rewind
