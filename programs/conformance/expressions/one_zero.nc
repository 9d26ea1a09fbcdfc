; Sines and cosines of a half come back as whole angles, and there is one zero.
num none = 0;
msg (str (asin (0.5)));
; expect: message 30
msg (str (acos (-0.5)));
; expect: message 120
msg (str (-none) + " " + str (none*-3) + " " + str (round (-0.4)) + " " + str (-0.001, 2));
; expect: message 0 0 0 0.00
msg (str (atan2 (0, -none)));
; expect: message 0
#1=-0 #2=[0*-1]
msg (str (R5) + " " + str (-0));
; expect: message 0 0
M30
; expect: end and rewind
