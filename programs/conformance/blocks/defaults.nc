; Codes that are active at the start: motion 0, plane 17, distance 90, arc centre 91.1, feed mode 94,
; units 21, radius compensation 40, length 49, transformation 13.1, return level 98, scaling 50,
; work offset 54, path mode 64, spindle mode 97, diameter 8, rotation 69, polar input 15.
string codes = "";
for (num group = 1; group <= 17; group++) { codes = codes + str ($g[group]) + " "; }
msg (codes);
; expect: message 0 17 90 91.1 94 21 40 49 13.1 98 50 54 64 97 8 69 15 
M30
; expect: end and rewind
