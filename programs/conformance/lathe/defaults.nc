; channel lathe
; On a lathe channel the plane is ZX, the feed per revolution and X a diameter.
string codes = "";
for (num group = 1; group <= 17; group++) { codes = codes + str ($g[group]) + " "; }
msg (codes);
; expect: message 0 18 90 91.1 95 21 40 49 13.1 98 50 54 64 97 7 69 15 
M30
; expect: end and rewind
